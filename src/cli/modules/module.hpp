#pragma once

// Modules: parts of the program that need a library which few runs use. A module is loaded by the
// run that needs it, and may be missing where that library was not found when Polhode was built.

#include <string>

namespace polhode::cli {

/// The function of the module polhode_<name>.so; nullptr where there is no such module. Throws
/// usage_error where it cannot be loaded, as a library of its own is missing.
[[nodiscard]] void* function_of_module(const std::string& name, const char* function);

}  // namespace polhode::cli
