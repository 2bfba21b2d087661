#pragma once

// What a command prints with --format json.

#include <string>
#include <string_view>

#include "polhode/certificate/certificate.hpp"

namespace polhode::cli {

/// Of the JSON that the commands print: raised when a key gets another meaning or goes.
/// Certificates have their own.
inline constexpr int json_version = 2;

/// {"format": "polhode NAME", "version": 2, ...the content's keys}.
[[nodiscard]] json json_document(std::string_view name, const json& content);

/// Indented text, without a line end. What is no UTF-8, in a file's name, becomes U+FFFD.
[[nodiscard]] std::string json_text(const json& value);

/// A document as text, with a line end.
[[nodiscard]] std::string json_document_text(std::string_view name, const json& content);

}  // namespace polhode::cli
