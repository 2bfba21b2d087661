#include "integrals.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "polhode/arithmetic/text.hpp"
#include "quadrature/formula/integrand.hpp"

namespace polhode::differential {
namespace {

end_point read_limit(const term& t) {
  if (t.is("inf")) return end_point::infinity();
  if (t.is("-inf")) return -end_point::infinity();
  return end_point_of(read(t));
}

/// As the command line needs it: not to be taken for an option.
std::string quoted(const term& t) {
  const std::string text = t.text();
  return text.front() == '-' && text != "-inf" ? "\" " + text + '"' : '"' + text + '"';
}

// ---------------------------------------------------------------------------------------------
// Routes

enum class kind {
  rule,  // the integral as it is
  other_digits,
  cut,             // at a point between the limits
  reversal,        // the limits exchanged
  mirror,          // x = -y
  affine,          // x = alpha y + beta
  inversion,       // x = 1/y
  exponential,     // x = exp(y)
  square,          // x = y^2
  antiderivative,  // its values at the limits
  value,
  parts
};

struct way {
  kind by = kind::rule;
  quadrature_rule rule = quadrature_rule::automatic;

  friend bool operator==(const way&, const way&) = default;
  [[nodiscard]] bool is_knowledge() const {
    return by == kind::antiderivative || by == kind::value || by == kind::parts;
  }
};

/// The rule that `integrate` chooses, every rule there is, and the other kinds.
std::vector<way> every_way() {
  std::vector<way> ways{way{}};
  for (const quadrature_rule& rule : quadrature_rule::all()) ways.push_back({kind::rule, rule});
  for (const kind by :
       {kind::other_digits, kind::cut, kind::reversal, kind::mirror, kind::affine, kind::inversion,
        kind::exponential, kind::square, kind::antiderivative, kind::value, kind::parts}) {
    ways.push_back({by});
  }
  return ways;
}

std::string name_of(way w) {
  switch (w.by) {
    case kind::rule:
      return "one rule";
    case kind::other_digits:
      return "to another number of digits";
    case kind::cut:
      return "cut in two";
    case kind::reversal:
      return "with the limits exchanged";
    case kind::mirror:
      return "with -x for x";
    case kind::affine:
      return "with alpha*x + beta for x";
    case kind::inversion:
      return "with 1/x for x";
    case kind::exponential:
      return "with exp(x) for x";
    case kind::square:
      return "with x^2 for x";
    case kind::antiderivative:
      return "by an antiderivative";
    case kind::value:
      return "in closed form";
    case kind::parts:
      return "as a sum";
  }
  return "";
}

/// What a route computes: integrals and a constant, which are added up.
struct route {
  std::vector<piece> pieces;
  term constant = 0;
};

/// 1, -1 or 0 where the number is proved positive, negative or is written as 0; 2 where nothing is
/// known.
int sign(const term& t) {
  if (t.is("0")) return 0;
  if (t.is("inf")) return 1;
  if (t.is("-inf")) return -1;
  try {
    const ball x = read(t).value(128);
    if (certainly_positive(x)) return 1;
    if (certainly_negative(x)) return -1;
  } catch (const input_error&) {
    return 2;
  }
  return 2;
}
bool is_infinite(const term& t) { return t.is("inf") || t.is("-inf"); }

term at_limit(const term& f, const term& limit) { return substituted(f, "x", limit); }

/// The route for this case, with the random numbers of this seed; nothing where there is none.
std::optional<route> route_of(const integral_case& c, way w, std::uint64_t seed) {
  maker m(seed);
  const term x = "x";
  const piece own{c.integrand, c.from, c.to, c.digits};
  /// With g(x) for x, g' = slope, g increasing.
  const auto substitution = [&](const term& g, const term& slope, const term& from,
                                const term& to) {
    return route{{{substituted(c.integrand, "x", g) * slope, from, to, c.digits}}};
  };
  switch (w.by) {
    case kind::rule: {
      piece p = own;
      p.rule = w.rule;
      return route{{p}};
    }
    case kind::other_digits: {
      piece p = own;
      const bool fewer = m.one_in(2);
      if (c.is_cheap) {
        p.digits = fewer ? m.between(2, 5) : m.between(6, 12);
      } else {
        p.digits = fewer ? m.between(2, 12) : m.between(20, 60);
      }
      return route{{p}};
    }
    case kind::cut: {
      term at = 0;
      if (is_infinite(c.from) || is_infinite(c.to)) {
        const term finite = is_infinite(c.to) ? c.from : c.to;
        const term step = m.near(m.scattered(0.01, 30));
        at = is_infinite(finite) ? m.near(m.within(-4, 4))
                                 : (is_infinite(c.to) ? finite + step : finite - step);
      } else if (m.one_in(2)) {
        at = c.from + (c.to - c.from) * m.quotient(m.within(0.1, 0.9));
      } else {
        const double low = approximately(c.from);
        const double high = approximately(c.to);
        at = m.near(m.within(low + 0.1 * (high - low), high - 0.1 * (high - low)));
        const double middle = approximately(at);
        if (!(std::min(low, high) < middle && middle < std::max(low, high))) return std::nullopt;
      }
      piece first = own;
      first.to = at;
      piece second = own;
      second.from = at;
      return route{{first, second}};
    }
    case kind::reversal: {
      piece p = own;
      std::swap(p.from, p.to);
      p.factor = -1;
      return route{{p}};
    }
    case kind::mirror:
      return route{{{substituted(c.integrand, "x", -x), -c.to, -c.from, c.digits}}};
    case kind::affine: {
      const term alpha = m.one_in(2) ? m.positive_rational() : m.near(m.scattered(0.1, 20));
      const term beta = m.one_in(3) ? term(0) : m.near(m.within(-3, 3));
      const auto moved = [&](const term& y) { return is_infinite(y) ? y : (y - beta) / alpha; };
      return substitution(alpha * x + beta, alpha, moved(c.from), moved(c.to));
    }
    case kind::inversion: {
      const int a = sign(c.from);
      const int b = sign(c.to);
      if (a == 2 || b == 2 || a < 0 || b < 0 || (a == 0 && b == 0)) return std::nullopt;
      const auto inverse = [](const term& y) {
        if (is_infinite(y)) return term(0);
        return y.is("0") ? term("inf") : 1 / y;
      };
      return substitution(1 / x, power(x, -2), inverse(c.to), inverse(c.from));
    }
    case kind::exponential: {
      const int a = sign(c.from);
      const int b = sign(c.to);
      if (a == 2 || b == 2 || a < 0 || b < 0 || (a == 0 && b == 0)) return std::nullopt;
      const auto logarithm = [](const term& y) {
        if (is_infinite(y)) return y;
        return y.is("0") ? term("-inf") : call("log", y);
      };
      return substitution(call("exp", x), call("exp", x), logarithm(c.from), logarithm(c.to));
    }
    case kind::square: {
      const int a = sign(c.from);
      const int b = sign(c.to);
      if (a == 2 || b == 2 || a < 0 || b < 0) return std::nullopt;
      const auto root = [](const term& y) {
        return is_infinite(y) || y.is("0") ? y : call("sqrt", y);
      };
      return substitution(power(x, 2), 2 * x, root(c.from), root(c.to));
    }
    case kind::antiderivative:
      if (!c.antiderivative || is_infinite(c.from) || is_infinite(c.to)) return std::nullopt;
      return route{{}, at_limit(*c.antiderivative, c.to) - at_limit(*c.antiderivative, c.from)};
    case kind::value:
      if (!c.value) return std::nullopt;
      return route{{}, *c.value};
    case kind::parts:
      if (c.parts.empty()) return std::nullopt;
      return route{c.parts};
  }
  return std::nullopt;
}

// ---------------------------------------------------------------------------------------------
// Results

/// What a route gave.
struct result {
  way by;
  std::uint64_t seed = 0;
  route computed_by;
  bool certified = false;
  ball enclosure = ball::undefined(64);  // bounded, or undefined
  bool is_said_to_diverge = false;
  long integrals = 0;
};

/// To so many digits about: more bits until it is narrow enough, or as narrow as it gets.
ball constant_value(const term& t, long digits) {
  const expression f = read(t);
  const magnitude goal = pow(ball(10, 64), -digits).magnitude_upper();
  ball x;
  for (precision p = bits_for_digits(digits) + 64; p < (1L << 14); p *= 2) {
    x = f.value(p);
    if (x.is_bounded() && x.radius() <= multiply_up(x.magnitude_upper(), goal)) break;
  }
  return x;
}

result computed(const integral_case& c, way w, std::uint64_t seed, const route& r) {
  result total{w, seed, r};
  total.certified = true;
  const precision p = bits_for_digits(c.digits) + 128;
  ball sum(0, p);
  constexpr long few_evaluations = 300;
  for (piece one : r.pieces) {
    if (c.is_cheap) one.most_evaluations = few_evaluations;
    const integral i = differential::computed(one);
    ++total.integrals;
    total.certified = total.certified && i.verdict == status::certified;
    total.is_said_to_diverge = i.why == reason::not_integrable;
    if (!i.enclosure.is_bounded()) {
      total.certified = false;
      return total;
    }
    sum = sum + i.enclosure * constant_value(one.factor, c.digits + 10);
  }
  if (!r.constant.is("0")) {
    try {
      sum = sum + constant_value(r.constant, c.digits + 10);
    } catch (const input_error&) {
      total.certified = false;
      return total;
    }
  }
  if (sum.is_bounded()) total.enclosure = sum;
  total.certified = total.certified && sum.is_bounded();
  return total;
}

/// Whether the route is one integral, which diverges where the case does.
bool is_the_same_integral(const result& r) { return r.computed_by.pieces.size() == 1; }

/// In words, where the two cannot both be true.
std::optional<std::string> contradiction(const result& a, const result& b) {
  if (a.enclosure.is_bounded() && b.enclosure.is_bounded() && !overlaps(a.enclosure, b.enclosure)) {
    return "the enclosures are disjoint";
  }
  const auto denies = [](const result& one, const result& other) {
    return one.is_said_to_diverge && is_the_same_integral(one) && other.certified;
  };
  if (denies(a, b) || denies(b, a)) return "one is said to diverge and the other is certified";
  return std::nullopt;
}

std::string ends_of(const ball& x, long digits) {
  if (!x.is_bounded()) return "undefined";
  const decimal_enclosure d = to_decimal_enclosure(x, digits + 6);
  return fmt::format("[{}, {}]", d.lower, d.upper);
}

std::string described(const result& r, long digits) {
  std::string text = fmt::format("  {}:\n", name_of(r.by));
  for (const piece& p : r.computed_by.pieces) {
    text += "    " + command_of(p);
    if (!p.factor.is("1")) text += "   times " + p.factor.text();
    text += '\n';
  }
  if (!r.computed_by.constant.is("0")) {
    text +=
        fmt::format("    polhode eval {} --digits {}\n", quoted(r.computed_by.constant), digits);
  }
  return text + fmt::format("    {}, {}{}\n", ends_of(r.enclosure, digits),
                            r.certified ? "certified" : "not certified",
                            r.is_said_to_diverge ? ", said to diverge" : "");
}

// ---------------------------------------------------------------------------------------------
// Shrinking

std::optional<result> result_of(const integral_case& c, way w, std::uint64_t seed) {
  const auto r = route_of(c, w, seed);
  if (!r) return std::nullopt;
  return computed(c, w, seed, *r);
}

struct failure {
  integral_case c;
  result first;
  result second;
  std::string what;
};

std::optional<failure> failing(const integral_case& c, way a, std::uint64_t seed_a, way b,
                               std::uint64_t seed_b) {
  const auto first = result_of(c, a, seed_a);
  if (!first) return std::nullopt;
  const auto second = result_of(c, b, seed_b);
  if (!second) return std::nullopt;
  const auto what = contradiction(*first, *second);
  if (!what) return std::nullopt;
  return failure{c, *first, *second, *what};
}

/// The cases that are simpler than c in one place, of which as much is known.
std::vector<integral_case> simpler(const integral_case& c) {
  std::vector<integral_case> result;
  const auto with = [&](const auto& change) {
    integral_case less = c;
    change(less);
    result.push_back(std::move(less));
  };
  for (const long digits : {3L, 5L, 10L, 15L, 20L}) {
    if (digits < c.digits) with([&](integral_case& less) { less.digits = digits; });
  }
  if (c.diverges || c.value || !c.parts.empty()) return result;
  if (c.antiderivative) {
    for (const term& f : smaller(*c.antiderivative)) {
      with([&](integral_case& less) {
        less.antiderivative = f;
        less.integrand = derivative(f);
      });
    }
  } else {
    for (const term& f : smaller(c.integrand)) {
      with([&](integral_case& less) { less.integrand = f; });
    }
  }
  for (const term& a : smaller(c.from)) with([&](integral_case& less) { less.from = a; });
  for (const term& b : smaller(c.to)) with([&](integral_case& less) { less.to = b; });
  return result;
}

long size_of(const integral_case& c) {
  return c.integrand.size() + c.from.size() + c.to.size() + c.digits;
}

failure shrunk(failure f) {
  int tries = 600;
  for (bool is_smaller = true; is_smaller && tries > 0;) {
    is_smaller = false;
    std::vector<integral_case> candidates = simpler(f.c);
    std::stable_sort(
        candidates.begin(), candidates.end(),
        [](const integral_case& a, const integral_case& b) { return size_of(a) < size_of(b); });
    for (const integral_case& less : candidates) {
      if (size_of(less) >= size_of(f.c) || --tries < 0) break;
      if (auto still = failing(less, f.first.by, f.first.seed, f.second.by, f.second.seed)) {
        f = std::move(*still);
        is_smaller = true;
        break;
      }
    }
  }
  return f;
}

void examine_by(const integral_case& given, const std::vector<way>& ways, std::uint64_t seed,
                counts& c) {
  ++c.cases;
  // What is known of the case does not matter to routes that know nothing of it, and stands in the
  // way of shrinking.
  integral_case bare{given.integrand, given.from, given.to, given.digits};
  bare.is_cheap = given.is_cheap;
  std::vector<result> results;
  for (const way w : ways) {
    const auto r = route_of(given, w, seed);
    if (!r) continue;
    std::string commands;
    for (const piece& p : r->pieces) commands += command_of(p) + "; ";
    under_way(commands);
    results.push_back(computed(given, w, seed, *r));
    const result& last = results.back();
    c.computed += last.integrals;
    if (results.size() == 1) ++(last.certified ? c.certified : c.refused);
    if (given.diverges) {
      ++c.checks;
      if (!last.certified) continue;
      ++c.wrong;
      ADD_FAILURE() << "certified, though the integral diverges\n" << described(last, given.digits);
      return;
    }
    for (std::size_t k = 0; k + 1 < results.size(); ++k) {
      const result& other = results[k];
      if (other.enclosure.is_bounded() && last.enclosure.is_bounded()) ++c.checks;
      const auto what = contradiction(other, last);
      if (!what) continue;
      ++c.wrong;
      const bool is_bare = !other.by.is_knowledge() && !last.by.is_knowledge();
      const failure f = shrunk({is_bare ? bare : given, other, last, *what});
      ADD_FAILURE() << *what << '\n'
                    << described(other, given.digits) << described(last, given.digits)
                    << "shrunk: " << f.what << '\n'
                    << described(f.first, f.c.digits) << described(f.second, f.c.digits);
      return;
    }
  }
}

}  // namespace

std::string command_of(const piece& p) {
  std::string text = fmt::format("polhode integrate {} --from {} --to {} --digits {}",
                                 quoted(p.integrand), quoted(p.from), quoted(p.to), p.digits);
  if (p.rule != quadrature_rule::automatic) text += " --rule " + p.rule.word();
  return text;
}

integral computed(const piece& p) {
  try {
    return detail::integrate_function(integrand_of(read(p.integrand, {"x"})), read_limit(p.from),
                                      read_limit(p.to),
                                      {.digits = p.digits + 1,
                                       .most_evaluations = p.most_evaluations,
                                       .most_precision = 1L << 13,
                                       .rule = p.rule});
  } catch (const input_error& error) {
    integral refused;
    refused.why = reason::not_defined;
    refused.obstacle = error.what();
    return refused;
  }
}

std::function<integral_case(maker&)> mostly_cheap(std::function<integral_case(maker&)> make) {
  return [make = std::move(make)](maker& m) {
    integral_case c = make(m);
    c.is_cheap = !m.one_in(10);
    if (c.is_cheap) c.digits = m.between(2, 8);
    return c;
  };
}

void examine(const integral_case& given, std::uint64_t seed, counts& c) {
  maker m(seed ^ 0x5bd1e995U);
  std::vector<way> ways{way{}};
  for (const way& w : every_way()) {
    if (w == way{}) continue;
    const bool is_panels = w.rule == quadrature_rule::gauss_legendre;
    if (w.is_knowledge() || m.one_in(is_panels ? 2 : 4)) ways.push_back(w);
  }
  examine_by(given, ways, seed, c);
}

void examine_thoroughly(const integral_case& given, std::uint64_t seed, counts& c) {
  examine_by(given, every_way(), seed, c);
}

}  // namespace polhode::differential
