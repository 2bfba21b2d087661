#include "polhode/quadrature/contour.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "path_pieces.hpp"
#include "polhode/arithmetic/text.hpp"
#include "quadrature/pieces/segments.hpp"

namespace polhode {

namespace {

void require_finite(const end_point& x, const char* what) {
  if (x.infinite_sign() != 0) {
    throw std::invalid_argument(std::string(what) + " of a path is infinite; it must be finite");
  }
}

path_piece reversed(const line_piece& line) { return line_piece{line.to, line.from}; }
path_piece reversed(const arc_piece& arc) {
  return arc_piece{arc.centre, arc.radius, arc.to_angle, arc.from_angle};
}

}  // namespace

path_point::path_point(const end_point& re, const end_point& im) : re_(re), im_(im) {
  require_finite(re_, "a point");
  require_finite(im_, "a point");
}

path path::line(const path_point& from, const path_point& to) {
  path result;
  result.pieces_.emplace_back(line_piece{from, to});
  return result;
}

path path::polygon(const std::vector<path_point>& points) {
  path result;
  for (std::size_t k = 1; k < points.size(); ++k) {
    result.pieces_.emplace_back(line_piece{points[k - 1], points[k]});
  }
  return result;
}

path path::arc(const path_point& centre, const end_point& radius, const end_point& from_angle,
               const end_point& to_angle) {
  require_finite(radius, "a radius");
  require_finite(from_angle, "an angle");
  require_finite(to_angle, "an angle");
  path result;
  result.pieces_.emplace_back(arc_piece{centre, radius, from_angle, to_angle});
  return result;
}

path path::circle(const path_point& centre, const end_point& radius) {
  return arc(centre, radius, 0, end_point([](precision p) { return 2 * pi(p); }));
}

path operator+(path first, const path& second) {
  first.pieces_.insert(first.pieces_.end(), second.pieces_.begin(), second.pieces_.end());
  return first;
}

path operator-(const path& reversed_path) {
  path result;
  std::transform(reversed_path.pieces_.rbegin(), reversed_path.pieces_.rend(),
                 std::back_inserter(result.pieces_), [](const path_piece& piece) {
                   return std::visit([](const auto& p) { return reversed(p); }, piece);
                 });
  return result;
}

namespace detail {

namespace {

/// b - a; exactly 0 only where that is certain.
ball difference(const end_point& a, const end_point& b, precision p) {
  if (!a.exact() || !b.exact()) return b.at(p) - a.at(p);
  return {rational(*b.exact() - *a.exact()), p};
}
complex_ball difference(const path_point& a, const path_point& b, precision p) {
  return {difference(a.re(), b.re(), p), difference(a.im(), b.im(), p)};
}

bool is_zero(const ball& x) { return x.is_exact() && contains_zero(x); }

bool has_no_length(const line_piece& line) {
  if (line.from.is_same_as(line.to)) return true;
  const complex_ball d = difference(line.from, line.to, 64);
  return is_zero(d.re) && is_zero(d.im);
}
bool has_no_length(const arc_piece& arc) {
  return is_zero(arc.radius.at(64)) || is_zero(difference(arc.from_angle, arc.to_angle, 64));
}

bool is_bounded(const line_piece& line) {
  return line.from.at(64).is_bounded() && line.to.at(64).is_bounded();
}
bool is_bounded(const arc_piece& arc) {
  return arc.centre.at(64).is_bounded() && arc.radius.at(64).is_bounded() &&
         arc.from_angle.at(64).is_bounded() && arc.to_angle.at(64).is_bounded();
}

/// A constant for regions: in the hardware, or with the precision that is asked for.
template <class At>
auto region_constant_at(At at) {
  return [at, in_hardware = region(at(128))](const region& like) {
    if (like.is_in_hardware()) return in_hardware;
    return region::in_balls(complex_ball(at(like.precision())));
  };
}

/// z = a + (b - a) t, dz = (b - a) dt.
segment segment_on(const complex_integrand& f, const line_piece& piece) {
  // The functions below are copied often, and a piece takes long to copy.
  const auto line = std::make_shared<const line_piece>(piece);
  const auto start = [line](precision p) { return line->from.at(p); };
  const auto length = [line](precision p) { return difference(line->from, line->to, p); };
  segment result;
  result.over = [over = f.over, a = region_constant_at(start),
                 d = region_constant_at(length)](const region& t) { return over(a(t) + d(t) * t); };
  complex_piece along;
  along.evaluator = [=,
                     at = f.evaluator](precision p) -> std::function<complex_ball(const ball& t)> {
    return [a = start(p), d = length(p), g = at(p)](const ball& t) {
      complex_ball z(0, t.precision());
      fma(z.re, d.re, t, a.re);
      fma(z.im, d.im, t, a.im);
      return g(z);
    };
  };
  along.scale = length;
  along.position = [=](const ball& t) { return start(t.precision()) + length(t.precision()) * t; };
  result.along = std::move(along);
  return result;
}

/// z = c + r w, w = e^(i theta), theta = from + (to - from) t, dz = i r w (to - from) dt. All of it
/// is analytic in t.
segment segment_on(const complex_integrand& f, const arc_piece& piece) {
  const auto arc = std::make_shared<const arc_piece>(piece);
  const auto centre = [arc](precision p) { return arc->centre.at(p); };
  const auto radius = [arc](precision p) { return arc->radius.at(p); };
  const auto start = [arc](precision p) { return arc->from_angle.at(p); };
  const auto turn = [arc](precision p) { return difference(arc->from_angle, arc->to_angle, p); };
  const auto direction = [](const ball& theta) {
    std::pair<ball, ball> both = sin_cos(theta);
    return complex_ball(std::move(both.second), std::move(both.first));
  };
  segment result;
  result.over = [over = f.over, c = region_constant_at(centre), r = region_constant_at(radius),
                 a = region_constant_at(start), d = region_constant_at(turn)](const region& t) {
    const region w = exp(times_i(a(t) + d(t) * t));
    return over(c(t) + r(t) * w) * w;
  };
  complex_piece along;
  along.evaluator = [=,
                     at = f.evaluator](precision p) -> std::function<complex_ball(const ball& t)> {
    return [=, c = centre(p), r = radius(p), a = start(p), d = turn(p), g = at(p)](const ball& t) {
      ball theta;
      fma(theta, d, t, a);
      const complex_ball w = direction(theta);
      return g(c + w * r) * w;
    };
  };
  along.scale = [=](precision p) { return complex_ball(ball(0, p), radius(p) * turn(p)); };
  along.position = [=](const ball& t) {
    const precision p = t.precision();
    return centre(p) + direction(start(p) + turn(p) * t) * radius(p);
  };
  const magnitude angle = max(max(ball(1, 64).magnitude_upper(), start(64).magnitude_upper()),
                              arc->to_angle.at(64).magnitude_upper());
  along.size =
      add_up(centre(64).magnitude_upper(), multiply_up(radius(64).magnitude_upper(), angle));
  result.along = std::move(along);
  return result;
}

/// As obstacles elsewhere on a path are named.
std::string in_words(const obstacle_near_end& found) {
  const std::string at = " near z = " + to_decimal(found.position, 20);
  switch (found.why) {
    case obstacle::none:
      return "a bound too large to be of use" + at;
    case obstacle::unknown:
      return found.where + " of complex arguments is not available" + at;
    case obstacle::undefined:
      return "an undefined value" + (found.where.empty() ? "" : " in " + found.where) + at;
    default:
      return "the " + to_text(found.why) + " of " + found.where + at;
  }
}

}  // namespace

contour_integral integrate_path(const complex_integrand& f, const path& along,
                                const integrate_options& options) {
  if (options.digits < 1) throw std::invalid_argument("integrate_along: digits must be at least 1");
  contour_integral result;
  if (options.rule != quadrature_rule::automatic &&
      options.rule != quadrature_rule::gauss_legendre) {
    result.why = reason::not_applicable;
    result.obstacle = "along a path the rule is Gauss and Legendre's";
    return result;
  }
  preparation prepared;
  const precision bits = 64 + 2 * bits_for_digits(options.digits);
  for (const path_piece& piece : along.pieces()) {
    if (!std::visit([](const auto& p) { return is_bounded(p); }, piece)) {
      result.why = reason::not_defined;
      result.obstacle = "a point of the path is not a number";
      return result;
    }
    if (std::visit([](const auto& p) { return has_no_length(p); }, piece)) continue;
    prepared.segments.push_back(std::visit([&](const auto& p) { return segment_on(f, p); }, piece));
    if (!runs_over(prepared.segments.back(), piece, bits)) {
      throw std::logic_error("integrate_along: what is integrated over a piece is not the piece");
    }
  }
  if (const auto gap = gap_between(along.pieces(), bits)) {
    throw std::invalid_argument("integrate_along: " + *gap);
  }
  if (prepared.segments.empty()) {
    result.enclosure = complex_ball(0, 64);
    result.verdict = status::certified;
    return result;
  }
  // Far below where what is beside an end could be told from it in the enclosure.
  const long deepest = 420 + 4 * options.digits;
  long evaluations = 0;
  for (const segment& s : prepared.segments) {
    const std::optional<obstacle_near_end> found = obstacle_near_ends(s, deepest, evaluations);
    if (!found) continue;
    result.why = reason::not_analytic;
    result.obstacle = in_words(*found);
    result.account.region_evaluations = evaluations;
    return result;
  }
  result = integrate_segments(prepared, options);
  result.account.region_evaluations += evaluations;
  return result;
}

}  // namespace detail
}  // namespace polhode
