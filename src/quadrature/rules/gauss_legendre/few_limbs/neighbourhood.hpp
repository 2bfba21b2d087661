#pragma once

// The work on one start, in four steps, a file each: the values of q there (values.cpp), its Taylor
// coefficients (terms.cpp), the search for the zero (search.cpp) and the proof that there is one
// (proof.cpp). few_limbed_zeros.cpp says how, and counts the errors.

#include <cstdint>
#include <optional>
#include <vector>

#include "quadrature/rules/gauss_legendre/few_limbs/number.hpp"
#include "quadrature/rules/gauss_legendre/polynomial.hpp"
#include "quadrature/rules/gauss_legendre/zero.hpp"

namespace polhode::detail::legendre {

/// q around one start. Each step but the last returns false where the start does not serve.
class neighbourhood {
 public:
  neighbourhood(const legendre_shape& s, const std::vector<std::uint64_t>& errors, long limbs,
                std::uint64_t start)
      : shape_(s), errors_(errors), w_(limbs), start_(start) {
    const uint128 product = uint128{start} * (limb{0} - start);  // 2^126 s
    s_[0] = static_cast<limb>(product);
    s_[1] = static_cast<limb>(product >> 64);
  }

  bool values(const legendre_coefficients& polynomial);
  bool terms(const std::vector<double>& log2_terms);
  bool search(long wanted);
  std::optional<legendre_zero> proved();

 private:
  void multiply_by_s(limb* r, const limb* x, long size, limb factor) const;
  template <bool derivative>
  number evaluate(long w, long last) const;
  void correct(long w, long w_of_slope);
  [[nodiscard]] long last_for(long bits) const;

  const legendre_shape& shape_;
  const std::vector<std::uint64_t>& errors_;
  const long w_;
  const std::uint64_t start_;
  limb s_[2] = {};
  number e_[greatest_order + 1];
  long last_ = 0;  // K
  number g_;       // its limb before the point is 0
  long gap_ = 0;   // |g| < 2^-gap
};

}  // namespace polhode::detail::legendre
