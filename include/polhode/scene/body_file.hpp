#pragma once

// A body in a JSON file, its numbers exact.

#include <array>
#include <map>
#include <optional>
#include <string>

#include "polhode/rigid_body/body.hpp"

namespace polhode {

/// One of
///   {"ab": [a, b]}
///   {"moments": [Ix, Iy, Iz]}, and "sigma": [sx, sy, sz] beside it where they are known up to that
///   {"rotational": [A, B, C]}
///   {"tensor": [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]}
/// and a "name" where it has one. Numbers are read exactly as they stand, 0.0629 as 629/10000; a
/// string may hold a quotient, "1/3".
struct body_file {
  std::optional<std::array<rational, 2>> ab;
  std::optional<std::array<rational, 3>> moments;
  std::optional<std::array<rational, 3>> sigma;
  std::optional<std::array<rational, 3>> rotational;
  std::optional<std::array<rational, 6>> tensor;  // xx, yy, zz, xy, xz, yz
};

/// Throws input_error, which says what was found and what would be right.
[[nodiscard]] body_file read_body_file(const std::string& path);
/// The same of what stands in such a file.
[[nodiscard]] body_file parse_body_file(const std::string& text);

/// A whole file of text. Throws input_error where it is no regular file (a pipe would be waited
/// for), cannot be read, is empty, or is longer than 4,000,000 bytes.
[[nodiscard]] std::string read_text_file(const std::string& path);

/// Such files, each read once.
class text_files {
 public:
  [[nodiscard]] const std::string& operator[](const std::string& path);

 private:
  std::map<std::string, std::string> read_;
};

}  // namespace polhode
