#include "second_opinion.hpp"

#include <algorithm>
#include <variant>

#include <fmt/format.h>

#include "base/clock.hpp"
#include "cli/output/duration.hpp"
#include "polhode/checker/check.hpp"

namespace polhode::cli {

void verify_option::declare(CLI::App& app) {
  add_flag(app, "--verify", given,
           "Find the result again by another route and compare; where the\n"
           "two contradict each other there is no result, and status 3");
}

void verify_option::expect_format(const std::string& format) const {
  if (given && (format == "csv" || format == "cpp")) {
    throw usage_error(fmt::format(
        "--verify: {} has no place for a second opinion; give --format text or json", format));
  }
}

// ---------------------------------------------------------------------------------------------
// What is said of it

namespace {

std::string cost_text(const printed_route& r) {
  return fmt::format("{}{}{}", r.work, r.work.empty() ? "" : ", ", duration_text(r.seconds));
}

json to_json(const printed_route& r) {
  json result{{"agrees", r.agrees()}, {"route", r.route}};
  if (!r.agrees()) result["reason"] = r.obstacle;
  result["enclosure"] = r.enclosure;
  result["cost"] = json{{"work", r.work}, {"seconds", r.seconds}};
  return result;
}

json to_json(const proved_roots& list, long digits) {
  json result = json::array();
  for (const proved_root& r : list.roots) {
    json entry = polhode::to_json(r.enclosure, digits);
    entry["multiplicity"] = r.multiplicity;
    result.push_back(std::move(entry));
  }
  return result;
}

/// What is found of a number, as the commands print it.
struct enclosure_as_json {
  long digits;

  json operator()(const std::monostate&) const { return {}; }
  json operator()(const ball& x) const { return polhode::to_json(x, digits); }
  json operator()(const complex_ball& z) const { return polhode::to_json(z, digits); }
  json operator()(const proved_roots& list) const { return to_json(list, digits); }
};

}  // namespace

printed_opinion::printed_opinion(const second_opinion& opinion, long digits) {
  for (const route_report& r : opinion.routes()) {
    add({r.route, r.obstacle, std::visit(enclosure_as_json{digits}, r.enclosure), r.work,
         r.seconds});
  }
}

bool printed_opinion::agrees() const {
  return std::any_of(tried_.begin(), tried_.end(),
                     [](const printed_route& r) { return r.agrees(); });
}

std::string printed_opinion::as_text() const {
  std::string result;
  std::string reasons;
  for (const printed_route& r : tried_) {
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

json printed_opinion::as_json() const {
  json result;
  json others = json::array();
  for (const printed_route& r : tried_) {
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

printed_route checked_again(std::string_view what, const std::string& first,
                            const json& certificate) {
  const auto start = detail::clock::now();
  const std::string text = certificate.dump(2);
  const checker::report r = checker::check(text);
  printed_route result;
  result.route = "the independent checker, from a certificate";
  result.seconds = detail::seconds_since(start);
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
