// polhode constants: the constants of the paper, to any number of certain digits.

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/clock.hpp"
#include "cli/commands.hpp"
#include "cli/options/certificate_option.hpp"
#include "cli/options/memory_limit.hpp"
#include "cli/options/options.hpp"
#include "cli/options/second_opinion.hpp"
#include "cli/options/time_limit.hpp"
#include "cli/output/json_document.hpp"
#include "cli/output/layout.hpp"
#include "cli/output/progress.hpp"
#include "cli/output/streams.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/verify/second_opinion.hpp"
#include "polhode/version.hpp"
#include "proofs/claim.hpp"

namespace polhode::cli {
namespace constants_impl {
namespace {

using proofs::constant;

struct enclosed_constant {
  const constant* what;
  ball enclosure;
  std::optional<printed_opinion> opinion = std::nullopt;  // with --verify
};

[[noreturn]] void not_certified(const constant& c, long digits) {
  throw not_certified_error(
      fmt::format("{} was not certified to {} digits (precision limit)", c.name, digits));
}

/// Its decimals, of which `digits` are certain (or all, where there are fewer).
decimal_enclosure certain_decimals(const enclosed_constant& c, long digits) {
  if (!c.enclosure.is_bounded()) not_certified(*c.what, digits);
  decimal_enclosure result = to_decimal_enclosure(c.enclosure, digits);
  if (!result.has_cut(digits)) not_certified(*c.what, digits);
  return result;
}

// ---------------------------------------------------------------------------------------------
// The formats

/// Each line two columns to the right.
std::string indented(const std::string& lines) {
  std::string result;
  for (const char c : lines) {
    if (result.empty() || result.back() == '\n') result += "  ";
    result += c;
  }
  return result;
}

std::string as_text(const std::vector<enclosed_constant>& constants, long digits) {
  std::string result;
  for (const auto& c : constants) {
    const decimal_enclosure d = certain_decimals(c, digits);
    result.append(c.what->name).append(" = ").append(d.value).append(d.exact ? "\n" : "...\n");
    if (c.opinion) result += indented(c.opinion->as_text());
  }
  return result;
}

std::string as_csv(const std::vector<enclosed_constant>& constants, long digits) {
  std::string result = "name,value,radius,lower,upper,digits\n";
  for (const auto& c : constants) {
    const decimal_enclosure d = certain_decimals(c, digits);
    for (const std::string* cell : {&c.what->name, &d.value, &d.radius, &d.lower, &d.upper}) {
      result.append(*cell).append(",");
    }
    result.append(std::to_string(d.digits)).append("\n");
  }
  return result;
}

std::string as_json(const std::vector<enclosed_constant>& constants, long digits) {
  json result = json::object();
  for (const auto& c : constants) {
    (void)certain_decimals(c, digits);
    json number = to_json(c.enclosure, digits);
    if (c.opinion) number["second_opinion"] = c.opinion->as_json();
    result[c.what->name] = std::move(number);
  }
  return json_document_text("constants", result);
}

/// Enough for every type of floating point number up to the 113 bits (34 digits) of binary128.
constexpr long digits_of_literals = 50;

std::string as_cpp_definitions(const enclosed_constant& c, long digits) {
  constexpr long digits_in_comment = 20;
  const std::string& name = c.what->name;
  const std::string literal = certain_decimals(c, digits_of_literals).value;
  const decimal_enclosure brief = to_decimal_enclosure(c.enclosure, digits_in_comment);
  std::string result = "\n";
  for (const std::string& line : wrapped(c.what->description, terminal_columns - 3)) {
    result += "// " + line + '\n';
  }
  result += fmt::format("// Certified: {} <= {} <= {}\n", brief.lower, name, brief.upper);
  result += fmt::format("inline constexpr std::string_view {}_decimal =\n    \"", name);
  result += certain_decimals(c, digits).value;
  result += fmt::format(
      "\";\ninline constexpr double {0} =\n    {1};\n"
      "inline constexpr long double {0}_long_double =\n    {1}L;\n",
      name, literal);
  return result;
}

std::string as_cpp(const std::vector<enclosed_constant>& constants, long digits) {
  std::string result = fmt::format(
      "// Written by polhode {}. The decimals of a constant are the first {} significant digits of "
      "its\n"
      "// true value, cut off, not rounded. The floating point numbers are rounded by the compiler "
      "from\n"
      "// {} digits.\n"
      "#pragma once\n\n#include <string_view>\n\nnamespace polhode_constants {{\n",
      POLHODE_VERSION, digits, digits_of_literals);
  for (const auto& c : constants) result += as_cpp_definitions(c, digits);
  return result + "\n}  // namespace polhode_constants\n";
}

struct output_format {
  std::string name;
  std::string (*write)(const std::vector<enclosed_constant>&, long digits);
  long least_digits;     // computed even where fewer are printed
  double kept_decimals;  // copies of a constant's decimals held at once
};

const std::vector<output_format>& output_formats() {
  static const std::vector<output_format> formats{{"text", as_text, 1, 3},
                                                  {"csv", as_csv, 1, 9},
                                                  {"json", as_json, 1, 12},
                                                  {"cpp", as_cpp, digits_of_literals, 4}};
  return formats;
}

// ---------------------------------------------------------------------------------------------
// The command

struct constants_options {
  std::vector<std::string> names;
  digits_option digits;
  format_option format{names_of(output_formats())};
  memory_limit_option memory_limit;
  certificate_option certificate;
  verify_option verify;
  time_limit_option time_limit;
};

std::vector<const constant*> selected_constants(const constants_options& options) {
  const std::vector<std::string> all = names_of(proofs::all_constants());
  const std::vector<std::string> names =
      known_names(options.names, all, "constant", "polhode constants");
  std::vector<const constant*> result;
  for (const std::string& name : names.empty() ? all : names) {
    result.push_back(proofs::find_constant(name));
  }
  return result;
}

/// Constants are computed one after another; what is printed of them is kept.
memory_estimate estimate(const std::vector<const constant*>& constants, long digits,
                         double kept_decimals) {
  double most = 0;
  for (const constant* c : constants) most = std::max(most, proofs::estimated_memory(*c, digits));
  const std::size_t count = constants.size();
  return {count == 1 ? fmt::format("{} digits of {}", digits, constants.front()->name)
                     : fmt::format("{} digits of {} constants", digits, count),
          most + kept_decimals * static_cast<double>(digits) * static_cast<double>(count)};
}

std::vector<enclosed_constant> enclose_all(const std::vector<const constant*>& constants,
                                           long digits, const progress& line) {
  std::vector<enclosed_constant> result;
  for (const constant* c : constants) {
    line.show(fmt::format("computing {} ({}/{})", c->name, result.size() + 1, constants.size()));
    result.push_back({.what = c, .enclosure = proofs::enclose_to_digits(*c, digits)});
  }
  return result;
}

/// By the constant's second formula, and by the checker from the claim's certificate; that of few
/// digits, as its time grows with their square and more.
printed_opinion verify(const enclosed_constant& c, long digits) {
  constexpr long most_digits_for_checker = 1000;
  constexpr long more_digits = 11;
  const std::string first_route = "the formula";
  printed_opinion result;
  const auto start = detail::clock::now();
  const precision bits = bits_for_digits(digits + more_digits) | 1;
  const ball again = c.what->enclose_again(bits);
  printed_route report;
  report.route = c.what->second_route;
  report.work = fmt::format("{} bits", bits);
  report.seconds = detail::seconds_since(start);
  expect_overlap(c.what->name, {first_route, c.enclosure}, {report.route, again});
  if (again.is_bounded() && again.radius() <= confirming_radius(c.enclosure, digits)) {
    report.enclosure = to_json(again, digits);
  } else {
    report.obstacle = "its enclosure is wider than the digits that are asked for";
  }
  result.add(std::move(report));
  const proofs::claim* same = proofs::find_claim(c.what->name);
  if (same == nullptr || digits > most_digits_for_checker) return result;
  proofs::request wanted;
  wanted.digits = digits;
  const certificate proved = same->prove(wanted);
  for (const enclosed_number& number : proved.numbers) {
    if (number.name != c.what->name) continue;
    const std::string proof = "the claim of its name";
    expect_overlap(c.what->name, {first_route, c.enclosure}, {proof, number.enclosure});
    if (proved.verdict == status::certified) {
      result.add(checked_again(c.what->name, proof, to_json(proved)));
    }
  }
  return result;
}

/// The claim of a constant's name. Throws usage_error unless one constant is asked for, and there
/// is such a claim.
const proofs::claim& claim_about(const std::vector<const constant*>& constants) {
  if (constants.size() != 1) {
    throw usage_error(fmt::format(
        "--certificate: a certificate is of one constant; name it, as `polhode constants {} "
        "--certificate {}.json`",
        constants.front()->name, constants.front()->name));
  }
  const proofs::claim* same = proofs::find_claim(constants.front()->name);
  if (same == nullptr) {
    throw usage_error(
        fmt::format("--certificate: there is no claim about {}, and so no certificate",
                    constants.front()->name));
  }
  return *same;
}

/// Proves the claim and writes its certificate.
void write_certificate(const proofs::claim& about, long digits, certificate_option& file) {
  proofs::request wanted;
  wanted.digits = digits;
  const certificate proved = about.prove(wanted);
  file.expect_certified(proved.verdict == status::certified);
  file.write(to_json(proved));
}

exit_status run(constants_options& options) {
  const std::vector<const constant*> constants = selected_constants(options);
  const long digits = options.digits.value();
  const std::string& wanted = options.format.value();
  const auto format = std::find_if(output_formats().begin(), output_formats().end(),
                                   [&wanted](const output_format& f) { return f.name == wanted; });
  const memory_estimate memory = estimate(constants, digits, format->kept_decimals);
  options.memory_limit.check(memory);
  options.verify.expect_format(wanted);
  const proofs::claim* about = nullptr;
  if (options.certificate.is_given()) {
    about = &claim_about(constants);
    options.certificate.prepare();
  }
  std::vector<enclosed_constant> enclosed;
  {
    const progress line;
    line.show("estimating");
    std::vector<time_limit_option::work> works;
    works.reserve(constants.size());
    for (const constant* c : constants) {
      works.emplace_back([c](long fewer) { (void)proofs::enclose_to_digits(*c, fewer); });
    }
    line.expect(options.time_limit.check(memory.what, digits, works));
    const time_watch watch(options.time_limit.limit(static_cast<double>(constants.size())));
    enclosed = enclose_all(constants, std::max(digits, format->least_digits), line);
    for (enclosed_constant& c : enclosed) {
      if (!options.verify.given) break;
      line.show(fmt::format("looking for a second opinion on {}", c.what->name));
      if (c.enclosure.is_bounded()) c.opinion = verify(c, digits);
    }
    if (about != nullptr) write_certificate(*about, digits, options.certificate);
  }
  print(format->write(enclosed, digits));
  const bool confirmed = std::all_of(enclosed.begin(), enclosed.end(), [](const auto& c) {
    return !c.opinion || c.opinion->agrees();
  });
  return confirmed ? exit_status::all_certified : exit_status::not_certified;
}

std::function<exit_status()> declare(CLI::App& app) {
  const auto options = std::make_shared<constants_options>();
  add_option(app, "NAME", options->names, "Constants, by name; without any, all of them")
      .type_name("");
  options->digits.declare(app);
  options->format.declare(app);
  options->memory_limit.declare(app);
  options->certificate.declare(app);
  options->verify.declare(app);
  options->time_limit.declare(app);
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace constants_impl

command constants_command() {
  return {
      "constants", "Print the constants of the paper to any number of certain digits",
      "  polhode constants\n"
      "  polhode constants beta --digits 1000\n"
      "  polhode constants --format cpp > polhode_constants.hpp\n"
      "  polhode constants beta --certificate beta.json && polhode check beta.json\n"
      "  polhode constants --digits 300 --verify\n\n"
      "The decimals printed are the first N significant digits of the true value, cut off, never\n"
      "rounded: all of them are digits of its expansion. In csv and json, lower and upper are\n"
      "decimals rounded outward: the true value is proved to lie between them.\n",
      constants_impl::declare};
}

}  // namespace polhode::cli
