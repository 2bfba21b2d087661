#include "decomposition.hpp"
#include "quadrature/formula/recorded.hpp"

#include <utility>

namespace polhode::detail::oscillations {

namespace {

constexpr precision least_bits = 192;

ball value_of(const frequency& w, const recorded& y, precision p) {
  ball sum(0, p);
  for (const auto& [node, q] : w) {
    sum += node == 0 ? ball(q, p) : *program_of_parts(y, node)(ball(1, p)).front() * q;
  }
  return sum;
}

}  // namespace

decomposition::decomposition(const integrand& f, const end_point& p, const end_point& s,
                             bool infinite, int sign)
    : f_(f.record), p_(p), s_(s), sign_(sign), theta_(infinite ? 1 : -1) {
  constexpr int most_attempts = 2;
  for (int k = 0; k < most_attempts; ++k) {
    const separated first = separate(f_, least_bits, p_, s_, theta_, sign_);
    if (first.terms) {
      found_ = true;
      choose(*first.terms, first.y);
      return;
    }
    if (!first.growth) return;
    theta_ /= *first.growth;
  }
}

std::shared_ptr<const oscillation> decomposition::at(std::size_t k, precision p) const {
  precision bits = least_bits;
  while (bits < p) bits *= 2;
  const std::lock_guard lock(mutex_);
  std::vector<std::shared_ptr<const oscillation>>& all = made_[bits];
  if (all.empty()) all = make(bits);
  return all[k];
}

void decomposition::choose(const std::map<frequency, amplitude>& terms, const recorded& y) {
  for (const auto& [w, a] : terms) {
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

std::vector<std::shared_ptr<const oscillation>> decomposition::make(precision p) const {
  const separated parts = separate(f_, p, p_, s_, theta_, sign_);
  std::vector<std::shared_ptr<const oscillation>> result;
  result.reserve(frequencies_.size() + 1);
  const auto add = [&](const frequency& w) {
    // What is not the same recording again is undefined.
    if (!parts.terms || !parts.terms->contains(w)) {
      const amplitude undefined{parts.y.constant_like(ball::undefined(p)), std::nullopt};
      result.push_back(std::make_shared<const oscillation>(
          oscillation{ball::undefined(p), program_of_parts(parts.y, undefined)}));
    } else {
      result.push_back(std::make_shared<const oscillation>(
          oscillation{value_of(w, parts.y, p), program_of_parts(parts.y, parts.terms->at(w))}));
    }
  };
  for (const frequency& w : frequencies_) add(w);
  if (steady_) add({});
  return result;
}

}  // namespace polhode::detail::oscillations
