#include "polhode/rigid_body/certain_number.hpp"

namespace polhode {

certain_number number_to_digits(const enclosing_function& f, long digits, precision most_guard) {
  certain_number result;
  result.enclosure = enclose_to_digits(f, digits, most_guard);
  const bool is_certain = !result.enclosure.is_undefined();
  result.verdict = is_certain ? status::certified : status::not_certified;
  result.why = is_certain ? reason::none : reason::precision_limit;
  return result;
}

}  // namespace polhode
