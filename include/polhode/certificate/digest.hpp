#pragma once

// The digest that seals a certificate.

#include <string>

#include "polhode/language.hpp"

namespace polhode {

/// "sha256:…" of the text: of a certificate's JSON form without this member (docs/certificates.md).
[[nodiscard]] std::string digest_of(const std::string& text);

}  // namespace polhode
