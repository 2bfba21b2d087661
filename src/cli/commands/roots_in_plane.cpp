// polhode roots --complex and --rectangle: all complex roots of a polynomial, and those of an
// analytic function in a rectangle, each proved.

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/output/errors.hpp"
#include "cli/output/exact_decimals.hpp"
#include "cli/output/json_document.hpp"
#include "cli/output/progress.hpp"
#include "cli/output/streams.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/roots/complex_roots.hpp"
#include "polhode/roots/zeros_in_rectangle.hpp"
#include "roots_options.hpp"

namespace polhode::cli {
namespace complex_roots_impl {
namespace {

/// "-0.5 + 0.866...i".
std::string number_text(const complex_root& r, long digits) {
  if (r.exact) return exact_number_text(*r.exact, digits);
  if (r.is_real()) return to_text(to_decimal_enclosure(r.enclosure.re, digits));
  const decimal_enclosure re = to_decimal_enclosure(r.enclosure.re, digits);
  decimal_enclosure im = to_decimal_enclosure(r.enclosure.im, digits);
  const bool is_below = im.value.front() == '-';
  if (is_below) im.value.erase(0, 1);
  const auto grouped = [](const decimal_enclosure& d) {
    const std::string text = to_text(d);
    return text.find(' ') == std::string::npos ? text : '(' + text + ')';
  };
  return fmt::format("{} {} {}i", grouped(re), is_below ? '-' : '+', grouped(im));
}

std::string as_text(const complex_roots_answer& a, long degree, long digits) {
  std::string result;
  for (const complex_root& r : a.roots) {
    result +=
        fmt::format("{}  {}\n", number_text(r, digits),
                    r.multiplicity == 1 ? "unique" : fmt::format("multiple {}", r.multiplicity));
  }
  if (!a.complete) {
    return result + fmt::format("not certified: {} proved, others are missing\n",
                                counted(a.roots.size(), "root"));
  }
  return result + fmt::format("certified: {}, with multiplicities as many as the degree, {}\n",
                              counted(a.roots.size(), "root"), degree);
}

std::string as_csv(const complex_roots_answer& a, long digits) {
  std::string result = "multiplicity,real,real_radius,imaginary,imaginary_radius,exact\n";
  for (const complex_root& r : a.roots) {
    const decimal_enclosure re = to_decimal_enclosure(r.enclosure.re, digits);
    const decimal_enclosure im = to_decimal_enclosure(r.enclosure.im, digits);
    result += fmt::format("{},{},{},{},{},{}\n", r.multiplicity, re.value, re.radius, im.value,
                          im.radius, r.exact ? to_text(*r.exact) : "");
  }
  return result;
}

json as_json(const expression& f, const roots_options& options, const std::string& where,
             const complex_roots_answer& a, long digits) {
  json list = json::array();
  for (const complex_root& r : a.roots) {
    json entry{{"verdict", r.multiplicity == 1 ? "unique" : "multiple"},
               {"multiplicity", r.multiplicity}};
    entry["number"] = to_json(r.enclosure, digits);
    if (r.exact) entry["number"]["rational"] = to_text(*r.exact);
    list.push_back(std::move(entry));
  }
  return {{"function", f.to_text()},
          {"variable", options.variable},
          {"in", where},
          {"verdict", to_text(a.complete ? status::certified : status::not_certified)},
          {"identically_zero", false},
          {"complete", a.complete},
          {"roots", std::move(list)}};
}

/// A corner, "5+10i".
std::pair<rational, rational> read_corner(const roots_options& options, const std::string& text) {
  const auto refuse = [&]() -> std::pair<rational, rational> {
    throw usage_error(fmt::format(
        "--rectangle {}: it must be the lower left and the upper right corner with rational parts, "
        "such as -5-10i..5+10i",
        in_quotes(*options.rectangle)));
  };
  try {
    const auto p = read_formula(text, {"i"}, options.let).polynomial();
    if (!p || p->degree() > 1) return refuse();
    const auto part = [&](std::size_t k) {
      return k < p->coefficients().size() ? p->coefficients()[k] : rational(0);
    };
    return {part(0), part(1)};
  } catch (const input_error&) {
    return refuse();
  } catch (const usage_error&) {
    return refuse();
  }
}

complex_rectangle read_rectangle(const roots_options& options) {
  const std::string& text = *options.rectangle;
  const std::size_t at = text.find("..");
  const auto [left, bottom] = read_corner(options, text.substr(0, at));
  const auto [right, top] =
      read_corner(options, at == std::string::npos ? std::string() : text.substr(at + 2));
  if (!(left < right && bottom < top)) {
    throw usage_error(
        fmt::format("--rectangle {}: the first corner must be to the left of the second, and below",
                    in_quotes(text)));
  }
  return {left, right, bottom, top};
}

/// "12 parts are undecided: the pole of / near 1.5 + 2i".
std::string undecided_text(const zeros_answer& a) {
  const undecided_rectangle& first = a.undecided.front();
  const ball re((first.where.left + first.where.right) / 2, 64);
  const ball im((first.where.bottom + first.where.top) / 2, 64);
  return fmt::format(
      "{} undecided: {} near {}",
      a.undecided.size() == 1 ? "1 part is" : fmt::format("{} parts are", a.undecided.size()),
      first.obstacle.empty() ? "zeros may lie" : first.obstacle,
      to_decimal(complex_ball(re, im), 6));
}

std::string as_text(const zeros_answer& a, const std::string& where, long digits) {
  std::string result;
  std::size_t count = 0;
  for (const complex_zero& z : a.zeros) {
    const complex_root root{z.enclosure, z.multiplicity, std::nullopt};
    const std::string several = z.is_one ? "multiple {}" : "{} roots, or one of that multiplicity";
    result += fmt::format(
        "{}  {}{}\n", number_text(root, digits),
        z.multiplicity == 1 ? "unique" : fmt::format(fmt::runtime(several), z.multiplicity),
        z.is_inside ? "" : ", on the boundary or beside it");
    count += static_cast<std::size_t>(z.multiplicity);
  }
  const std::string roots = counted(count, "root") + ", counted with multiplicities";
  if (!a.is_complete()) {
    return result + fmt::format("not certified: {}; {}\n", roots, undecided_text(a));
  }
  return result + fmt::format("certified: {}, and no others in {}\n", roots, where);
}

}  // namespace
}  // namespace complex_roots_impl

exit_status run_complex_roots(const roots_options& options) {
  using namespace complex_roots_impl;
  const expression f = read_equation(options.formula, {options.variable}, options.let);
  const long digits = options.digits.value();
  if (options.range.ways() != 0) {
    throw usage_error("--complex: all roots in the plane are found; leave the interval out");
  }
  refuse_options_of_interval(options, "complex roots");
  const auto p = f.polynomial();
  if (!p) {
    throw usage_error(
        fmt::format("--complex: \"{}\" is not a polynomial in {} with rational coefficients, or "
                    "its expansion is "
                    "too long",
                    f.to_text(), options.variable));
  }
  if (p->is_zero()) {
    throw usage_error("--complex: the polynomial is 0 everywhere; every number is a root");
  }
  check_memory(options, 8 * static_cast<double>(p->degree()) + 300);
  const progress line;
  line.show("looking for roots");
  const double seconds = options.time_limit.limit();
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  complex_roots_answer a;
  {
    const time_watch watch(2 * seconds);  // for steps so long that the clock is not looked at
    // One more, so that the last digit is not in doubt.
    a = complex_roots(*p, digits + 1, [&](long found) {
      line.show(fmt::format("{} of {} roots", found, p->degree()));
      return std::chrono::steady_clock::now() < end;
    });
  }
  const std::string format = options.format.value();
  if (format == "json") {
    print(json_document_text("roots", as_json(f, options, "the complex plane", a, digits)));
  } else {
    print(format == "csv" ? as_csv(a, digits) : as_text(a, p->degree(), digits));
  }
  return a.complete ? exit_status::all_certified : exit_status::not_certified;
}

exit_status run_roots_in_rectangle(const roots_options& options) {
  using namespace complex_roots_impl;
  if (options.complex || options.range.ways() != 0) {
    throw usage_error("--rectangle: it says where; leave --complex and the interval out");
  }
  refuse_options_of_interval(options, "complex roots");
  const complex_rectangle where = read_rectangle(options);
  const std::string unit = "i";
  if (options.variable == unit) {
    throw usage_error("with --rectangle, i is the imaginary unit; give another name");
  }
  expression f = read_equation(options.formula, {options.variable, unit}, options.let);
  const std::vector<std::string> used = f.used_variables();
  if (std::ranges::find(used, unit) == used.end()) {
    f = read_equation(options.formula, {options.variable}, options.let);
  }
  const long digits = options.digits.value();
  check_memory(options, 300);
  const progress line;
  line.show("looking for roots");
  const double seconds = options.time_limit.limit();
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  zeros_options how;
  how.digits = digits + 1;
  how.go_on = [&](std::size_t found) {
    line.show(counted(found, "root"));
    return std::chrono::steady_clock::now() < end;
  };
  zeros_answer found;
  {
    const time_watch watch(2 * seconds);  // for steps so long that the clock is not looked at
    found = zeros_in_rectangle(f, where, how);
  }
  complex_roots_answer a;
  a.complete = found.is_complete();
  for (const complex_zero& z : found.zeros) {
    a.roots.push_back({z.enclosure, z.multiplicity, std::nullopt});
  }
  const std::string format = options.format.value();
  if (format == "json") {
    json result = as_json(f, options, *options.rectangle, a, digits);
    for (std::size_t k = 0; k < found.zeros.size(); ++k) {
      result["roots"][k]["inside"] = found.zeros[k].is_inside;
      if (!found.zeros[k].is_one) result["roots"][k]["verdict"] = "cluster";
    }
    if (!a.complete) result["undecided"] = undecided_text(found);
    print(json_document_text("roots", result));
  } else {
    print(format == "csv" ? as_csv(a, digits) : as_text(found, *options.rectangle, digits));
  }
  return a.complete ? exit_status::all_certified : exit_status::not_certified;
}

}  // namespace polhode::cli
