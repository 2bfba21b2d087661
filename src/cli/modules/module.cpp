#include "module.hpp"

#include <dlfcn.h>

#include <filesystem>

#include <fmt/format.h>

#include "cli/output/errors.hpp"

namespace polhode::cli {

void* function_of_module(const std::string& name, const char* function) {
  const std::string file = fmt::format("polhode_{}.so", name);
  const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  for (const auto& place : {own / file, own / POLHODE_MODULES_FROM_BIN / file}) {
    if (!std::filesystem::exists(place)) continue;
    // MPI loads parts of its own, which look for its functions: they must be global.
    void* const module = dlopen(place.c_str(), RTLD_NOW | RTLD_GLOBAL);
    if (module == nullptr)
      throw usage_error(fmt::format("{} cannot be loaded: {}", file, dlerror()));
    return dlsym(module, function);
  }
  return nullptr;
}

}  // namespace polhode::cli
