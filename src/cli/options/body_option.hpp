#pragma once

// BODY: which rigid body a subcommand is about.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cli/cli_app.hpp"
#include "polhode/rigid_body/body.hpp"

namespace polhode::cli {

/// --ab A,B, --moments IX,IY,IZ, --rotational A,B,C, --tensor XX,YY,ZZ,XY,XZ,YZ or --body FILE
struct body_option {
  std::optional<std::string> ab;
  std::optional<std::string> moments;
  std::optional<std::string> rotational;
  std::optional<std::string> tensor;
  std::optional<std::string> file;

  /// ab_description is the help of --ab where it takes more than a body here.
  void declare(CLI::App& app, const std::optional<std::string>& ab_description = std::nullopt);
  [[nodiscard]] bool is_given() const { return ab || moments || rotational || tensor || file; }
  /// "--ab", or what else was given.
  [[nodiscard]] const char* name() const;
  /// Throws usage_error where not exactly one was given, where it cannot be read or is not a body,
  /// and for a file with sigma.
  [[nodiscard]] body value() const;
  /// Its inertia tensor xx, yy, zz, xy, xz, yz, where it is given by that or by its moments.
  [[nodiscard]] std::optional<std::array<rational, 6>> tensor_entries() const;
  /// Moments with uncertainties: --moments with ± or with this sigma, or those of a file that has
  /// one. Nothing where there are none. They are those of an uncertain_body; throws usage_error.
  [[nodiscard]] std::optional<std::array<uncertain_moment, 3>> uncertain(
      const std::optional<std::string>& sigma = std::nullopt) const;
};

/// The same options, each as often as wanted.
struct bodies_option {
  std::vector<std::string> ab;
  std::vector<std::string> moments;
  std::vector<std::string> rotational;
  std::vector<std::string> tensors;
  std::vector<std::string> files;

  void declare(CLI::App& app);
  /// Those by --ab first, then --moments, --rotational, --tensor, --body. Throws usage_error where
  /// there is none.
  [[nodiscard]] std::vector<body> value() const;
};

/// The number that is an option's value, exactly; throws usage_error.
[[nodiscard]] rational read_number(const std::string& option, const std::string& text);

/// "non-physical (ab + 2b > 1)"
[[nodiscard]] std::string described(body_kind kind);

}  // namespace polhode::cli
