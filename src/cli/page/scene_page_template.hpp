#pragma once

#include <string_view>

namespace polhode::cli {

/// The page of a scene but for its data, which go in the place of "%DATA%": src/cli/page/, bundled
/// by npm's esbuild. Empty where the program was built without npm.
extern const std::string_view page_template;

}  // namespace polhode::cli
