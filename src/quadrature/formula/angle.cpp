#include "quadrature/formula/angle.hpp"

#include <cstdlib>

#include "polhode/arithmetic/exact.hpp"

namespace polhode {

namespace {

/// Beyond it sin(m x) costs about as much as a sine of its own.
constexpr long greatest_multiple = 16;

long block_for(long count) {
  long block = 1;
  while (block * block < count) ++block;
  return block;
}

detail::circle_powers<ball> powers_of(const ball& angle, long count, precision p) {
  const auto [sine, cosine] = sin_cos(angle);
  return {cosine, sine, count, p};
}

using point = std::pair<ball, ball>;  // cosine, sine

point product(const point& z, const point& w) {
  return {z.first * w.first - z.second * w.second, z.second * w.first + z.first * w.second};
}

/// A small whole number that the ball is, exactly; 0 for others.
long small_integer(const ball& x) {
  if (!x.is_exact() || !(x.magnitude_upper() <= magnitude::power_of_two(5))) return 0;
  const rational q = lower_rational(x);
  return denominator(q) == 1 ? static_cast<long>(numerator(q)) : 0;
}

}  // namespace

equidistant_angles::equidistant_angles(const ball& start, const ball& half_step, long count,
                                       precision p)
    : start_(start),
      half_step_(half_step),
      block_(block_for(count)),
      fine_(powers_of(half_step, 2 * block_ + 1, p)),
      coarse_(fine_.cosines.back(), fine_.sines.back(), (count + block_ - 1) / block_, p) {
  const auto [sine, cosine] = sin_cos(start);
  for (std::size_t i = 0; i < coarse_.cosines.size(); ++i) {
    point turned = product({coarse_.cosines[i], coarse_.sines[i]}, {cosine, sine});
    coarse_.cosines[i] = std::move(turned.first);
    coarse_.sines[i] = std::move(turned.second);
  }
}

std::pair<ball, ball> equidistant_angles::cosine_and_sine(long k, long m) const {
  const auto i = static_cast<std::size_t>(k / block_);
  const auto j = static_cast<std::size_t>(2 * (k % block_) + 1);
  const point z =
      product({coarse_.cosines[i], coarse_.sines[i]}, {fine_.cosines[j], fine_.sines[j]});
  point power = z;
  for (long done = 1; done < std::abs(m); ++done) power = product(power, z);
  if (m < 0) power.second = -power.second;
  return power;
}

angle angle::multiple(ball x, long m) const {
  angle result(std::move(x));
  if (among_ != nullptr && m != 0 && std::abs(m) <= greatest_multiple) {
    result.among_ = among_;
    result.k_ = k_;
    result.m_ = m;
  }
  return result;
}

angle operator*(const angle& x, const angle& y) {
  if (x.among_ != nullptr) return x.multiple(x.value_ * y.value_, x.m_ * small_integer(y.value_));
  if (y.among_ != nullptr) return y.multiple(x.value_ * y.value_, y.m_ * small_integer(x.value_));
  return angle(x.value_ * y.value_);
}

angle sin(const angle& x) {
  if (x.among_ == nullptr) return angle(sin(x.value_));
  return angle(x.among_->cosine_and_sine(x.k_, x.m_).second);
}
angle cos(const angle& x) {
  if (x.among_ == nullptr) return angle(cos(x.value_));
  return angle(x.among_->cosine_and_sine(x.k_, x.m_).first);
}
angle tan(const angle& x) {
  if (x.among_ == nullptr) return angle(tan(x.value_));
  const auto [cosine, sine] = x.among_->cosine_and_sine(x.k_, x.m_);
  return angle(sine / cosine);
}

}  // namespace polhode
