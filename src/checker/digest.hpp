#pragma once

#include <string>

#include "document.hpp"

namespace polhode::checker {

/// "sha256:…" of the certificate's canonical text: JSON in the order of its keys, without spaces
/// and without the member "digest", other characters than ASCII as they are in UTF-8.
[[nodiscard]] std::string digest_of(const place& certificate);

}  // namespace polhode::checker
