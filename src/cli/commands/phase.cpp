// polhode phase: the Montgomery phase, unwrapped, with its regime.

#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/options/body_option.hpp"
#include "cli/options/memory_limit.hpp"
#include "cli/options/motion_option.hpp"
#include "cli/options/options.hpp"
#include "cli/options/time_limit.hpp"
#include "cli/output/exact_decimals.hpp"
#include "cli/output/json_document.hpp"
#include "cli/output/progress.hpp"
#include "cli/output/streams.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"
#include "uncertain_effects.hpp"

namespace polhode::cli {
namespace phase_impl {
namespace {

struct phase_options {
  body_option which;
  std::optional<std::string> c;
  bool excess = false;
  bool parts = false;
  digits_option digits;
  format_option format{{"text", "json"}};
  memory_limit_option memory_limit;
  time_limit_option time_limit;
};

/// Numbers that the regime does not have are missing.
struct answer {
  body_kind kind;
  rational c;
  regime motion;
  std::optional<ball> phase;
  std::optional<ball> bound;
  std::optional<ball> excess;
  std::optional<ball> period;
  std::optional<ball> dynamic;
  std::optional<ball> geometric;
};

answer answer_of(const phase_options& options, const body& rigid, const rational& c, long digits) {
  answer result{rigid.kind(), c, regime_of(rigid, c), {}, {}, {}, {}, {}, {}};
  if (result.motion == regime::separatrix) return result;
  if (is_periodic(result.motion)) {
    result.phase = certain(montgomery_phase_to_digits(rigid, c, digits), "the phase", digits);
    if (options.excess) {
      result.excess =
          certain(montgomery_phase_excess_to_digits(rigid, c, digits), "the excess", digits);
    }
    if (options.parts) {
      result.period = certain(rotation_period_to_digits(rigid, c, digits), "the period", digits);
      result.dynamic =
          certain(dynamic_phase_to_digits(rigid, c, digits), "the dynamic part", digits);
      result.geometric =
          certain(geometric_phase_to_digits(rigid, c, digits), "the geometric part", digits);
    }
  }
  result.bound = certain(montgomery_phase_limit_to_digits(rigid, c, digits), "the bound", digits);
  return result;
}

/// "2 pi I"
const char* bound_formula(regime r) { return is_about_x(r) ? "2 pi I" : "2 pi J"; }

std::string remark_on(regime r) {
  if (r == regime::separatrix) return "the phase is infinite";
  return is_equilibrium(r) ? "the angular momentum does not move in the body: there is no phase, "
                             "but a limit for c towards this end"
                           : "";
}

std::string text_of(const answer& a, long digits) {
  std::string result;
  if (a.phase) result += fmt::format("phase = {}\n", to_decimal(*a.phase, digits));
  result += to_text(a.motion);
  if (!is_periodic(a.motion)) result += ": " + remark_on(a.motion);
  result += '\n';
  if (a.bound) {
    result += fmt::format("{} {} = {}\n", is_periodic(a.motion) ? "greatest lower bound" : "limit",
                          bound_formula(a.motion), to_decimal(*a.bound, digits));
  }
  if (a.period) {
    result += fmt::format("dynamic part (1 + c) T = {}\n", to_decimal(*a.dynamic, digits));
    result += fmt::format("geometric part = {}\n", to_decimal(*a.geometric, digits));
    result += fmt::format("period T = {} I_y/J\n", to_decimal(*a.period, digits));
  }
  if (a.excess) result += fmt::format("above it by {}\n", to_decimal(*a.excess, digits));
  if (a.kind == body_kind::non_physical) result += described(a.kind) + '\n';
  return result;
}

std::string json_of(const answer& a, long digits) {
  json result{{"c", exact_json(a.c, digits)},
              {"regime", to_text(a.motion)},
              {"kind", to_text(a.kind)},
              {"verdict", to_text(status::certified)}};
  result["phase"] = a.phase ? to_json(*a.phase, digits) : json(nullptr);
  if (!is_periodic(a.motion)) result["remark"] = remark_on(a.motion);
  if (a.bound) {
    result[is_periodic(a.motion) ? "greatest_lower_bound" : "limit"] = to_json(*a.bound, digits);
  }
  if (a.period) {
    result["dynamic"] = to_json(*a.dynamic, digits);
    result["geometric"] = to_json(*a.geometric, digits);
    result["period"] = to_json(*a.period, digits);
  }
  if (a.excess) result["excess"] = to_json(*a.excess, digits);
  return json_document_text("phase", result);
}

exit_status run(const phase_options& options) {
  const long digits = options.digits.value();
  const bool json_wanted = options.format.value() == "json";
  if (const auto uncertain = options.which.uncertain()) {
    if (options.excess) {
      throw usage_error("--excess: it is not enclosed for moments with uncertainties");
    }
    if (!options.c) throw usage_error("there is no motion; give --c C, from -b to a");
    return print_effects({.moments = *uncertain,
                          .c = read_number("--c", *options.c),
                          .want = R"("period", "montgomery_phase")",
                          .digits = digits,
                          .seconds = options.time_limit.limit()},
                         json_wanted);
  }
  const body rigid = options.which.value();
  if (!options.c) throw usage_error("there is no motion; give --c C, from -b to a");
  const rational c = read_motion(*options.c, rigid);
  constexpr double bytes_per_digit = 40;  // measured at 10^6 digits: 33
  const std::string what = fmt::format("{} digits of the phase", digits);
  options.memory_limit.check({what, bytes_per_digit * static_cast<double>(digits)});
  const answer a = [&] {
    const progress line;
    line.show("computing the phase");
    line.expect(options.time_limit.check(
        what, digits, {[&](long fewer) { (void)answer_of(options, rigid, c, fewer); }}));
    const time_watch watch(options.time_limit.limit());
    return answer_of(options, rigid, c, digits);
  }();
  print(json_wanted ? json_of(a, digits) : text_of(a, digits));
  return exit_status::all_certified;
}

std::function<exit_status()> declare(CLI::App& app) {
  const auto options = std::make_shared<phase_options>();
  options->which.declare(app);
  add_option(app, "--c", options->c,
             "The motion: c = 2 I_y H/J^2 - 1, from -b to a; oscillating below 0,\n"
             "rotating above")
      .type_name("C");
  add_flag(app, "--excess", options->excess,
           "Print by how much the phase is above its greatest lower bound, too");
  add_flag(app, "--parts", options->parts,
           "Print its dynamic and its geometric part, and the period in time, too");
  options->digits.declare(app);
  options->format.declare(app);
  options->memory_limit.declare(app);
  options->time_limit.declare(app);
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace phase_impl

command phase_command() {
  return {
      "phase", "Compute the Montgomery phase of a free rotation, unwrapped",
      "  polhode phase --ab 12.65,0.0629 --c -0.03\n"
      "  polhode phase --ab 12.65,0.0629 --c -1e-300 --digits 100\n"
      "  polhode phase --moments 3,2,1 --c 1/2 --excess --format json\n"
      "  polhode phase --tensor 2,3,4,0.1,0,-0.2 --c 0.3\n"
      "  polhode phase --moments 3.2±0.01,2,1.5±0.01 --c 0.1\n\n"
      "The phase is the angle in radians by which the body has turned about its angular momentum "
      "when\n"
      "that has gone once around in the body; it is not taken modulo 2 pi. Its greatest lower "
      "bound\n"
      "over all c is 2 pi I where the body oscillates and 2 pi J where it rotates (see `polhode "
      "body`).\n"
      "On the separatrix, c = 0, it is infinite. Of moments with uncertainties the report is that "
      "of\n"
      "`polhode scene`, with the range of each number.\n",
      phase_impl::declare};
}

}  // namespace polhode::cli
