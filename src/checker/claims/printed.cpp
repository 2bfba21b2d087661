#include "printed.hpp"

#include <stdexcept>

#include "constants.hpp"
#include "statements/shared.hpp"

namespace polhode::checker {

rational number_in(const char* text) {
  rational q;
  if (!read_decimal(text, q)) throw std::logic_error("no decimal");
  return q;
}

body with_ab(const char* a, const char* b) { return {number_in(a), number_in(b)}; }

body with_constants(const char* C, const char* B, const char* A) {
  return {number_in(A) / number_in(B) - 1, 1 - number_in(C) / number_in(B)};
}

body water_at_equilibrium() { return with_constants("9.5077", "14.5924", "27.2660"); }

std::function<interval(precision bits)> I_of(const body& rigid) {
  return [rigid](precision bits) { return rigid.I(bits); };
}

tri is_right(const interval& value, const char* printed, int places) {
  const rational half(power_of_ten(-places) / 2);
  const rational p = number_in(printed);
  return all_of({below(exactly(rational(p - half), value.bits()), value),
                 below(value, exactly(rational(p + half), value.bits()))});
}

tri is_wrong(const interval& value, const char* printed, int places) {
  const tri right = is_right(value, printed, places);
  return right ? tri(!*right) : std::nullopt;
}

void check_printed(examination& e, const std::vector<printed_number>& numbers, bool right) {
  for (const printed_number& n : numbers) {
    const std::string name = std::string(n.where) + ": " + n.what;
    if (n.value) {
      e.number(name, n.value);
    } else {
      e.root_number(name, false, mean_equation);
    }
  }
  for (const printed_number& n : numbers) {
    e.fact(statements::fill(right ? statements::printed_and_right : statements::printed_and_wrong,
                            {n.where, n.as_read, n.what, std::string(n.in_short) + "..."}),
           [&](precision bits) -> tri {
             const rational cut = number_in(n.in_short);
             const auto decimals = static_cast<long>(std::string(n.in_short).find('.'));
             const auto length = static_cast<long>(std::string(n.in_short).size());
             const rational unit = power_of_ten(decimals + 1 - length);
             if (!n.value) {  // beta lies where its equation changes sign
               const interval low = mean_equation(cut, bits);
               const interval high = mean_equation(rational(cut + unit), bits);
               const interval box = interval::between(cut, rational(cut + unit), bits);
               return all_of({tri(low.is_negative()), tri(high.is_positive()),
                              is_right(box, n.printed, n.places)});
             }
             const interval value = n.value(bits);
             return all_of({below(exactly(cut, bits), value),
                            below(value, exactly(rational(cut + unit), bits)),
                            right ? is_right(value, n.printed, n.places)
                                  : is_wrong(value, n.printed, n.places)});
           });
  }
}

}  // namespace polhode::checker
