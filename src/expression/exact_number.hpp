#pragma once

// Real numbers known by formal rules: finite sums of c g_1^q_1 ... g_n^q_n with rational c and q_i
// and generators g_i: natural numbers, pi, exponentials, logarithms, arc tangents, cosines of
// rational multiples of pi, sums of the same kind of which a root or the reciprocal was taken, and
// numbers of which nothing is known but an enclosure.
//
// THE PRINCIPLE. Each rule here is an identity between real numbers: two sums that are formally
// equal are equal numbers, and a sum in which everything cancels is 0. Nothing is concluded the
// other way: that two sums look different does not say that they differ (whether log 2 log 3 and pi
// are linearly independent over the rational numbers, say, is not known). What needs a number to
// differ from 0, or to be positive, asks the enclosures, and gives up where they do not decide. So
// no theorem of transcendence is needed, and what is missing among the rules costs answers, never
// their truth.
//
// Its rules are in exact/, a file to each thought; generators.cpp is the one to begin with.
//
// All of it is bounded: in terms, bits, and steps in all. Beyond, not_decided is thrown, for the
// caller to catch.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode::detail {

/// No rule applies, an enclosure does not decide, or a bound was reached.
class not_decided {};

/// Generators are numbered in the order in which they are met.
using generator_id = std::uint32_t;

/// In the order of the generators, without exponents 0.
using monomial = std::vector<std::pair<generator_id, rational>>;

/// Coefficients that are not 0, by monomial; 0 has none.
using exact_sum = std::map<monomial, rational>;

[[nodiscard]] exact_sum exactly(const rational& q);

/// The generators of one computation, and what is done with numbers made of them. Every member
/// function throws not_decided where it does not know the result.
class exact_field {
 public:
  /// With `further`, sines and cosines of any angle are generators too
  /// (exact/trigonometric_polynomial.cpp), and algebraic numbers are shown to be 0 by polynomials
  /// (exact/annihilating_polynomial.cpp). That takes longer, and more terms.
  explicit exact_field(bool further = false) : further_(further) {}

  [[nodiscard]] exact_sum sum(const exact_sum& x, const exact_sum& y);
  [[nodiscard]] exact_sum difference(const exact_sum& x, const exact_sum& y);
  [[nodiscard]] exact_sum product(const exact_sum& x, const exact_sum& y);
  [[nodiscard]] exact_sum scaled(const exact_sum& x, const rational& q);
  /// x / y; y is shown not to be 0.
  [[nodiscard]] exact_sum quotient(const exact_sum& x, const exact_sum& y);
  [[nodiscard]] exact_sum reciprocal(const exact_sum& x);
  [[nodiscard]] exact_sum integer_power(const exact_sum& x, long n);
  /// x^q of x > 0, which is shown, or x = 0 < q.
  [[nodiscard]] exact_sum power(const exact_sum& x, const rational& q);
  [[nodiscard]] exact_sum sqrt(const exact_sum& x) { return power(x, rational(1, 2)); }
  /// The real n-th root: of x < 0 too where n is odd.
  [[nodiscard]] exact_sum root(const exact_sum& x, long n);
  [[nodiscard]] exact_sum abs(const exact_sum& x);
  [[nodiscard]] exact_sum floor(const exact_sum& x);

  [[nodiscard]] exact_sum pi();
  [[nodiscard]] exact_sum exp(const exact_sum& x);
  [[nodiscard]] exact_sum log(const exact_sum& x);
  [[nodiscard]] exact_sum cospi(const rational& q);
  [[nodiscard]] exact_sum sinpi(const rational& q) { return cospi(rational(1, 2) - q); }
  /// {cos x, sin x} of sums of rational multiples of pi and whole multiples of arc tangents.
  [[nodiscard]] std::pair<exact_sum, exact_sum> cos_and_sin(const exact_sum& x);
  [[nodiscard]] exact_sum acos(const exact_sum& x);
  [[nodiscard]] exact_sum asin(const exact_sum& x);
  [[nodiscard]] exact_sum atan(const exact_sum& x);
  /// A number of which the enclosure is all that is known. The same key is the same number.
  [[nodiscard]] exact_sum opaque(std::uint32_t key, const ball& around);

  /// The rational number that x is shown to be; none where it is not shown to be rational.
  [[nodiscard]] std::optional<rational> as_rational(const exact_sum& x);
  /// -1, 0 or 1.
  [[nodiscard]] int sign(const exact_sum& x);
  [[nodiscard]] ball enclosure(const exact_sum& x);

  /// With which signs are decided.
  static constexpr precision bits = 512;

 private:
  enum class kind : std::uint8_t {
    base,          // a natural number > 1, or a positive sum: exponents < 1
    pi,            // the circle's
    exp,           // of a monomial
    log,           // of a positive number
    arctan,        // of a number in (0, 1)
    cosine,        // of q pi, 0 < q < 1/2
    angle_cosine,  // of a number whose first coefficient is positive, without multiples of pi
    angle_sine,    // of the same
    opaque,        // known by its enclosure
  };
  struct generator {
    kind what;
    exact_sum of;  // the argument; for kind::opaque the key
    ball enclosure;
    friend bool operator==(const generator& x, const generator& y) {
      return x.what == y.what && x.of == y.of;
    }
  };

  static constexpr int deepest_root = 3;  // roots taken to find a root

  void spend(std::size_t steps);
  void check_size(const exact_sum& x) const;
  void add_to(exact_sum& x, const monomial& m, const rational& c);
  [[nodiscard]] std::optional<generator_id> find(kind what, const exact_sum& of) const;
  [[nodiscard]] generator_id make(kind what, const exact_sum& of, const ball& enclosure);
  [[nodiscard]] exact_sum generated(generator_id g, const rational& exponent = 1);
  [[nodiscard]] bool is_positive(generator_id g) const;
  [[nodiscard]] bool is_not_zero(generator_id g) const;
  [[nodiscard]] bool is_positive(const monomial& m) const;
  [[nodiscard]] exact_sum expanded(const monomial& m);
  [[nodiscard]] exact_sum base_power(const exact_sum& v, const rational& q);
  [[nodiscard]] exact_sum number_power(const rational& c, const rational& q);
  [[nodiscard]] exact_sum log_of_number(const rational& c);
  [[nodiscard]] exact_sum log_of_sum(const exact_sum& v);
  /// x = a + b g^(1/2), or none where g^(1/2) is not in it so.
  [[nodiscard]] std::optional<std::pair<exact_sum, exact_sum>> split(const exact_sum& x,
                                                                     generator_id g);
  [[nodiscard]] std::vector<generator_id> square_roots_in(const exact_sum& x) const;
  [[nodiscard]] exact_sum rationalised_reciprocal(exact_sum x);
  [[nodiscard]] std::optional<exact_sum> times_known_root(const exact_sum& x, const exact_sum& v);
  [[nodiscard]] std::optional<exact_sum> denested_root(const exact_sum& x, int depth);
  [[nodiscard]] std::optional<exact_sum> plain_root(const exact_sum& x, int depth);
  [[nodiscard]] std::optional<rational> rational_by_common_denominator(const exact_sum& x);
  [[nodiscard]] std::optional<rational> rational_by_roots_of_unity(const exact_sum& x);
  [[nodiscard]] std::optional<long> common_order_of_cosines(const exact_sum& x) const;
  [[nodiscard]] std::optional<exact_sum> cospi_of_few_roots(const rational& angle);
  [[nodiscard]] std::pair<exact_sum, exact_sum> turned_by_arcs(std::pair<exact_sum, exact_sum> x,
                                                               const exact_sum& tangent, long n);
  [[nodiscard]] std::pair<exact_sum, exact_sum> cos_and_sin_of_sum(
      const std::pair<exact_sum, exact_sum>& x, const std::pair<exact_sum, exact_sum>& y);
  [[nodiscard]] exact_sum arctan_of_rational(const rational& t);
  [[nodiscard]] std::optional<exact_sum> arctan_by_gaussian_factors(const rational& t);
  [[nodiscard]] exact_sum generated_arctan(const rational& t);

  [[nodiscard]] std::pair<exact_sum, exact_sum> generated_cos_and_sin(const exact_sum& x);
  /// How many factors of m are cosines of multiples of pi, and how many cosines and sines of other
  /// angles; the other kinds count nowhere.
  [[nodiscard]] std::pair<long, long> waves_in(const monomial& m) const;
  [[nodiscard]] bool has_waves_to_reduce(const monomial& m) const;
  [[nodiscard]] exact_sum with_waves_reduced(const monomial& m);
  [[nodiscard]] exact_sum product_of_waves(generator_id v, generator_id w);
  [[nodiscard]] std::optional<rational> rational_by_further_rules(const exact_sum& x);
  [[nodiscard]] bool is_shown_to_be_zero(const exact_sum& x);
  [[nodiscard]] exact_sum without_reciprocals(exact_sum x);
  [[nodiscard]] bool is_zero_by_conjugates(exact_sum x);
  [[nodiscard]] bool is_zero_by_a_polynomial(const exact_sum& x);
  [[nodiscard]] bool is_algebraic(generator_id g) const;

  std::vector<generator> generators_;
  std::size_t spent_ = 0;
  bool further_ = false;
  bool shows_zero_ = false;  // within is_shown_to_be_zero, which does not call itself
};

}  // namespace polhode::detail
