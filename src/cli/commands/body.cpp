// polhode body: what kind of body it is, and its two geometric constants.

#include "polhode/rigid_body/body.hpp"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "body_links.hpp"
#include "cli/commands.hpp"
#include "cli/options/body_option.hpp"
#include "cli/options/memory_limit.hpp"
#include "cli/options/options.hpp"
#include "cli/output/exact_decimals.hpp"
#include "cli/output/json_document.hpp"
#include "cli/output/streams.hpp"
#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/arithmetic/verdict.hpp"
#include "polhode/rigid_body/inertia_tensor.hpp"
#include "polhode/scene/link_inertias.hpp"

namespace polhode::cli {
namespace body_impl {
namespace {

struct body_options {
  body_option which;
  std::optional<std::string> robot;
  bool allow_non_physical = false;
  bool nearest = false;
  std::optional<std::string> sigma;
  digits_option digits;
  format_option format{{"text", "json", "csv"}};
  memory_limit_option memory_limit;
};

constexpr std::array axis_names{"x", "y", "z"};
constexpr std::array moment_names{"I_x", "I_y", "I_z"};

/// One of the body's numbers: a rational, or an enclosure of it, or of its range where the moments
/// have ranges.
struct number {
  const char* symbol;
  const char* name;
  std::optional<rational> exact;
  ball enclosure;
  bool is_range = false;
};

std::string as_text(const number& n, long digits) {
  if (n.exact) {
    return fmt::format("{} = {} exactly\n", n.symbol,
                       is_short(*n.exact, digits) ? to_text(*n.exact)
                                                  : with_dots(leading_digits_of(*n.exact, digits)));
  }
  if (!n.is_range) return fmt::format("{} = {}\n", n.symbol, to_decimal(n.enclosure, digits));
  const decimal_enclosure d = to_decimal_enclosure(n.enclosure, digits);
  return fmt::format("{} from {} to {}\n", n.symbol, d.lower, d.upper);
}

json as_json(const number& n, long digits) {
  return n.exact ? exact_json(*n.exact, digits) : to_json(n.enclosure, digits);
}

/// Guard bits that suffice for I and J: their squares (that of J + 1) are quotients q/r of 3
/// size_in_bits(a) + 3 size_in_bits(b) bits at most and a few, and a decimal d of k digits that
/// such a root is not differs from it by at least some 1/(r 100^k).
precision sufficient_guard(const body& rigid, long digits) {
  return 8 * (size_in_bits(rigid.a()) + size_in_bits(rigid.b())) + ample_guard(digits);
}

/// Either rational or enclosed to so many digits.
number certain(const char* symbol, const char* name, std::optional<rational> exact,
               const enclosing_function& f, long digits, precision most_guard) {
  number result{symbol, name, std::move(exact), {}};
  if (result.exact) return result;
  result.enclosure = enclose_to_digits(f, digits, most_guard);
  if (result.enclosure.is_undefined()) {
    throw not_certified_error(
        fmt::format("{} was not certified to {} digits (precision limit)", symbol, digits));
  }
  return result;
}

/// What is printed: the moments where they were given, the axes where they were reordered, the
/// numbers.
struct answer {
  std::vector<number> moments;  // I_x, I_y, I_z, or none
  std::array<int, 3> order{0, 1, 2};
  bool has_order = false;  // of the moments given
  bool is_ordered = true;
  bool is_uncertain = false;
  std::vector<number> numbers;
  body_kind kind = body_kind::undecided;
  std::optional<nearest_physical_tensor> nearest;
};

answer answer_of(const body& rigid, long digits) {
  answer result;
  const precision guard = sufficient_guard(rigid, digits);
  const auto& tensor = rigid.irrational_tensor();
  for (std::size_t i = 0; i < 3 && (rigid.moments() || tensor); ++i) {
    result.moments.push_back(certain(
        moment_names[i], axis_names[i],
        tensor ? tensor->exact_moments()[i] : std::optional((*rigid.moments())[i]),
        [&](precision p) { return tensor->moments(p)[i]; }, digits, guard));
  }
  result.has_order = rigid.moments().has_value();
  result.order = rigid.order();
  result.kind = rigid.kind();
  const auto add = [&](const char* symbol, const char* name, std::optional<rational> exact,
                       const enclosing_function& f) {
    result.numbers.push_back(certain(symbol, name, std::move(exact), f, digits, guard));
  };
  add("a", "a", rigid.a().as_rational(), [&](precision p) { return rigid.a().at(p); });
  add("b", "b", rigid.b().as_rational(), [&](precision p) { return rigid.b().at(p); });
  add("I", "geometric_constant", rigid.exact_geometric_constant(),
      [&](precision p) { return rigid.geometric_constant(p); });
  add("J", "second_geometric_constant", rigid.exact_second_geometric_constant(),
      [&](precision p) { return rigid.second_geometric_constant(p); });
  return result;
}

answer answer_of(const uncertain_body& rigid, long digits) {
  const precision p = bits_for_digits(digits) + 32;
  answer result;
  result.has_order = true;
  result.order = rigid.order();
  result.is_ordered = rigid.is_ordered();
  result.is_uncertain = true;
  result.kind = rigid.kind();
  if (!rigid.is_ordered()) return result;
  result.numbers = {
      {"a", "a", {}, rigid.a(p), true},
      {"b", "b", {}, rigid.b(p), true},
      {"I", "geometric_constant", {}, rigid.geometric_constant(p), true},
      {"J", "second_geometric_constant", {}, rigid.second_geometric_constant(p), true}};
  return result;
}

std::string text_of(const answer& a, long digits) {
  std::string result;
  for (const number& moment : a.moments) result += as_text(moment, digits);
  if (!a.is_ordered) {
    result += "the order of the axes is undecided, and so are a, b, I and J\n";
  } else if (a.order != std::array<int, 3>{0, 1, 2}) {
    constexpr std::array places{"1st", "2nd", "3rd"};
    const auto place = [&](int axis) {
      return places[static_cast<std::size_t>(a.order[static_cast<std::size_t>(axis)])];
    };
    result += fmt::format("reordered: I_x, I_y, I_z are the {}, {}, {} of the moments given\n",
                          place(0), place(1), place(2));
  }
  for (const number& n : a.numbers) result += as_text(n, digits);
  if (a.is_uncertain && a.kind != body_kind::undecided) {
    return result + to_text(a.kind) + ": all within these ranges\n";
  }
  result += described(a.kind) + '\n';
  return a.nearest ? result + nearest_text(*a.nearest, digits) : result;
}

std::string json_of(const answer& a, long digits) {
  const bool decided = a.kind != body_kind::undecided;
  json result{{"kind", to_text(a.kind)},
              {"verdict", to_text(decided ? status::certified : status::not_certified)}};
  for (const number& moment : a.moments) result["moments"][moment.name] = as_json(moment, digits);
  if (a.is_ordered && a.has_order) {
    // Of I_x, I_y, I_z, which of the moments given it is.
    for (const int given : a.order) result["order"].push_back(given + 1);
  }
  for (const number& n : a.numbers) result[n.name] = as_json(n, digits);
  if (a.nearest) result["nearest"] = nearest_json(*a.nearest, digits);
  return json_document_text("body", result);
}

bool is_given(const body_option& which) {
  return which.ab || which.moments || which.rotational || which.tensor || which.file;
}

/// Of all links.
exit_status run_links(const body_options& options, long digits) {
  if (is_given(options.which) || options.sigma) {
    throw usage_error("FILE has all its bodies; give no other");
  }
  if (!is_robot_file(*options.robot)) {
    throw usage_error(
        fmt::format("{}: it must be a .urdf, .sdf, .xml or .mjcf file; a JSON body is "
                    "--body FILE",
                    in_quotes(*options.robot)));
  }
  return print_links(*options.robot,
                     {options.format.value(), digits, options.allow_non_physical, options.nearest});
}

exit_status run(const body_options& options) {
  const long digits = options.digits.value();
  const bool json_wanted = options.format.value() == "json";
  constexpr double bytes_per_digit = 20;
  options.memory_limit.check(
      {fmt::format("{} digits of I and J", digits), bytes_per_digit * static_cast<double>(digits)});
  if (options.robot) return run_links(options, digits);
  if (options.format.value() == "csv" || options.allow_non_physical) {
    throw usage_error("--format csv and --allow-non-physical are for a robot's FILE");
  }
  const auto uncertain = options.which.uncertain(options.sigma);
  answer a = uncertain ? answer_of(uncertain_body(*uncertain), digits)
                       : answer_of(options.which.value(), digits);
  if (options.nearest) {
    const auto tensor = options.which.tensor_entries();
    if (!tensor || uncertain)
      throw usage_error("--nearest is of one body by --tensor, --moments or --body, or of a robot");
    a.nearest = nearest_physical(principal_axes(*tensor));
  }
  print(json_wanted ? json_of(a, digits) : text_of(a, digits));
  return a.kind == body_kind::undecided ? exit_status::not_certified : exit_status::all_certified;
}

std::function<exit_status()> declare(CLI::App& app) {
  const auto options = std::make_shared<body_options>();
  add_option(app, "FILE", options->robot,
             "A robot: every link of a URDF, SDF or MuJoCo file, in kg m^2")
      .type_name("");
  add_flag(app, "--allow-non-physical", options->allow_non_physical,
           "Exit with status 0 where links are non-physical, too");
  add_flag(app, "--nearest", options->nearest,
           "Of what is non-physical, the nearest physical tensor in the Frobenius norm");
  options->which.declare(app);
  add_option(app, "--sigma", options->sigma,
             "How far each moment may be from the one given with --moments")
      .type_name("SX,SY,SZ");
  options->digits.declare(app);
  options->format.declare(app);
  options->memory_limit.declare(app);
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace body_impl

command body_command() {
  return {
      "body", "Say what kind of body it is: physical, planar or non-physical",
      "  polhode body --ab 12.65,0.0629\n"
      "  polhode body --moments 3,2,1\n"
      "  polhode body --moments 3.01±0.1,2,1±0.05\n"
      "  polhode body --tensor 2,3,4,0.1,0,-0.2\n"
      "  polhode body --tensor 5,2,1,0.1,0,-0.2 --nearest\n"
      "  polhode body --body scenes/robot_arm.urdf#forearm\n"
      "  polhode body scenes/robot_arm.urdf --format csv\n\n"
      "Numbers are decimals or quotients (629/10000), read exactly; the kind is decided without\n"
      "rounding. I = (1-b)/sqrt(b(a+b)) and J = (a+1)/sqrt(a(a+b)) - 1 are the paper's geometric\n"
      "constants. With ± beside a moment, or --sigma, every moment within value - sigma ..\n"
      "value + sigma is meant: the kind is that of all such bodies, or undecided (exit status 1). "
      "The\n"
      "principal moments of a tensor may be irrational: they are enclosed, and the kind is decided "
      "all\n"
      "the same. Of a robot's file every\n"
      "link is listed, with the margin I_y + I_z - I_x of the triangle inequality, to 4 digits in "
      "text and\n"
      "to --digits N in csv and json; the exit status is 1 where one is non-physical or refused.\n",
      body_impl::declare};
}

}  // namespace polhode::cli
