#include "quadrature/ends/end_series.hpp"

#include <algorithm>

#include "polhode/arithmetic/special_functions.hpp"
#include "polhode/expression/evaluation.hpp"

namespace polhode {

namespace {

template <class Jet>
Jet without_last(const Jet& x, int order) {
  Jet r(order);
  for (int k = 0; k <= order; ++k) r[k] = x[k];
  return r;
}

const known_number& mean_of(const known_number& x) { return x; }
region mean_of(const region& x) { return x.convex_hull(); }

/// G's jet -> that of G/t, of one order less: at 0 its coefficients, moved down, and over the
/// square means of them.
template <class Jet>
Jet divided_by_t(const Jet& x) {
  Jet r(x.order() - 1);
  for (int k = 0; k < x.order(); ++k) r[k] = mean_of(x[k + 1]);
  return r;
}

/// G's jet -> that of t G, where t is at x: (t G)_k = x G_k + G_(k-1).
template <class Jet, class Scalar>
void times_distance(Jet& g, const Scalar& x) {
  for (int k = g.order(); k > 0; --k) g[k] = x * g[k] + g[k - 1];
  g[0] = x * g[0];
}

}  // namespace

using remedy = end_series::remedy;

end_series end_series::blocked(std::string_view where, remedy r) {
  end_series result;
  result.where_ = where;
  result.remedy_ = r;
  return result;
}

end_series end_series::with_any_remedy() const {
  end_series r = *this;
  r.remedy_ = remedy::unknown;
  return r;
}

end_series end_series::constant(const known_number& at_0, const region& over) const {
  if (blocked_) return *this;  // it has no order to be like
  end_series r;
  r.blocked_ = false;
  r.r_ = r_;
  const int n = terms_.front().at_0.order();
  r.terms_.push_back({centre_jet::constant(at_0, n), square_jet::constant(over, n)});
  return r;
}

end_series end_series::bounded_like(const magnitude& most) const {
  const ball real = ball(0, bits).enlarged(most);
  return constant(known_number(real), region(complex_ball(real, real)));
}

end_series end_series::argument(const known_number& a, const known_number& s, long q, double r,
                                int orders) {
  end_series t;
  t.blocked_ = false;
  t.r_ = r;
  const double_interval side(-r, r);
  t.terms_.push_back({centre_jet::variable(known_number(), orders),
                      square_jet::variable(region(side, side), orders)});
  if (q < 0) {
    end_series x = t.constant(s, region(s.enclosure()));
    x.m_ = q;
    return x;
  }
  end_series moving = t.constant(s, region(s.enclosure()));
  moving.m_ = q;
  return t.constant(a, region(a.enclosure())) + moving;
}

/// Blocked where a coefficient is undefined or not analytic; with the G_k(0) settled.
end_series end_series::checked(std::string_view name) && {
  if (blocked_) return std::move(*this);
  for (term& g : terms_) {
    for (int k = 0; k <= g.at_0.order(); ++k) {
      if (g.at_0[k].enclosure().is_undefined() || !g.over[k].is_analytic()) {
        return blocked(name, remedy::smaller_square);
      }
    }
    g.at_0[0] = settled(g.at_0[0]);
  }
  return std::move(*this);
}

end_series end_series::with_value_at_0(const rational& q) const {
  if (blocked_ || m_ != 0 || log_degree() != 0) return *this;
  if (!contains(terms_.front().at_0[0].enclosure(), q)) return blocked("a contradiction");
  end_series r = *this;
  r.terms_.front().at_0[0] = known_number(q);
  return r;
}

magnitude end_series::supremum(int k) const {
  if (blocked_) return magnitude::infinity();
  return terms_[static_cast<std::size_t>(k)].over[0].magnitude_upper();
}

/// G -> G/t, where G(0) = 0.
void end_series::divide_by_t(term& g) {
  g = {divided_by_t(g.at_0), divided_by_t(g.over)};
  g.at_0[0] = settled(g.at_0[0]);
}

/// The same function with m less by so many powers: each G_k times t^powers, powers >= 0.
end_series end_series::moved(long powers) const {
  if (powers > 64) return blocked("a high power of the distance", remedy::none);
  end_series r = *this;
  r.m_ -= powers;
  const double_interval side(-r_, r_);
  const region square(side, side);
  for (term& g : r.terms_) {
    for (long k = 0; k < powers; ++k) {
      times_distance(g.at_0, known_number());
      times_distance(g.over, square);
    }
  }
  return r;
}

end_series operator-(const end_series& x) {
  if (x.blocked_) return x;
  end_series r = x;
  for (auto& g : r.terms_) {
    g.at_0 = -g.at_0;
    g.over = -g.over;
  }
  return r;
}

end_series operator+(const end_series& x, const end_series& y) {
  if (x.blocked_) return x;
  if (y.blocked_) return y;
  const rational difference = x.m_ - y.m_;
  if (denominator(difference) != 1 && (x.is_zero() || y.is_zero())) return x.is_zero() ? y : x;
  if (denominator(difference) != 1)
    return end_series::blocked("+ (of different roots)", remedy::other_root);
  if (difference > 0) return y + x;
  if (difference < -64) return end_series::blocked("+ (of very different powers)", remedy::none);
  end_series r = x;
  end_series other = y.moved(static_cast<long>(-numerator(difference)));
  if (other.blocked_) return other;
  const int n = std::min(r.terms_.front().at_0.order(), other.terms_.front().at_0.order());
  const std::size_t count = std::max(r.terms_.size(), other.terms_.size());
  std::vector<end_series::term> sum;
  for (std::size_t k = 0; k < count; ++k) {
    const auto cut = [&](const end_series::term& g) {
      return end_series::term{without_last(g.at_0, n), without_last(g.over, n)};
    };
    if (k >= r.terms_.size()) {
      sum.push_back(cut(other.terms_[k]));
    } else if (k >= other.terms_.size()) {
      sum.push_back(cut(r.terms_[k]));
    } else {
      const auto a = cut(r.terms_[k]);
      const auto b = cut(other.terms_[k]);
      sum.push_back({a.at_0 + b.at_0, a.over + b.over});
    }
  }
  r.terms_ = std::move(sum);
  // What is 0 at every order known may have lost its logarithm: x log x - log x^x.
  while (r.terms_.size() > 1) {
    const auto& last = r.terms_.back();
    bool zero = last.over[0].magnitude_upper().is_zero();
    if (!zero) break;
    r.terms_.pop_back();
  }
  return std::move(r).checked("+");
}

end_series operator*(const end_series& x, const end_series& y) {
  if (x.blocked_) return x;
  if (y.blocked_) return y;
  const int n = std::min(x.terms_.front().at_0.order(), y.terms_.front().at_0.order());
  end_series r;
  r.blocked_ = false;
  r.r_ = x.r_;
  r.m_ = x.m_ + y.m_;
  const std::size_t count = x.terms_.size() + y.terms_.size() - 1;
  if (count > 8) return end_series::blocked("* (a high power of a logarithm)", remedy::none);
  std::vector<std::optional<end_series::term>> product(count);
  for (std::size_t i = 0; i < x.terms_.size(); ++i) {
    for (std::size_t j = 0; j < y.terms_.size(); ++j) {
      end_series::term g{without_last(x.terms_[i].at_0, n) * without_last(y.terms_[j].at_0, n),
                         without_last(x.terms_[i].over, n) * without_last(y.terms_[j].over, n)};
      auto& target = product[i + j];
      if (target) {
        target->at_0 += g.at_0;
        target->over += g.over;
      } else {
        target = std::move(g);
      }
    }
  }
  for (auto& g : product) r.terms_.push_back(std::move(*g));
  return std::move(r).checked("*");
}

end_series end_series::simplified() const {
  end_series r = *this;
  if (blocked_) return r;
  const auto vanish = [&] {
    return std::all_of(r.terms_.begin(), r.terms_.end(),
                       [](const term& g) { return g.at_0[0].is_zero() && g.at_0.order() > 0; });
  };
  while (vanish()) {
    for (term& g : r.terms_) divide_by_t(g);
    r.m_ += 1;
  }
  return r;
}

end_series end_series::coefficient(int k) const {
  end_series r = *this;
  if (!blocked_) r.terms_ = {terms_[static_cast<std::size_t>(k)]};
  return r.simplified();
}

std::optional<known_number> end_series::value_at_0() const {
  if (blocked_ || m_ != 0 || log_degree() != 0) return std::nullopt;
  return terms_.front().at_0[0];
}

bool end_series::leads_surely() const {
  return !blocked_ && !contains_zero(terms_.back().at_0[0].enclosure());
}

magnitude end_series::size_at_0() const {
  if (blocked_) return magnitude::infinity();
  return terms_.back().at_0[0].enclosure().magnitude_upper();
}

end_series end_series::normalised(std::string_view name) const {
  if (blocked_) return *this;
  if (log_degree() != 0) return blocked(name, remedy::none);
  end_series r = *this;
  term& g = r.terms_.front();
  while (g.at_0[0].is_zero()) {
    if (g.at_0.order() < 1) return blocked(name, remedy::more_orders);
    divide_by_t(g);
    r.m_ += 1;
  }
  if (contains_zero(g.at_0[0].enclosure())) return blocked(name, remedy::none);
  if (g.over[0].magnitude_lower().is_zero()) return blocked(name, remedy::smaller_square);
  return r;
}

end_series end_series::plain(std::string_view name) const {
  if (blocked_) return *this;
  if (log_degree() != 0) return blocked(name, remedy::none);
  if (m_ == 0) return *this;
  if (m_ > 0 && denominator(m_) == 1 && m_ <= 64) return moved(static_cast<long>(numerator(m_)));
  if (m_ < 0) {
    // A quotient may have hidden a zero: t^-2 (t^2 + ...).
    end_series r = *this;
    while (r.m_ < 0 && r.terms_.front().at_0[0].is_zero() && r.terms_.front().at_0.order() > 0) {
      term& g = r.terms_.front();
      divide_by_t(g);
      r.m_ += 1;
    }
    if (r.m_ == 0) return r;
    const bool hidden = r.terms_.front().at_0[0].is_zero();
    return blocked(name, hidden ? remedy::more_orders : remedy::none);
  }
  return blocked(name, denominator(m_) != 1 ? remedy::other_root : remedy::none);
}

end_series operator/(const end_series& x, const end_series& y) {
  if (x.blocked_) return x;
  end_series d = y.normalised("/");
  if (d.blocked_) return d;
  end_series inverse = d;
  inverse.m_ = -d.m_;
  auto& g = inverse.terms_.front();
  const int n = g.at_0.order();
  g.at_0 = end_series::centre_jet::constant(known_number(rational(1)), n) / g.at_0;
  g.over = end_series::square_jet::constant(region(double_interval(1)), n) / g.over;
  return (x * std::move(inverse).checked("/")).checked("/");
}

end_series::term end_series::with_orders(const term& g, int n) {
  term result{centre_jet::constant(g.at_0[0], n), square_jet::constant(g.over[0], n)};
  for (int k = 1; k <= n; ++k) {
    result.at_0[k] = g.at_0[k];
    result.over[k] = g.over[k];
  }
  return result;
}

/// f applied to both jets of a series without power and logarithm.
template <class F>
end_series end_series::regular(const end_series& x, std::string_view name, F&& f) {
  end_series r = x.plain(name);
  if (r.blocked_) return r;
  term& g = r.terms_.front();
  g = {f(g.at_0), f(g.over)};
  return std::move(r).checked(name);
}

end_series end_series::composed(std::string_view name,
                                const std::function<known_number(const known_number&)>& value,
                                const std::function<region(const region&)>& over,
                                const std::function<end_series(const end_series&)>& slope) const {
  constexpr int most = 5;
  end_series r = plain(name);
  if (r.blocked_) return r;
  const term x = r.terms_.front();
  int n = std::min(x.at_0.order(), most);
  term h;
  if (n > 0) {
    end_series lower = r;
    lower.terms_.front() = with_orders(x, n - 1);
    const end_series derivative = slope(lower).plain(name);
    if (derivative.blocked_) return blocked(name, derivative.remedy_);
    h = derivative.terms_.front();
    n = std::min(n, h.at_0.order() + 1);
  }
  const auto jet_of = [n](const auto& inner, const auto& outer, const auto& first) {
    auto g = std::remove_cvref_t<decltype(inner)>::constant(first, n);
    for (int k = 1; k <= n; ++k) {
      auto sum = inner[1] * outer[k - 1];
      for (int j = 2; j <= k; ++j) sum = sum + inner[j] * outer[k - j] * static_cast<long>(j);
      g[k] = sum / static_cast<long>(k);
    }
    return g;
  };
  r.terms_.front() = {jet_of(x.at_0, h.at_0, value(x.at_0[0])),
                      jet_of(x.over, h.over, over(x.over[0]))};
  return std::move(r).checked(name);
}

end_series sqrt(const end_series& x) { return pow(x, rational(1, 2)); }

end_series pow(const end_series& x, long n) {
  if (x.blocked_) return x;
  if (n < 0) return x.constant_like(1) / pow(x, -n);
  end_series result = x.constant_like(1);
  // Not t^0 G with G(0) = 0, whose n-th power is not seen to be t^n times what is not 0.
  end_series base = x.simplified();
  for (auto k = static_cast<unsigned long>(n); k != 0; k >>= 1) {
    if ((k & 1) != 0) result = result * base;
    if (k > 1) base = base * base;
  }
  return result;
}

/// (t^m G)^e = t^(m e) exp(e log G), for G > 0 at 0.
end_series pow(const end_series& x, const rational& e) {
  if (x.blocked_) return x;
  if (denominator(e) == 1 && abs(numerator(e)) <= 1'000'000'000) {
    return pow(x, static_cast<long>(numerator(e)));
  }
  end_series r = x.normalised("pow");
  if (r.blocked_) return r;
  auto& g = r.terms_.front();
  if (!certainly_positive(g.at_0[0].enclosure())) {
    return end_series::blocked("pow", remedy::none);
  }
  r.m_ *= e;
  if (e == rational(1, 2)) {
    g = {sqrt(g.at_0), sqrt(g.over)};
  } else {
    g = {exp(log(g.at_0) * known_number(e)), exp(log(g.over) * e)};
  }
  return std::move(r).checked("pow");
}

end_series pow(const end_series& x, const end_series& y) { return exp(y * log(x)); }

/// log(t^m G) = m L + log G.
end_series log(const end_series& x) {
  end_series r = x.normalised("log");
  if (r.blocked_) return r;
  const rational m = r.m_;
  r.m_ = 0;
  {
    auto& g = r.terms_.front();
    if (!certainly_positive(g.at_0[0].enclosure())) {
      return end_series::blocked("log", remedy::none);
    }
    g = {log(g.at_0), log(g.over)};
  }
  if (m != 0) {
    const end_series slope = r.constant_like(m);
    r.terms_.push_back(slope.terms_.front());
  }
  return std::move(r).checked("log");
}

/// exp(m L + G) = t^m exp(G), where m is a known rational number: G_1 is m at 0, and its slope is 0
/// all over the square. Where no slope is known (at order 0) G_1 may move.
end_series exp(const end_series& x) {
  if (!x.blocked_ && x.log_degree() == 1 && x.m_ == 0) {
    const auto& slope = x.terms_[1];
    const bool is_constant = slope.at_0[0].exact().has_value() && slope.at_0.order() >= 1 &&
                             slope.over[1].magnitude_upper().is_zero();
    if (is_constant) {
      end_series r = x;
      r.m_ = *slope.at_0[0].exact();
      r.terms_.pop_back();
      auto& g = r.terms_.front();
      g = {exp(g.at_0), exp(g.over)};
      return std::move(r).checked("exp");
    }
  }
  return end_series::regular(x, "exp", [](const auto& g) { return exp(g); });
}

#define POLHODE_REGULAR(f)                                                 \
  end_series f(const end_series& x) {                                      \
    return end_series::regular(x, #f, [](const auto& g) { return f(g); }); \
  }
POLHODE_REGULAR(sin)
POLHODE_REGULAR(cos)
POLHODE_REGULAR(sinh)
POLHODE_REGULAR(cosh)
#undef POLHODE_REGULAR

/// By exponentials where the argument has a logarithm: e^(m L) is t^m.
end_series tanh(const end_series& x) {
  end_series r = end_series::regular(x, "tanh", [](const auto& g) { return tanh(g); });
  if (!r.blocked_ || x.blocked_ || x.log_degree() == 0) return r;
  end_series other = 1 - 2 / (exp(x * 2) + 1);
  return other.blocked_ ? r : other;
}

namespace {

/// erf of a jet, of which the value is given: erf(x)' = (2/sqrt(pi)) e^(-x^2) x', so that
/// k erf(x)_k = (2/sqrt(pi)) times the sum of j x_j (e^(-x^2))_(k-j) over 1 <= j <= k.
template <class T>
jet<T, dynamic_order> erf_of(const jet<T, dynamic_order>& x, const T& value, const T& factor) {
  const jet<T, dynamic_order> bell = exp(-(x * x));
  jet<T, dynamic_order> result = x;
  result[0] = value;
  for (int k = 1; k <= x.order(); ++k) {
    T sum = x[1] * bell[k - 1];
    for (int j = 2; j <= k; ++j) sum = sum + x[j] * bell[k - j] * static_cast<long>(j);
    result[k] = sum * factor / static_cast<long>(k);
  }
  return result;
}

}  // namespace

end_series erf(const end_series& x) {
  const known_number factor =
      known_number(rational(2)) / sqrt(known_number(pi_combination{0, 1}, end_series::bits));
  end_series r = x.plain("erf");
  if (r.blocked_) return r;
  auto& g = r.terms_.front();
  const known_number& c = g.at_0[0];
  const known_number value = c.is_zero() ? c : known_number::made("erf", erf(c.enclosure()), c);
  g.at_0 = erf_of(g.at_0, value, factor);
  g.over = erf_of(g.over, detail::named<detail::operation::erf>::over(g.over[0]),
                  region(factor.enclosure()));
  return std::move(r).checked("erf");
}
end_series erfc(const end_series& x) { return x.is_blocked() ? x : 1 - erf(x); }

/// Also at a pole, by the quotient.
end_series tan(const end_series& x) {
  end_series r = end_series::regular(x, "tan", [](const auto& g) { return tan(g); });
  if (!r.blocked_ || x.blocked_) return r;
  end_series quotient = sin(x) / cos(x);
  return quotient.blocked_ ? r.with_any_remedy() : quotient;
}

/// r pi, exactly.
static end_series half_turns_like(const end_series& x, const rational& r) {
  return x.constant_like(known_number(pi_combination{0, r}));
}

// At infinity: atan w = +-pi/2 - atan(1/w), and asinh w = +-log(|w| + sqrt(w^2 + 1)), with the sign
// of w.
end_series atan(const end_series& x) {
  const int sign = !x.blocked_ && x.m_ < 0 ? x.sign() : 0;
  if (sign != 0) {
    const end_series inverse = 1 / x;
    return half_turns_like(inverse, rational(sign, 2)) -
           end_series::regular(inverse, "atan", [](const auto& g) { return atan(g); });
  }
  return end_series::regular(x, "atan", [](const auto& g) { return atan(g); }).with_any_remedy();
}
end_series asinh(const end_series& x) {
  const int sign = !x.blocked_ && x.m_ < 0 ? x.sign() : 0;
  if (sign < 0) return -asinh(-x);
  if (sign > 0) return log(x + sqrt(x * x + 1));
  return end_series::regular(x, "asinh", [](const auto& g) { return asinh(g); }).with_any_remedy();
}

bool end_series::tends_to_0() const {
  const end_series s = simplified();
  return !s.blocked_ && s.exponent() > 0;
}
std::optional<long> end_series::exact_value_at_0() const {
  constexpr long most = 1'000'000'000;
  const end_series p = plain("");
  if (p.blocked_) return std::nullopt;
  const known_number& c = p.terms_.front().at_0[0];
  if (!(c.enclosure().magnitude_upper() < ball(most, bits).magnitude_lower())) return std::nullopt;
  const auto nearest = static_cast<long>(floor_of(lower_rational(c.enclosure()) + rational(1, 2)));
  const known_number rest = c - nearest;
  if (!contains_zero(rest.enclosure()) || !settled(rest).is_zero()) return std::nullopt;
  return nearest;
}

// The inverse functions at the ends of their domains, by the roots that they have there:
// acos w = 2 asin sqrt((1 - w)/2), and asin w = pi/2 - acos w, for -1 < w <= 1; asin is odd.
end_series acos(const end_series& x) {
  if (x.blocked_) return x;
  const std::optional<long> start = x.exact_value_at_0();
  if (start && *start == 1) return 2 * asin(sqrt((1 - x) / 2));
  if (start && *start == -1) return half_turns_like(x, 1) - acos(-x);
  return end_series::regular(x, "acos", [](const auto& g) { return acos(g); });
}
end_series asin(const end_series& x) {
  if (x.blocked_) return x;
  const std::optional<long> start = x.exact_value_at_0();
  if (start && *start == 1) return half_turns_like(x, rational(1, 2)) - acos(x);
  if (start && *start == -1) return acos(-x) - half_turns_like(x, rational(1, 2));
  return end_series::regular(x, "asin", [](const auto& g) { return asin(g); });
}
// acosh w = 2 asinh sqrt((w - 1)/2) for w >= 1; acosh w = log(w + sqrt((w - 1)(w + 1))) at
// infinity.
end_series acosh(const end_series& x) {
  if (x.blocked_) return x;
  const std::optional<long> start = x.exact_value_at_0();
  if (start && *start == 1) return 2 * asinh(sqrt((x - 1) / 2));
  if (x.m_ < 0 && x.sign() > 0) return log(x + sqrt(x * x - 1));
  return end_series::regular(x, "acosh", [](const auto& g) { return acosh(g); }).with_any_remedy();
}
end_series atanh(const end_series& x) {
  if (x.blocked_) return x;
  const std::optional<long> start = x.exact_value_at_0();
  if (start && (*start == 1 || *start == -1)) return (log(1 + x) - log(1 - x)) / 2;
  return end_series::regular(x, "atanh", [](const auto& g) { return atanh(g); });
}

/// The sign of t^m G for 0 < t <= r: G is real there and has no zero in the square.
/// By Taylor's theorem, with Lagrange's remainder: for real t in (0, r] and any k
/// G(t) = g_0 + g_1 t + ... + g_(k-1) t^(k-1) + (G^(k)(s)/k!) t^k for an s in (0, t), which lies in
/// the square. G is real there, so that the remainder lies in the real part of what encloses it.
int end_series::sign() const {
  if (blocked_ || log_degree() != 0) return 0;
  const end_series n = simplified();
  const term& g = n.terms_.front();
  const ball t = hull(ball(0, bits), ball::exactly(r_, bits));
  for (int k = 0; k <= g.over.order(); ++k) {
    ball values = to_ball(g.over[k].re(), bits);
    for (int i = k; i-- > 0;) values = g.at_0[i].enclosure() + t * values;
    if (certainly_positive(values)) return 1;
    if (certainly_negative(values)) return -1;
  }
  return 0;
}

magnitude end_series::infimum() const {
  if (blocked_ || log_degree() != 0) return {};
  return terms_.front().over[0].magnitude_lower();
}

double_interval end_series::real_range() const {
  if (blocked_) return double_interval::undefined();
  const end_series p = plain("");
  if (!p.blocked_) return p.terms_.front().over[0].re();
  if (log_degree() != 0 || m_ <= 0) return double_interval::undefined();
  // 0 < t^m <= r^m.
  const ball power = pow(ball::exactly(r_, 64), ball(m_, 64));
  return hull(double_interval(0), double_interval::from_ball(power)) * terms_.front().over[0].re();
}

/// Where the k-th derivative of G is 0 all over the square, G is a polynomial of degree below k: it
/// is 0 where its coefficients at 0 are.
bool end_series::is_zero() const {
  if (blocked_) return false;
  return std::all_of(terms_.begin(), terms_.end(), [](const term& g) {
    for (int k = 0; k <= g.over.order(); ++k) {
      if (g.over[k].magnitude_upper().is_zero()) return true;
      if (k > g.at_0.order() || !settled(g.at_0[k]).is_zero()) return false;
    }
    return false;
  });
}

std::optional<rational> end_series::rational_constant() const {
  if (blocked_ || m_ != 0 || log_degree() != 0) return std::nullopt;
  const std::optional<rational> value = terms_.front().at_0[0].exact();
  const bool is_constant = value && (*this - constant_like(*value)).is_zero();
  return is_constant ? value : std::nullopt;
}

end_series abs(const end_series& x) {
  if (x.blocked_) return x;
  const int s = x.sign();
  if (s == 0) return end_series::blocked("abs");
  return s > 0 ? x : -x;
}
end_series min(const end_series& x, const end_series& y) {
  end_series difference = x - y;
  if (difference.is_blocked()) return difference;
  const int s = difference.sign();
  if (s == 0) return end_series::blocked("min");
  return s < 0 ? x : y;
}
end_series max(const end_series& x, const end_series& y) { return -min(-x, -y); }

/// n where n < x < n + 1 for 0 < t <= r.
end_series floor(const end_series& x) {
  end_series p = x.plain("floor");
  if (p.is_blocked()) return p.with_any_remedy();
  const ball candidate = floor(p.terms_.front().at_0[0].enclosure());
  for (const long step : {0L, -1L}) {
    if (!candidate.is_exact()) break;
    const ball n = candidate + step;
    const end_series above = p - n;
    const end_series below = (n + 1) - p;
    if (above.sign() > 0 && below.sign() > 0) return p.constant_like(n);
  }
  return end_series::blocked("floor");
}
end_series ceil(const end_series& x) { return -floor(-x); }

}  // namespace polhode
