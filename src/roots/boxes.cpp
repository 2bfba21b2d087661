#include "boxes.hpp"

#include <algorithm>
#include <utility>

#include "polhode/arithmetic/interval.hpp"

namespace polhode::boxes {

bool is_undefined(const vector& x) {
  return std::any_of(x.begin(), x.end(), [](const ball& t) { return t.is_undefined(); });
}
bool all_overlap(const vector& x, const vector& y) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!overlaps(x[i], y[i])) return false;
  }
  return true;
}
bool holds(const vector& x, const vector& y) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!contains(x[i], y[i])) return false;
  }
  return true;
}
bool holds_inside(const vector& x, const vector& y) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!is_interior(y[i], x[i])) return false;
  }
  return true;
}
bool holds_zero(const vector& x) {
  return std::all_of(x.begin(), x.end(), [](const ball& t) { return contains_zero(t); });
}
vector middle_of(const vector& x) {
  vector r;
  for (const ball& t : x) r.push_back(t.middle());
  return r;
}
vector with_precision(const vector& x, precision p) {
  vector r;
  for (const ball& t : x) r.push_back(t.with_precision(p));
  return r;
}
vector common(const vector& x, const vector& y) {
  vector r;
  for (std::size_t i = 0; i < x.size(); ++i) r.push_back(intersection(x[i], y[i]));
  return r;
}
vector joined(const vector& x, const vector& y) {
  vector r;
  for (std::size_t i = 0; i < x.size(); ++i) r.push_back(hull(x[i], y[i]));
  return r;
}
magnitude widest(const vector& x) {
  magnitude r;
  for (const ball& t : x) r = max(r, t.radius());
  return r;
}

matrix approximate_inverse(const matrix& a, precision p) {
  const std::size_t n = a.size();
  matrix left;
  matrix right;
  for (std::size_t i = 0; i < n; ++i) {
    left.push_back(with_precision(middle_of(a[i]), p));
    left.back() = middle_of(left.back());
    right.emplace_back(n, ball(0, p));
    right.back()[i] = ball(1, p);
    if (is_undefined(left.back())) return {};
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (left[i][k].magnitude_upper() > left[pivot][k].magnitude_upper()) pivot = i;
    }
    if (contains_zero(left[pivot][k])) return {};
    std::swap(left[k], left[pivot]);
    std::swap(right[k], right[pivot]);
    const ball scale_by = (1 / left[k][k]).middle();
    for (std::size_t j = 0; j < n; ++j) {
      left[k][j] = (left[k][j] * scale_by).middle();
      right[k][j] = (right[k][j] * scale_by).middle();
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || sign_of(left[i][k]) == certain_sign::zero) continue;
      const ball factor = left[i][k];
      for (std::size_t j = 0; j < n; ++j) {
        left[i][j] = (left[i][j] - factor * left[k][j]).middle();
        right[i][j] = (right[i][j] - factor * right[k][j]).middle();
      }
    }
  }
  return right;
}

vector product(const matrix& a, const vector& x) {
  vector r;
  for (const vector& row : a) {
    ball sum(0, x.front().precision());
    for (std::size_t j = 0; j < x.size(); ++j) sum += row[j] * x[j];
    r.push_back(std::move(sum));
  }
  return r;
}
matrix product(const matrix& a, const matrix& b) {
  matrix r;
  for (const vector& row : a) {
    vector line;
    for (std::size_t j = 0; j < b.front().size(); ++j) {
      ball sum(0, row.front().precision());
      for (std::size_t k = 0; k < row.size(); ++k) sum += row[k] * b[k][j];
      line.push_back(std::move(sum));
    }
    r.push_back(std::move(line));
  }
  return r;
}

vector difference_of(const vector& x, const vector& y) {
  vector r;
  for (std::size_t i = 0; i < x.size(); ++i) r.push_back(x[i] - y[i]);
  return r;
}

bool is_bounded(const vector& x) {
  return std::ranges::all_of(x, [](const ball& t) { return t.is_bounded(); });
}

}  // namespace polhode::boxes
