#include "sweep.hpp"

#include <array>
#include <string>
#include <vector>

#include "answers.hpp"
#include "checker/elliptic.hpp"
#include "checker/functions.hpp"

namespace polhode::checker {
namespace {

constexpr long cells = 64;
/// Units of a comparison of two boxes.
constexpr long units_of_two_boxes = 300;

struct box {
  range p;
  range r;
  range u;
};

bool have_common_inside(const range& x, const range& y) {
  return x.lower < y.upper && y.lower < x.upper;
}

/// cos^2 at k pi/(2 cells), k = 0 ... cells.
std::vector<interval> squared_cosines(precision bits) {
  std::vector<interval> values;
  values.reserve(cells + 1);
  for (long k = 0; k <= cells; ++k) {
    values.push_back(square(sin_cos(pi(bits) * k / (2 * cells)).cosine));
  }
  return values;
}

/// cos^2 t (sigma^(-1/2) + r u sigma^(-3/2)).
interval sweep_integrand(const interval& cos_squared, const interval& sigma, const interval& r_u) {
  return cos_squared / sqrt(sigma) * (exactly(1, sigma.bits()) + r_u / sigma);
}

/// A lower bound of W = integral over (0, pi/2) of cos^2 t (sigma^(-1/2) + r u sigma^(-3/2)) dt,
/// sigma = u + p (1-u) cos^2 t, on a box: on every cell the least cos^2 outside, the greatest
/// sigma, which increases in u, in p and in cos^2, and the least r u.
interval lower_bound(const box& b, const std::vector<interval>& cosines) {
  const precision& bits = cosines.front().bits();
  const interval r_u = exactly(rational(b.r.lower * b.u.lower), bits);
  interval sum = exactly(0, bits);
  for (std::size_t k = 0; k < cells; ++k) {
    const interval sigma = exactly(b.u.upper, bits) +
                           exactly(rational(b.p.upper * (1 - b.u.upper)), bits) * cosines[k];
    sum = sum + sweep_integrand(cosines[k + 1], sigma, r_u);
  }
  return sum * pi(bits) / (2 * cells);
}

box read_box(const place& where) {
  if (where.size() != 3) where.malformed("it must be three pairs of ends");
  std::array<range, 3> sides;
  for (std::size_t i = 0; i < 3; ++i) {
    const place side = where.at(i);
    if (side.size() != 2) side.malformed("it must be a pair of ends");
    sides[i] = {side.at(0).fraction(), side.at(1).fraction()};
    if (bit_length(sides[i].lower) + bit_length(sides[i].upper) > 256) {
      side.malformed("its ends have more than 256 bits");
    }
    if (sides[i].lower < 0) side.at(0).refute("it is below 0");
    if (sides[i].upper > 1) side.at(1).refute("it is above 1");
    if (sides[i].lower >= sides[i].upper) side.refute("its ends are not in order");
  }
  return {sides[0], sides[1], sides[2]};
}

}  // namespace

/// On every cell cos^2 and sigma lie between their values at its ends.
interval enclosure_at(const real& p, const real& r, const rational& u, precision bits) {
  const std::vector<interval> cosines = squared_cosines(bits);
  interval sum = exactly(0, bits);
  for (std::size_t k = 0; k < cells; ++k) {
    const interval c = hull(cosines[k], cosines[k + 1]);
    const interval sigma = exactly(u, bits) + exactly(p * (1 - u), bits) * c;
    sum = sum + sweep_integrand(c, sigma, exactly(r * u, bits));
  }
  return sum * pi(bits) / (2 * cells);
}

std::size_t check_sweep(const place& sweep) {
  constexpr std::size_t most_boxes = 4096;
  sweep.expect_keys({"bound", "boxes"});
  sweep["bound"].expect_text("3/4");
  const place list = sweep["boxes"];
  if (list.size() > most_boxes) list.not_checkable("it has more than 4096 boxes");
  const precision bits(sweep_bits, sweep.work());
  const std::vector<interval> cosines = squared_cosines(bits);
  std::vector<box> boxes;
  boxes.reserve(list.size());
  rational volume(0);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const box b = read_box(list.at(i));
    const budget::at here = list.at(i).working();
    sweep.work().spend(units_of_two_boxes * static_cast<long>(1 + boxes.size()));
    for (std::size_t j = 0; j < boxes.size(); ++j) {
      if (have_common_inside(b.p, boxes[j].p) && have_common_inside(b.r, boxes[j].r) &&
          have_common_inside(b.u, boxes[j].u)) {
        list.at(i).refute("it overlaps box " + std::to_string(j));
      }
    }
    try {
      if (!(lower_bound(b, cosines) - exactly(rational(3, 4), bits)).is_positive()) {
        list.at(i).refute("the bound is not shown on it");
      }
    } catch (const undecided&) {
      list.at(i).refute("the bound is not shown on it");
    }
    volume += (b.p.upper - b.p.lower) * (b.r.upper - b.r.lower) * (b.u.upper - b.u.lower);
    boxes.push_back(b);
  }
  if (volume != 1) list.refute("the boxes do not cover [0,1]^3");
  return boxes.size();
}

}  // namespace polhode::checker
