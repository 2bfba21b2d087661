#include "polhode/real/integrate.hpp"

namespace polhode {

std::string to_text(truncation_verdict v) {
  return v == truncation_verdict::proved ? "proved" : "not proved";
}

}  // namespace polhode
