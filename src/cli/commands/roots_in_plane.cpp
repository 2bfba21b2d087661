// polhode roots --complex: all complex roots of a polynomial, each proved.

#include <chrono>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "cli/output/errors.hpp"
#include "cli/output/exact_decimals.hpp"
#include "cli/output/json_document.hpp"
#include "cli/output/progress.hpp"
#include "cli/output/streams.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/roots/complex_roots.hpp"
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

json as_json(const expression& f, const roots_options& options, const complex_roots_answer& a,
             long digits) {
  json list = json::array();
  for (const complex_root& r : a.roots) {
    json entry{{"verdict", r.multiplicity == 1 ? "unique" : "multiple"},
               {"multiplicity", r.multiplicity}};
    entry["number"] = {{"real", to_json(r.enclosure.re, digits)},
                       {"imaginary", to_json(r.enclosure.im, digits)}};
    if (r.exact) entry["number"]["rational"] = to_text(*r.exact);
    list.push_back(std::move(entry));
  }
  return {{"function", f.to_text()},
          {"variable", options.variable},
          {"in", "the complex plane"},
          {"verdict", to_text(a.complete ? status::certified : status::not_certified)},
          {"identically_zero", false},
          {"complete", a.complete},
          {"roots", std::move(list)}};
}

}  // namespace
}  // namespace complex_roots_impl

exit_status run_complex_roots(const roots_options& options) {
  using namespace complex_roots_impl;
  check_variable(options.variable);
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
    print(json_document_text("roots", as_json(f, options, a, digits)));
  } else {
    print(format == "csv" ? as_csv(a, digits) : as_text(a, p->degree(), digits));
  }
  return a.complete ? exit_status::all_certified : exit_status::not_certified;
}

}  // namespace polhode::cli
