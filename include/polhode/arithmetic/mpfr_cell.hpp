#pragma once

#include <cstddef>
#include <cstdint>

#include <mpfr.h>

#include "polhode/language.hpp"

namespace polhode {

/// Bits of a significand. Precision belongs to values: nothing in Polhode reads or sets a default.
using precision = mpfr_prec_t;

/// The precisions that values may have. The upper limit (2 GiB a number) is far above what can be
/// computed with and far below where sizes in bytes overflow.
inline constexpr precision least_precision = 2;
inline constexpr precision greatest_precision = precision{1} << 34;

/// Returns p; throws std::invalid_argument where p is not a precision that a value may have.
precision checked_precision(precision p);

namespace detail {

/// Storage of one MPFR number. Up to 256 bits lie inside the object, without heap traffic.
/// A default-constructed cell is empty: it has no significand and get() must not be read.
class mpfr_cell {
 public:
  mpfr_cell() noexcept : value_{}, storage_{} {}
  /// A zero with room for p bits. Hypothesis: p >= 1.
  explicit mpfr_cell(precision p) : mpfr_cell() { reset(p); }
  mpfr_cell(const mpfr_cell& other) : mpfr_cell() { *this = other; }
  mpfr_cell(mpfr_cell&& other) noexcept : mpfr_cell() { steal(other); }
  mpfr_cell& operator=(const mpfr_cell& other);
  mpfr_cell& operator=(mpfr_cell&& other) noexcept {
    if (this != &other) {
      release();
      steal(other);
    }
    return *this;
  }
  ~mpfr_cell() { release(); }

  [[nodiscard]] bool is_empty() const { return value_->_mpfr_d == nullptr; }
  [[nodiscard]] mpfr_ptr get() { return value_; }
  [[nodiscard]] mpfr_srcptr get() const { return value_; }

  /// Gives the cell room for exactly p bits. The value is lost where the precision changes.
  void reset(precision p) {
    if (!is_empty() && mpfr_get_prec(value_) == p) return;
    if (p <= static_cast<precision>(inline_limbs * GMP_NUMB_BITS) && !on_heap()) {
      mpfr_custom_init_set(value_, MPFR_ZERO_KIND, 0, p, storage_.limbs);
    } else {
      allocate(p);
    }
  }

  void swap(mpfr_cell& other) noexcept {
    mpfr_cell kept(static_cast<mpfr_cell&&>(other));
    other.steal(*this);
    steal(kept);
  }

 private:
  static constexpr std::size_t inline_limbs = 256 / GMP_NUMB_BITS;

  void allocate(precision p);
  void release_heap() noexcept;
  void release() noexcept {
    if (on_heap()) release_heap();
  }
  [[nodiscard]] bool on_heap() const {
    return value_->_mpfr_d != nullptr && value_->_mpfr_d != storage_.limbs;
  }
  void steal(mpfr_cell& other) noexcept;

  mpfr_t value_;
  union {
    mp_limb_t limbs[inline_limbs];
    std::size_t heap_limbs;  // the capacity of the block, where the significand is on the heap
  } storage_;
};

}  // namespace detail
}  // namespace polhode
