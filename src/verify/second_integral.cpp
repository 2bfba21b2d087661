#include "polhode/verify/second_integral.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "base/clock.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/quadrature/integrate.hpp"

namespace polhode {

// ---------------------------------------------------------------------------------------------
// Cuts

namespace {

constexpr std::int64_t greatest_log2 = 1L << 16;

/// Bounded, and of a size that a rational number may have.
bool is_moderate(const ball& x) {
  if (!x.is_bounded()) return false;
  const magnitude size = x.magnitude_upper();
  return size.is_zero() || std::abs(size.log2_floor()) <= greatest_log2;
}

/// 2^k <= x < 2^(k+1).
rational power_of_two_below(const rational& x) {
  rational result(1);
  while (result > x) result /= 2;
  while (result * 2 <= x) result *= 2;
  return result;
}

/// The greatest whole number that is not above x.
integer floor_of(const rational& x) {
  integer quotient = numerator(x) / denominator(x);
  if (quotient * denominator(x) > numerator(x)) --quotient;
  return quotient;
}

/// The number (k + 1/3) unit, k whole, that is at least x and less than a unit above it, or below x
/// by less than one.
rational third_of_grid(const rational& x, const rational& unit) {
  return (rational(floor_of(x / unit)) + rational(1, 3)) * unit;
}

std::optional<rational> cut_of_finite(const end_point& a, const end_point& b) {
  constexpr precision most_bits = 1L << 16;
  for (precision p = 128; p <= most_bits; p *= 4) {
    ball left = a.at(p);
    ball right = b.at(p);
    if (!is_moderate(left) || !is_moderate(right)) return std::nullopt;
    if (certainly_less(right, left)) std::swap(left, right);
    const rational lower = upper_rational(left);
    const rational upper = lower_rational(right);
    if (lower >= upper) continue;
    const rational length(upper - lower);
    const rational widest(upper_rational(right) - lower_rational(left));
    if (widest > 2 * length) continue;
    const rational share(37, 100);
    const rational cut = third_of_grid(lower + share * length, power_of_two_below(length) / 64);
    if (lower < cut && cut < upper) return cut;
  }
  return std::nullopt;
}

}  // namespace

std::optional<rational> cut_between(const end_point& a, const end_point& b) {
  const int infinities = std::abs(a.infinite_sign()) + std::abs(b.infinite_sign());
  if (infinities == 0) return cut_of_finite(a, b);
  if (infinities == 2) return rational(1, 3);
  const end_point& infinite = a.infinite_sign() != 0 ? a : b;
  const ball end = (a.infinite_sign() != 0 ? b : a).at(64);
  if (!is_moderate(end)) return std::nullopt;
  const rational nearest = infinite.infinite_sign() > 0 ? upper_rational(end) : lower_rational(end);
  const rational step(1 + abs(nearest) / 3);
  return infinite.infinite_sign() > 0 ? third_of_grid(nearest + step + 1, 1)
                                      : third_of_grid(nearest - step - 1, 1);
}

// ---------------------------------------------------------------------------------------------
// Real ranges

std::string route_text(const integral_account& account) {
  std::string rules;
  for (const quadrature_rule rule : account.rules) {
    rules += (rules.empty() ? "" : " and ") + to_text(rule);
  }
  if (rules.empty()) rules = "bounds of the integrand";
  if (account.panels == 0 && !account.rules.empty()) return rules;
  return fmt::format("{}, {} panel{}", rules, account.panels, account.panels == 1 ? "" : "s");
}

namespace {

std::string work_text(const integral_account& a) {
  std::string result;
  const auto append = [&](const std::string& part) {
    result += (result.empty() ? "" : ", ") + part;
  };
  if (a.panels > 0) append(fmt::format("{} panel{}", a.panels, a.panels == 1 ? "" : "s"));
  if (a.terms > 0) append(fmt::format("{} terms", a.terms));
  if (a.evaluations > 0) append(fmt::format("{} evaluations", a.evaluations));
  if (a.region_evaluations > 0) append(fmt::format("{} over regions", a.region_evaluations));
  if (a.precision > 0) append(fmt::format("{} bits", a.precision));
  return result;
}

/// One rule for all pieces between the points; integrated until one of them is not certified.
integral integrate_pieces(const prepared_integrand& f, const std::vector<end_point>& points,
                          const integrate_options& how) {
  integral sum;
  sum.enclosure = ball(0, 64);
  sum.verdict = status::certified;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const integral part = integrate(f, points[k - 1], points[k], how);
    sum.account += part.account;
    sum.enclosure += part.enclosure;
    if (part.verdict == status::certified) continue;
    sum.verdict = part.verdict;
    sum.why = part.why;
    sum.obstacle = part.obstacle;
    // What is left of the sum may be anything.
    if (k + 1 < points.size()) sum.enclosure = ball::undefined(64);
    return sum;
  }
  return sum;
}

/// How the pieces are integrated to a sum of that radius, which may be 0 for any: first to so many
/// digits each, and to more where they cancel.
integral integrate_closely(const prepared_integrand& f, const std::vector<end_point>& points,
                           integrate_options how, const magnitude& goal) {
  if (!goal.is_zero()) how.absolute_exponent = static_cast<long>(goal.log2_floor()) - 2;
  integral sum = integrate_pieces(f, points, how);
  const bool cancels =
      sum.verdict == status::certified && !goal.is_zero() && !(sum.enclosure.radius() <= goal);
  if (!cancels || sum.enclosure.radius().is_infinite()) return sum;
  constexpr double digits_per_bit = 0.30103;
  const auto lost = static_cast<double>(sum.enclosure.radius().log2_floor() - goal.log2_floor());
  how.digits += static_cast<long>(std::ceil(lost * digits_per_bit)) + 2;
  integral finer = integrate_pieces(f, points, how);
  finer.account += sum.account;
  return finer;
}

bool is_among(const quadrature_rule& rule, const std::vector<quadrature_rule>& rules) {
  return std::find(rules.begin(), rules.end(), rule) != rules.end();
}

/// Those that are not in `used`, then those that are.
std::vector<quadrature_rule> rules_by_independence(const std::vector<quadrature_rule>& used) {
  const auto all = quadrature_rule::all();
  std::vector<quadrature_rule> rules(all.begin(), all.end());
  std::stable_partition(rules.begin(), rules.end(),
                        [&](const quadrature_rule& r) { return !is_among(r, used); });
  return rules;
}

/// Throws std::invalid_argument where there is nothing to confirm.
void expect_certified(status verdict, long digits) {
  if (verdict != status::certified) {
    throw std::invalid_argument("a second opinion is of a certified integral; this one is not");
  }
  if (digits < 1) throw std::invalid_argument("a second opinion is of one digit or more");
}

/// So many digits more than the first route's goal: another precision.
constexpr long more_digits = 7;

/// "not integrable (the pole at x = 1/3)".
std::string obstacle_text(reason why, const std::string& obstacle) {
  return to_text(why) + (obstacle.empty() ? "" : " (" + obstacle + ")");
}

}  // namespace

second_opinion integral_again(const prepared_integrand& f, const end_point& a, const end_point& b,
                              const integral& first, long digits, int threads) {
  expect_certified(first.verdict, digits);
  const std::string what = "the integral";
  const finding<ball> known{route_text(first.account), first.enclosure};
  const magnitude goal = confirming_radius(first.enclosure, digits);
  const std::optional<rational> cut = cut_between(a, b);
  std::vector<end_point> points{a, b};
  if (cut) points.insert(points.begin() + 1, end_point(*cut));
  second_opinion result;
  bool another_failed = false;
  for (const quadrature_rule& rule : rules_by_independence(first.account.rules)) {
    const auto start = detail::clock::now();
    integrate_options how;
    how.digits = digits + more_digits;
    how.rule = rule;
    how.threads = threads;
    const integral sum = integrate_closely(f, points, how, goal);
    route_report report;
    const bool own = is_among(rule, first.account.rules);
    another_failed =
        another_failed || (!own && sum.why != reason::none && sum.why != reason::not_applicable);
    report.route = to_text(rule) + (own ? " again" : "");
    if (cut) report.route += ", the range cut at " + to_decimal(ball(*cut, 64), 6);
    report.work = work_text(sum.account);
    report.seconds = detail::seconds_since(start);
    // The double exponential rule says so of an upper bound of f's growth, which is no proof.
    const bool diverges =
        sum.why == reason::not_integrable && rule != quadrature_rule::double_exponential;
    if (diverges) {
      contradict(what, {known.route, to_decimal(first.enclosure, digits)},
                 {report.route, obstacle_text(sum.why, sum.obstacle)});
    }
    expect_overlap(what, known, {report.route, sum.enclosure});
    if (sum.verdict != status::certified) {
      report.obstacle = obstacle_text(sum.why, sum.obstacle);
    } else if (!goal.is_zero() && !(sum.enclosure.radius() <= goal)) {
      report.obstacle = "its enclosure is wider than the digits that are asked for";
    } else if (own && another_failed) {
      report.obstacle = "the same, but a rule that shares less with the first route fails";
    } else {
      report.enclosure = sum.enclosure;
    }
    result.add(report);
    if (report.agrees()) break;
  }
  return result;
}

// ---------------------------------------------------------------------------------------------
// Paths

namespace {

/// a + (b - a) k.
end_point between(const end_point& a, const end_point& b, const rational& k) {
  if (a.form() && b.form()) return end_point(*a.form() + (*b.form() - *a.form()) * k);
  return end_point([=](precision p) { return a.at(p) + (b.at(p) - a.at(p)) * k; });
}

path cut_piece(const line_piece& line, const rational& k) {
  const path_point middle(between(line.from.re(), line.to.re(), k),
                          between(line.from.im(), line.to.im(), k));
  return path::polygon({line.from, middle, line.to});
}
path cut_piece(const arc_piece& arc, const rational& k) {
  const end_point middle = between(arc.from_angle, arc.to_angle, k);
  return path::arc(arc.centre, arc.radius, arc.from_angle, middle) +
         path::arc(arc.centre, arc.radius, middle, arc.to_angle);
}

}  // namespace

second_opinion integral_again(const detail::complex_integrand& f, const path& along,
                              const contour_integral& first, long digits, int threads) {
  expect_certified(first.verdict, digits);
  const std::string what = "the integral";
  const finding<complex_ball> known{route_text(first.account), first.enclosure};
  const rational share(10, 27);
  path cut;
  for (const path_piece& piece : along.pieces()) {
    cut = std::move(cut) + std::visit([&](const auto& p) { return cut_piece(p, share); }, piece);
  }
  const auto start = detail::clock::now();
  const magnitude goal = confirming_radius(first.enclosure, digits);
  integrate_options how;
  how.digits = digits + more_digits;
  how.threads = threads;
  if (!goal.is_zero()) how.absolute_exponent = static_cast<long>(goal.log2_floor()) - 2;
  const contour_integral again = detail::integrate_path(f, -cut, how);
  const complex_ball enclosure = -again.enclosure;
  route_report report;
  report.route = "Gauss-Legendre backwards, every piece cut at 10/27 of it";
  report.work = work_text(again.account);
  report.seconds = detail::seconds_since(start);
  expect_overlap(what, known, {report.route, enclosure});
  if (again.verdict != status::certified) {
    report.obstacle = obstacle_text(again.why, again.obstacle);
  } else {
    report.enclosure = enclosure;
  }
  second_opinion result;
  result.add(std::move(report));
  return result;
}

// ---------------------------------------------------------------------------------------------
// Of formulas

second_opinion integral_again(const expression& f, const end_point& a, const end_point& b,
                              const integral& first, long digits, int threads) {
  return integral_again(prepared_integrand(f), a, b, first, digits, threads);
}
second_opinion integral_again(const expression& f, const path& along, const contour_integral& first,
                              long digits, int threads) {
  return integral_again(complex_integrand_of(f), along, first, digits, threads);
}

}  // namespace polhode
