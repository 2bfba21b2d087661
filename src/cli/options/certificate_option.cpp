#include "certificate_option.hpp"

#include <fmt/format.h>

#include "cli/output/errors.hpp"

namespace polhode::cli {

void certificate_option::expect_certified(bool certified) const {
  if (path && !certified) {
    throw not_certified_error(fmt::format(
        "--certificate {}: not written, for the result is not certified", in_quotes(*path)));
  }
}

}  // namespace polhode::cli
