#include "oscillation.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "quadrature/formula/recorded_formula.hpp"

namespace polhode::detail {

namespace {

/// q times a constant of the recording; q alone where there is none.
struct coefficient {
  rational q = 1;
  std::optional<recorded> node;
};

/// About how long the numerator and the denominator are.
std::size_t bits_of(const rational& q) {
  return mpz_sizeinbase(numerator(q).backend().data(), 2) +
         mpz_sizeinbase(denominator(q).backend().data(), 2);
}
/// Longer numbers are not followed: nested powers would make them as long as they like.
constexpr std::size_t most_exact_bits = 4096;

/// The sum of c_e y^e, without zeros.
using power_sum = std::map<rational, coefficient>;

/// The sum of q_n times constants by the numbers of their nodes; 0, the argument's, stands for 1.
using frequency = std::map<std::size_t, rational>;

/// u + i v, 0 where there is none.
struct amplitude {
  std::optional<recorded> re;
  std::optional<recorded> im;
};

/// The sum of amplitudes times e^(i w y). Real for real y: the amplitudes of w and -w are conjugate.
struct wave {
  std::map<frequency, amplitude> terms;
  /// Where there is no oscillation, and it is known.
  std::optional<power_sum> powers;

  /// Only the frequency without terms, which is 0.
  [[nodiscard]] bool is_steady() const {
    return terms.empty() || (terms.size() == 1 && terms.begin()->first.empty());
  }
};

std::optional<recorded> sum_of(const std::optional<recorded>& x, const std::optional<recorded>& y) {
  if (!x || !y) return x ? x : y;
  return *x + *y;
}
std::optional<recorded> negative(const std::optional<recorded>& x) {
  return x ? std::optional(-*x) : std::nullopt;
}
std::optional<recorded> product(const std::optional<recorded>& x,
                                const std::optional<recorded>& y) {
  return x && y ? std::optional(*x * *y) : std::nullopt;
}
amplitude operator+(const amplitude& x, const amplitude& y) {
  return {sum_of(x.re, y.re), sum_of(x.im, y.im)};
}
amplitude operator*(const amplitude& x, const amplitude& y) {
  return {sum_of(product(x.re, y.re), negative(product(x.im, y.im))),
          sum_of(product(x.re, y.im), product(x.im, y.re))};
}
amplitude conjugate(const amplitude& x) { return {x.re, negative(x.im)}; }

frequency sum_of(frequency x, const frequency& y) {
  for (const auto& [node, q] : y) {
    rational& sum = x[node];
    sum += q;
    if (sum == 0) x.erase(node);
  }
  return x;
}
frequency negative(frequency x) {
  for (auto& [node, q] : x) q = -q;
  return x;
}

/// u + i v in any arithmetic.
class program {
 public:
  program(recorded y, const amplitude& a) : y_(std::move(y)) {
    for (const auto* part : {&a.re, &a.im}) {
      results_.push_back(*part ? std::optional((*part)->node()) : std::nullopt);
    }
    prepare();
  }
  program(recorded y, std::size_t node) : y_(std::move(y)), results_{node} { prepare(); }

  /// Part k, if it is not 0, at a point.
  template <class T>
  [[nodiscard]] std::vector<std::optional<T>> operator()(const T& z) const {
    evaluation<T> values(y_.nodes(), z);
    for (const std::size_t i : steps_) values.step(i, std::nullopt);
    std::vector<std::optional<T>> parts;
    parts.reserve(results_.size());
    for (const auto& node : results_) {
      parts.push_back(node ? std::optional<T>(values[*node]) : std::nullopt);
    }
    return parts;
  }

 private:
  void prepare() {
    const recorded_nodes& nodes = y_.nodes();
    std::vector<bool> needed(nodes.size());
    for (const auto& node : results_) {
      if (node) needed[*node] = true;
    }
    for (std::size_t i = nodes.size(); i-- > 0;) {
      const recorded_node& node = nodes[i];
      if (!needed[i]) continue;
      steps_.push_back(i);
      if (node.what == recorded_node::kind::function) needed[node.left] = needed[node.right] = true;
      if (node.what == recorded_node::kind::power) needed[node.left] = true;
    }
    std::reverse(steps_.begin(), steps_.end());
  }

  recorded y_;
  std::vector<std::optional<std::size_t>> results_;
  std::vector<std::size_t> steps_;
};

/// f(x) times a factor as a function of y, taken apart. The recording that is made does not depend on the precision, but
/// for the enclosures of its constants.
class splitter {
 public:
  splitter(const formula& f, precision p, const end_point& at, const end_point& s,
           const rational& theta, int sign)
      : nodes_(f.at(p)), f_(f), bits_(p), y_(recorded::argument()) {
    const coefficient start = constant(at, p);
    const coefficient distance = constant(s, p);
    x_.powers = power_sum{{theta, distance}};
    if (start.q != 0) x_.powers->emplace(rational(0), start);
    x_.terms[{}].re = value(*x_.powers);
    const rational size = sign * abs(theta);
    const coefficient scale{distance.q * size, distance.node};
    factor_ = value({{rational(theta - 1), scale}});
  }

  /// False where f is not a sum of oscillations.
  [[nodiscard]] bool split() {
    std::vector<std::optional<wave>> waves(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!f_.needs(i)) continue;
      waves[i] = of_node(nodes_[i], waves);
      if (!waves[i]) return false;
    }
    for (const auto& [w, a] : waves[f_.result()]->terms) {
      result_.terms[w] = amplitude{factor_, std::nullopt} * a;
    }
    return true;
  }
  [[nodiscard]] const wave& result() const { return result_; }
  /// Where the phase grows like another power than y.
  [[nodiscard]] const std::optional<rational>& growth() const { return growth_; }
  [[nodiscard]] const recorded& argument() const { return y_; }

 private:
  [[nodiscard]] coefficient constant(const end_point& x, precision p) const {
    if (x.exact()) return {*x.exact(), std::nullopt};
    return {1, y_.constant_like(x.at(p))};
  }
  [[nodiscard]] recorded value(const coefficient& c) const {
    if (!c.node) return y_.constant_like(c.q);
    return c.q == 1 ? *c.node : *c.node * c.q;
  }
  [[nodiscard]] recorded value(const power_sum& x) const {
    std::optional<recorded> sum;
    for (const auto& [e, c] : x) {
      if (e == 0) {
        sum = sum_of(sum, value(c));
        continue;
      }
      const recorded power = e == 1 ? y_ : pow(y_, e);
      sum = sum_of(sum, !c.node && c.q == 1 ? power : power * value(c));
    }
    return sum ? *sum : y_.constant_like(0);
  }
  /// Of a steady one.
  [[nodiscard]] recorded value(const wave& x) const {
    if (x.terms.empty() || !x.terms.begin()->second.re) return y_.constant_like(0);
    return *x.terms.begin()->second.re;
  }

  [[nodiscard]] wave steady(recorded value, std::optional<power_sum> powers = {}) const {
    wave result;
    if (!powers || !powers->empty()) result.terms[{}].re = std::move(value);
    result.powers = std::move(powers);
    return result;
  }
  [[nodiscard]] static bool is_constant(const wave& x) {
    return x.powers && std::all_of(x.powers->begin(), x.powers->end(),
                                   [](const auto& term) { return term.first == 0; });
  }

  static coefficient times(const coefficient& x, const coefficient& y) {
    coefficient result{x.q * y.q, x.node};
    if (y.node) result.node = x.node ? *x.node * *y.node : *y.node;
    return result;
  }
  void add(power_sum& sum, const rational& e, const coefficient& c) const {
    const auto [place, is_new] = sum.emplace(e, c);
    if (is_new) return;
    coefficient& known = place->second;
    const bool same = known.node.has_value() == c.node.has_value() &&
                      (!c.node || known.node->node() == c.node->node());
    if (same) {
      known.q += c.q;
      if (known.q == 0) sum.erase(place);
    } else {
      known = {1, value(known) + value(c)};
    }
  }
  [[nodiscard]] std::optional<power_sum> sum_of_powers(const wave& x, const wave& y) const {
    if (!x.powers || !y.powers) return std::nullopt;
    power_sum sum = *x.powers;
    for (const auto& [e, c] : *y.powers) add(sum, e, c);
    return unless_long(std::move(sum));
  }
  [[nodiscard]] std::optional<power_sum> product_of_powers(const wave& x, const wave& y) const {
    constexpr std::size_t most_terms = 16;
    if (!x.powers || !y.powers || x.powers->size() * y.powers->size() > most_terms) {
      return std::nullopt;
    }
    power_sum sum;
    for (const auto& [e, c] : *x.powers) {
      for (const auto& [g, d] : *y.powers) add(sum, e + g, times(c, d));
    }
    return unless_long(std::move(sum));
  }
  [[nodiscard]] static std::optional<power_sum> unless_long(power_sum x) {
    const bool is_long = std::any_of(x.begin(), x.end(), [](const auto& term) {
      return bits_of(term.first) + bits_of(term.second.q) > most_exact_bits;
    });
    return is_long ? std::nullopt : std::optional(std::move(x));
  }
  /// One power to the e. Of a negative number only a whole one is taken, and of a constant that is not a rational
  /// number none.
  [[nodiscard]] std::optional<power_sum> power_of_powers(const wave& x, const rational& e) const {
    if (!x.powers || x.powers->size() != 1) return std::nullopt;
    const auto& [g, c] = *x.powers->begin();
    if (16 * (bits_of(c.q) + bits_of(e) + bits_of(g)) > most_exact_bits) return std::nullopt;
    coefficient result = c;
    if (c.node) {
      if (e == -1) {
        result = {1 / c.q, 1 / *c.node};
      } else if (e != 1) {
        return std::nullopt;
      }
    } else if (c.q != 1) {
      if (denominator(e) != 1 || abs(numerator(e)) > 16) {
        if (c.q <= 0) return std::nullopt;
        result = {1, pow(y_.constant_like(c.q), e)};
      } else {
        const auto n = static_cast<long>(numerator(e));
        result.q = 1;
        for (long k = 0; k < std::abs(n); ++k) result.q *= c.q;
        if (n < 0) result.q = 1 / result.q;
      }
    }
    return power_sum{{rational(g * e), result}};
  }

  [[nodiscard]] wave negated(const wave& x) const {
    wave result;
    for (const auto& [w, a] : x.terms) result.terms[w] = {negative(a.re), negative(a.im)};
    if (x.powers) {
      result.powers = *x.powers;
      for (auto& [e, c] : *result.powers) c.q = -c.q;
    }
    return result;
  }
  [[nodiscard]] std::optional<wave> sum(const wave& x, const wave& y) const {
    if (x.is_steady() && y.is_steady()) {
      return steady(value(x) + value(y), sum_of_powers(x, y));
    }
    wave result;
    result.terms = x.terms;
    for (const auto& [w, a] : y.terms) result.terms[w] = result.terms[w] + a;
    return limited(std::move(result));
  }
  [[nodiscard]] std::optional<wave> times(const wave& x, const wave& y) const {
    if (x.is_steady() && y.is_steady()) {
      return steady(value(x) * value(y), product_of_powers(x, y));
    }
    wave result;
    for (const auto& [w, a] : x.terms) {
      for (const auto& [v, b] : y.terms) {
        amplitude& at = result.terms[sum_of(w, v)];
        at = at + a * b;
      }
    }
    return limited(std::move(result));
  }
  [[nodiscard]] static std::optional<wave> limited(wave x) {
    constexpr std::size_t most_terms = 64;
    if (x.terms.size() > most_terms) return std::nullopt;
    return x;
  }
  [[nodiscard]] std::optional<wave> quotient(const wave& x, const wave& y) const {
    if (!y.is_steady()) return std::nullopt;
    if (x.is_steady()) {
      wave inverse;
      inverse.powers = power_of_powers(y, -1);
      return steady(value(x) / value(y), product_of_powers(x, inverse));
    }
    return times(x, steady(1 / value(y)));
  }
  [[nodiscard]] std::optional<wave> power(const wave& x, const rational& e) const {
    if (x.is_steady()) return steady(pow(value(x), e), power_of_powers(x, e));
    constexpr long most = 16;
    if (denominator(e) != 1 || e < 1 || e > most) return std::nullopt;
    wave result = x;
    for (long k = 1; k < static_cast<long>(numerator(e)); ++k) {
      std::optional<wave> next = times(result, x);
      if (!next) return std::nullopt;
      result = *std::move(next);
    }
    return result;
  }

  /// sin or cos. e^(iR)/(2i) = (sin R - i cos R)/2, e^(iR)/2 = (cos R + i sin R)/2.
  [[nodiscard]] std::optional<wave> circular(const wave& x, bool sine) {
    if (!x.is_steady()) return std::nullopt;
    const auto grows = [](const auto& term) { return term.first > 0; };
    if (!x.powers || std::none_of(x.powers->begin(), x.powers->end(), grows)) {
      const recorded v = value(x);
      return steady(sine ? sin(v) : cos(v));
    }
    if (x.powers->rbegin()->first != 1) {
      growth_ = x.powers->rbegin()->first;
      return std::nullopt;
    }
    power_sum rest = *x.powers;
    const coefficient w = rest.rbegin()->second;
    rest.erase(std::prev(rest.end()));
    if (std::any_of(rest.begin(), rest.end(), grows)) return std::nullopt;
    amplitude a;
    const rational half(1, 2);
    const recorded r = value(rest);
    const recorded cosine = rest.empty() ? y_.constant_like(half) : cos(r) * half;
    const std::optional<recorded> sine_of_rest =
        rest.empty() ? std::nullopt : std::optional(sin(r) * half);
    a.re = sine ? sine_of_rest : cosine;
    a.im = sine ? -cosine : sine_of_rest;
    wave result;
    const frequency key{{w.node ? w.node->node() : 0, w.q}};
    result.terms[key] = a;
    result.terms[negative(key)] = conjugate(a);
    return result;
  }
  /// Of pi x. Its node is made once, so that frequencies are known to be the same.
  [[nodiscard]] std::optional<wave> circular_of_pi(const wave& x, bool sine) {
    if (!pi_) pi_ = y_.constant_like(pi(bits_));
    wave factor;
    factor.terms[{}].re = pi_;
    factor.powers = power_sum{{rational(0), coefficient{1, pi_}}};
    const std::optional<wave> product = times(x, factor);
    return product ? circular(*product, sine) : product;
  }

  std::optional<wave> of_node(const recorded_node& node,
                              const std::vector<std::optional<wave>>& waves) {
    using kind = recorded_node::kind;
    if (node.what == kind::argument) return x_;
    if (node.what == kind::constant) {
      const coefficient c = node.exact ? coefficient{*node.exact, std::nullopt}
                                       : coefficient{1, y_.constant_like(node.enclosure)};
      power_sum powers;
      if (c.q != 0) powers.emplace(rational(0), c);
      return steady(value(c), powers);
    }
    if (node.is_piecewise()) return std::nullopt;
    const wave& x = *waves[node.left];
    if (node.what == kind::power) return power(x, *node.exact);
    const wave& y = *waves[node.right];
    switch (node.operation.rule) {
      case recorded_rule::negative:
        return negated(x);
      case recorded_rule::sum:
        return sum(x, y);
      case recorded_rule::difference:
        return sum(x, negated(y));
      case recorded_rule::product:
        return times(x, y);
      case recorded_rule::quotient:
        return quotient(x, y);
      case recorded_rule::square:
        return power(x, 2);
      case recorded_rule::sqrt:
        if (!x.is_steady()) return std::nullopt;
        return steady(sqrt(value(x)), power_of_powers(x, rational(1, 2)));
      case recorded_rule::sin:
      case recorded_rule::cos:
        if (!is_constant(x)) return circular(x, node.operation.rule == recorded_rule::sin);
        break;
      case recorded_rule::sinpi:
      case recorded_rule::cospi:
        if (!is_constant(x)) return circular_of_pi(x, node.operation.rule == recorded_rule::sinpi);
        break;
      default:
        break;
    }
    if (!x.is_steady() || !y.is_steady()) return std::nullopt;
    const bool is_known = is_constant(x) && is_constant(y);
    if (node.operation.on_complex == nullptr && !is_known) return std::nullopt;
    recorded v = value(x).applied(node.operation, value(y), node.number);
    if (!is_known) return steady(v);
    // A number, also where the function is one of real numbers only.
    if (node.operation.on_complex == nullptr) v = y_.constant_like(constant_value(v));
    return steady(v, power_sum{{rational(0), coefficient{1, v}}});
  }

  /// Of a node that does not depend on y.
  [[nodiscard]] ball constant_value(const recorded& x) const {
    return *program(y_, x.node())(ball(1, bits_)).front();
  }

  const recorded_nodes& nodes_;
  const formula& f_;
  precision bits_;
  recorded y_;
  wave x_;
  std::optional<recorded> factor_;
  std::optional<recorded> pi_;
  std::optional<rational> growth_;
  wave result_;
};

/// One frequency, or none, with the constants to some precision.
struct oscillation {
  ball frequency;
  program amplitude;
};

/// f taken apart, with its constants to as many bits as are asked for; safe to be used by several threads.
class decomposition {
 public:
  decomposition(const integrand& f, end_point p, end_point s, bool infinite, int sign)
      : f_(f.record), p_(std::move(p)), s_(std::move(s)), sign_(sign), theta_(infinite ? 1 : -1) {
    constexpr int most_attempts = 2;
    for (int k = 0; k < most_attempts; ++k) {
      splitter first(f_, least_bits, p_, s_, theta_, sign_);
      if (first.split()) {
        found_ = true;
        choose(first.result(), first.argument());
        return;
      }
      if (!first.growth()) return;
      theta_ /= *first.growth();
    }
  }

  /// It is a sum of oscillations, with frequencies that are certainly not 0.
  [[nodiscard]] bool is_found() const { return found_; }
  [[nodiscard]] const rational& theta() const { return theta_; }
  [[nodiscard]] bool has_steady_part() const { return steady_; }
  /// Of positive frequencies.
  [[nodiscard]] std::size_t count() const { return frequencies_.size(); }
  /// Number k; or, for k = count(), the steady part.
  [[nodiscard]] std::shared_ptr<const oscillation> at(std::size_t k, precision p) const {
    precision bits = least_bits;
    while (bits < p) bits *= 2;
    const std::lock_guard lock(mutex_);
    std::vector<std::shared_ptr<const oscillation>>& all = made_[bits];
    if (all.empty()) all = make(bits);
    return all[k];
  }

 private:
  static constexpr precision least_bits = 192;

  static ball value_of(const frequency& w, const recorded& y, precision p) {
    ball sum(0, p);
    for (const auto& [node, q] : w) {
      sum += node == 0 ? ball(q, p) : *program(y, node)(ball(1, p)).front() * q;
    }
    return sum;
  }
  void choose(const wave& x, const recorded& y) {
    for (const auto& [w, a] : x.terms) {
      if (w.empty()) {
        steady_ = true;
        continue;
      }
      const ball value = value_of(w, y, least_bits);
      if (certainly_positive(value)) {
        frequencies_.push_back(w);
      } else if (!certainly_negative(value)) {
        found_ = false;
      }
    }
  }
  [[nodiscard]] std::vector<std::shared_ptr<const oscillation>> make(precision p) const {
    splitter parts(f_, p, p_, s_, theta_, sign_);
    const bool same = parts.split();
    std::vector<std::shared_ptr<const oscillation>> result;
    result.reserve(frequencies_.size() + 1);
    const recorded& y = parts.argument();
    const auto add = [&](const frequency& w) {
      const auto found = parts.result().terms.find(w);
      // What is not the same recording again is undefined.
      if (!same || found == parts.result().terms.end()) {
        const amplitude undefined{y.constant_like(ball::undefined(p)), std::nullopt};
        result.push_back(std::make_shared<const oscillation>(
            oscillation{ball::undefined(p), program(y, undefined)}));
      } else {
        result.push_back(std::make_shared<const oscillation>(
            oscillation{value_of(w, y, p), program(y, found->second)}));
      }
    };
    for (const frequency& w : frequencies_) add(w);
    if (steady_) add({});
    return result;
  }

  formula f_;
  end_point p_;
  end_point s_;
  int sign_;
  rational theta_;
  bool found_ = false;
  bool steady_ = false;
  std::vector<frequency> frequencies_;
  mutable std::mutex mutex_;
  mutable std::map<precision, std::vector<std::shared_ptr<const oscillation>>> made_;
};

using shared_decomposition = std::shared_ptr<const decomposition>;

/// A bound of |h(t)| for |t| <= r < 1, Re t > 0, from its series there; infinite where h is not known to tend to 0:
/// |t|^m |log t|^k, with |log t| <= l + pi/2 for l = -log |t| >= 0, is at most e^(-m l) (l + 2)^k, which is largest
/// at l + 2 = k/m, if ever, and so at most e^(2m) (k/m)^k for k > 0, and at most 1 for k = 0.
magnitude bound_of(const end_series& series) {
  if (series.is_blocked()) return magnitude::infinity();
  const end_series h = series.simplified();
  if (h.is_zero()) return {};
  const rational& m = h.exponent();
  if (m <= 0) return magnitude::infinity();
  magnitude sum;
  for (int k = 0; k <= h.log_degree(); ++k) {
    ball most(1, 64);
    if (k > 0) most = exp(ball(rational(2 * m), 64)) * pow(ball(rational(k / m), 64), k);
    sum = add_up(sum, multiply_up(h.supremum(k), most.magnitude_upper()));
  }
  return sum;
}

/// A bound of |u| + |v| for |z| >= 1/r, Re z > 0.
magnitude bound_of(const oscillation& w, double r) {
  const end_series y =
      end_series::argument(known_number(rational(0)), known_number(rational(1)), -1, r);
  magnitude sum;
  for (const std::optional<end_series>& part : w.amplitude(y)) {
    if (part) sum = add_up(sum, bound_of(*part));
  }
  return sum;
}

/// W(z), or with -1 what has conjugate values at conjugate points.
template <class T>
T amplitude_at(const oscillation& w, const T& z, int sign, const T& zero) {
  const std::vector<std::optional<T>> parts = w.amplitude(z);
  T sum = parts[0] ? *parts[0] : zero;
  if (parts[1]) sum = sign > 0 ? sum + times_i(*parts[1]) : sum - times_i(*parts[1]);
  return sum;
}

/// 2 Re of i e^(i w Y0) W(Y0 + i tau) e^(-w tau) for 0 <= tau <= T, tau = T t.
segment line_up(const shared_decomposition& f, std::size_t k, long start, long length) {
  segment result;
  const auto over_with = [=](precision p) {
    const std::shared_ptr<const oscillation> w = f->at(k, p);
    const ball angle = w->frequency * start;
    const region phase(complex_ball(cos(angle), sin(angle)));
    const region conjugate(complex_ball(cos(angle), -sin(angle)));
    return [=](const region& t) {
      const region zero = t * 0;
      const region tau = t * length;
      const region above = amplitude_at(*w, start + times_i(tau), 1, zero) * phase;
      const region below = amplitude_at(*w, start - times_i(tau), -1, zero) * conjugate;
      return times_i(above - below) * exp(-(tau * w->frequency));
    };
  };
  result.over = [=, in_hardware = over_with(64)](const region& t) {
    return t.is_in_hardware() ? in_hardware(t) : over_with(t.precision() + 64)(t);
  };
  result.evaluator = [=](precision p) -> std::function<ball(const ball&)> {
    const std::shared_ptr<const oscillation> w = f->at(k, p);
    const complex_ball phase(cos(w->frequency * start), sin(w->frequency * start));
    return [=](const ball& t) {
      const ball tau = t * length;
      const analytic_ball z(complex_ball(ball(start, t.precision()), tau));
      const analytic_ball zero(complex_ball(ball(0, t.precision())));
      const complex_ball above = amplitude_at(*w, z, 1, zero).value() * phase;
      return -2 * above.im * exp(-(tau * w->frequency));
    };
  };
  result.scale = [=](precision p) { return ball(length, p); };
  result.position = [=](const ball& t) { return start + t * length; };
  result.continued = true;
  return result;
}

/// The steady part as a function of y.
integrand steady_part(const shared_decomposition& f) {
  const auto at = [f](precision p) { return f->at(f->count(), p); };
  const auto value = [](const auto& parts, const auto& zero) {
    return parts[0] ? *parts[0] : zero;
  };
  integrand result;
  result.over = [=](const region& y) {
    const auto w = at(y.is_in_hardware() ? precision{64} : y.precision() + 64);
    return value(w->amplitude(y), y * 0);
  };
  result.evaluator = [=](precision p) -> std::function<ball(const ball&)> {
    return [=, w = at(p)](const ball& y) { return value(w->amplitude(y), ball(0, p)); };
  };
  result.near_end = [=](const end_series& y) { return value(at(192)->amplitude(y), y * 0); };
  result.near_infinity = [](const tail_series&) { return tail_series(); };
  return result;
}

}  // namespace

std::optional<oscillating_end> oscillations_at(const integrand& f, const end_point& p,
                                               const end_point& s, bool infinite, int sign,
                                               double log2_goal) {
  if (!f.record) return std::nullopt;
  const auto parts = std::make_shared<const decomposition>(f, p, s, infinite, sign);
  if (!parts->is_found() || parts->count() == 0) return std::nullopt;
  // Y0 = 2^(d e), with d the denominator of theta, so that Y0^theta is rational.
  const rational& theta = parts->theta();
  constexpr long most_bits = 30;
  if (denominator(theta) > most_bits || abs(numerator(theta)) > most_bits) return std::nullopt;
  const auto d = static_cast<long>(denominator(theta));
  for (long e = 1; e * d <= most_bits; ++e) {
    const double r = std::ldexp(1.0, static_cast<int>(-e * d));
    std::vector<magnitude> bounds;
    for (std::size_t k = 0; k < parts->count(); ++k) {
      bounds.push_back(bound_of(*parts->at(k, 192), r));
      if (bounds.back().is_infinite()) break;
    }
    if (bounds.back().is_infinite()) continue;
    oscillating_end result;
    const long start = 1L << (e * d);
    result.start = start;
    const auto n = static_cast<long>(numerator(theta));
    result.far = 1;
    for (long j = 0; j < e * std::abs(n); ++j) result.far *= 2;
    if (n < 0) result.far = 1 / result.far;
    if (parts->has_steady_part()) result.steady = steady_part(parts);
    for (std::size_t k = 0; k < parts->count(); ++k) {
      const ball frequency = parts->at(k, 192)->frequency;
      // 2 (B/w) e^(-w T), which is 0 nowhere.
      const double log2_bound =
          bounds[k].is_zero() ? log2_goal : static_cast<double>(bounds[k].log2_floor()) + 1;
      const double log2_frequency = static_cast<double>(frequency.magnitude_lower().log2_floor());
      const double nats = std::max(log2_bound - log2_frequency + 4 - log2_goal, 8.0) * 0.6932;
      const double long_enough = nats / double_interval::from_ball(frequency).lower();
      if (!(long_enough < 0x1p60)) return std::nullopt;
      const long length = static_cast<long>(long_enough) + 1;
      ball rest(0, 64);
      rest = rest.enlarged(multiply_up(bounds[k], magnitude::from_integer_up(2)));
      rest = rest * exp(-(frequency * length)) / frequency;
      result.rest = add_up(result.rest, rest.magnitude_upper());
      result.segments.push_back(line_up(parts, k, start, length));
    }
    return result;
  }
  return std::nullopt;
}

}  // namespace polhode::detail
