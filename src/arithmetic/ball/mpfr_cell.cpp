#include "polhode/arithmetic/mpfr_cell.hpp"

#include <cstdlib>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

namespace polhode {

precision checked_precision(precision p) {
  if (p < least_precision || p > greatest_precision) {
    throw std::invalid_argument("precision of " + std::to_string(p) + " bits: it must be from " +
                                std::to_string(least_precision) + " to " +
                                std::to_string(greatest_precision));
  }
  return p;
}

namespace detail {
namespace {
std::size_t limbs_for(precision p) {
  return (static_cast<std::size_t>(p) + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS;
}
}  // namespace

mpfr_cell& mpfr_cell::operator=(const mpfr_cell& other) {
  if (this == &other) return *this;
  if (other.is_empty()) {
    release();
    value_[0] = other.value_[0];
    return *this;
  }
  reset(mpfr_get_prec(other.value_));
  mpfr_set(value_, other.value_, MPFR_RNDN);  // same precision: exact
  return *this;
}

void mpfr_cell::allocate(precision p) {
  const std::size_t limbs = limbs_for(p);
  mp_limb_t* significand = storage_.limbs;
  if (on_heap() && storage_.heap_limbs >= limbs) {
    significand = value_->_mpfr_d;
  } else if (limbs > inline_limbs) {
    auto* block = static_cast<mp_limb_t*>(std::malloc(limbs * sizeof(mp_limb_t)));
    if (block == nullptr) throw std::bad_alloc();
    release();
    storage_.heap_limbs = limbs;
    significand = block;
  } else {
    release();
  }
  mpfr_custom_init_set(value_, MPFR_ZERO_KIND, 0, p, significand);
}

void mpfr_cell::release_heap() noexcept { std::free(value_->_mpfr_d); }

void mpfr_cell::steal(mpfr_cell& other) noexcept {
  value_[0] = other.value_[0];
  storage_ = other.storage_;
  if (!other.is_empty() && !other.on_heap()) value_->_mpfr_d = storage_.limbs;
  // An empty cell has precision 0, which is nobody's: a result is never computed into it as it is.
  other.value_->_mpfr_d = nullptr;
  other.value_->_mpfr_prec = 0;
}

}  // namespace detail
}  // namespace polhode
