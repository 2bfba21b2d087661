// Complex balls as sets, and as text.

#include <ostream>
#include <string>

#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/text.hpp"

namespace polhode {

bool contains(const complex_ball& z, const complex_ball& w) {
  return contains(z.re, w.re) && contains(z.im, w.im);
}
bool overlaps(const complex_ball& z, const complex_ball& w) {
  return overlaps(z.re, w.re) && overlaps(z.im, w.im);
}
complex_ball hull(const complex_ball& z, const complex_ball& w) {
  return {hull(z.re, w.re), hull(z.im, w.im)};
}
complex_ball intersection(const complex_ball& z, const complex_ball& w) {
  return {intersection(z.re, w.re), intersection(z.im, w.im)};
}

std::string to_decimal(const complex_ball& z, long most_digits) {
  if (z.is_undefined()) return "undefined";
  const auto part = [&](const ball& x) {
    std::string text = to_decimal(x, most_digits);
    return text.find("±") == std::string::npos ? text : '(' + text + ')';
  };
  const std::string re = part(z.re);
  const std::string im = part(z.im);
  if (im.front() == '-') return re + " - " + im.substr(1) + "*I";
  return re + " + " + im + "*I";
}

std::ostream& operator<<(std::ostream& out, const complex_ball& z) {
  return out << to_decimal(z, std::max<long>(out.precision(), 1));
}

}  // namespace polhode
