#include "second_opinion.hpp"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "duration.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/checker/check.hpp"

namespace polhode::cli {

void verify_option::declare(CLI::App& app) {
  app.add_flag("--verify", given,
               "Find the result again by another route and compare; where the\n"
               "two contradict each other there is no result, and status 3");
}

void verify_option::expect_format(const std::string& format) const {
  if (given && (format == "csv" || format == "cpp")) {
    throw usage_error(fmt::format(
        "--verify: {} has no place for a second opinion; give --format text or json", format));
  }
}

namespace {

/// Both ends, with so many digits.
std::string ends_of(const ball& x, long digits) {
  if (!x.is_bounded()) return "undefined";
  const decimal_enclosure d = to_decimal_enclosure(x, digits);
  return d.exact ? d.value : fmt::format("[{}, {}]", d.lower, d.upper);
}

/// How many digits show that the sets have no common number: those that their size has before their distance, and a few.
long digits_of_gap(const ball& x, const ball& y) {
  constexpr long few = 20;
  const magnitude gap = (x - y).magnitude_lower();
  const magnitude size = max(x.magnitude_upper(), y.magnitude_upper());
  if (gap.is_zero() || size.is_zero() || size.is_infinite()) return few;
  const std::int64_t bits = std::max<std::int64_t>(size.log2_floor() - gap.log2_floor(), 0);
  return few + static_cast<long>(bits / 3);
}

}  // namespace

void contradict(std::string_view what, const finding<std::string>& first,
                const finding<std::string>& second) {
  throw contradiction_error(
      fmt::format("INTERNAL ERROR: two proofs contradict each other, so one of them is wrong\n"
                  "  of:           {}\n"
                  "  first route:  {}\n"
                  "                {}\n"
                  "  second route: {}\n"
                  "                {}\n"
                  "There is no result. This is a fault in Polhode: please report it with the whole "
                  "command line.",
                  what, first.route, first.enclosure, second.route, second.enclosure));
}

void expect_overlap(std::string_view what, const finding<ball>& first,
                    const finding<ball>& second) {
  if (overlaps(first.enclosure, second.enclosure)) return;
  const long digits = digits_of_gap(first.enclosure, second.enclosure);
  contradict(what, {first.route, ends_of(first.enclosure, digits)},
             {second.route, ends_of(second.enclosure, digits)});
}

void expect_overlap(std::string_view what, const finding<complex_ball>& first,
                    const finding<complex_ball>& second) {
  const auto part = [&](const char* name, const ball& x, const ball& y) {
    expect_overlap(fmt::format("{}, its {} part", what, name), {first.route, x}, {second.route, y});
  };
  part("real", first.enclosure.re, second.enclosure.re);
  part("imaginary", first.enclosure.im, second.enclosure.im);
}

magnitude confirming_radius(const ball& first, long digits) {
  const magnitude unit =
      divide_down(first.magnitude_lower(), pow(ball(10, 64), digits).magnitude_upper());
  return max(first.radius(), unit);
}
magnitude confirming_radius(const complex_ball& first, long digits) {
  return max(confirming_radius(first.re, digits), confirming_radius(first.im, digits));
}

// ---------------------------------------------------------------------------------------------
// What is said of it

namespace {

std::string cost_text(const route_report& r) {
  return fmt::format("{}{}{}", r.work, r.work.empty() ? "" : ", ", duration_text(r.seconds));
}

json to_json(const route_report& r) {
  json result{{"agrees", r.agrees()}, {"route", r.route}};
  if (!r.agrees()) result["reason"] = r.obstacle;
  result["enclosure"] = r.enclosure;
  result["cost"] = json{{"work", r.work}, {"seconds", r.seconds}};
  return result;
}

}  // namespace

bool second_opinion::agrees() const {
  return std::any_of(tried_.begin(), tried_.end(),
                     [](const route_report& r) { return r.agrees(); });
}

std::string second_opinion::as_text() const {
  std::string result;
  std::string reasons;
  for (const route_report& r : tried_) {
    if (r.agrees()) {
      result += fmt::format("second opinion: the same by {} ({})\n", r.route, cost_text(r));
    } else {
      reasons += fmt::format("{}{}: {}", reasons.empty() ? "" : "; ", r.route, r.obstacle);
    }
  }
  if (!result.empty()) return result;
  return fmt::format("not confirmed: no second opinion was found{}\n",
                     reasons.empty() ? "" : " (" + reasons + ")");
}

json second_opinion::as_json() const {
  json result;
  json others = json::array();
  for (const route_report& r : tried_) {
    if (agrees() && !r.agrees()) continue;
    if (agrees() && result.is_null()) {
      result = to_json(r);
    } else {
      others.push_back(to_json(r));
    }
  }
  if (result.is_null()) return {{"agrees", false}, {"tried", others}};
  if (!others.empty()) result["further"] = std::move(others);
  return result;
}

// ---------------------------------------------------------------------------------------------
// The checker

route_report checked_again(std::string_view what, const std::string& first,
                           const json& certificate) {
  const stopwatch time;
  const std::string text = certificate.dump(2);
  const checker::report r = checker::check(text);
  route_report result;
  result.route = "the independent checker, from a certificate";
  result.seconds = time.seconds();
  result.work = fmt::format("{} bytes", text.size());
  const std::string found =
      fmt::format("at {}: {}", r.place.empty() ? "the top" : r.place, r.message);
  switch (r.result) {
    case checker::outcome::verified:
      result.enclosure = certificate.at("numbers");
      break;
    case checker::outcome::refuted:
      contradict(what, {first, "certified, and written down as a certificate"},
                 {result.route, "refuted " + found});
    case checker::outcome::verified_in_part:
    case checker::outcome::not_checkable:
    case checker::outcome::malformed:
      result.obstacle = to_text(r.result) + ", " + found;
  }
  return result;
}

}  // namespace polhode::cli
