#ifdef POLHODE_WITH_ARB

#include "arb_library.hpp"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace polhode::detail {

namespace {

arb_library loaded() {
  void* const library = dlopen(POLHODE_ARB_LIBRARY, RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) {
    throw std::runtime_error(std::string("Arb, which has special functions, cannot be loaded: ") +
                             dlerror());
  }
  arb_library result;
#define POLHODE_ARB_LOAD(f)                                                            \
  result.f = reinterpret_cast<decltype(result.f)>(dlsym(library, #f));                 \
  if (result.f == nullptr) {                                                           \
    throw std::runtime_error("Arb, which has special functions, has no function " #f); \
  }
  POLHODE_ARB_FUNCTIONS(POLHODE_ARB_LOAD)
#undef POLHODE_ARB_LOAD
  return result;
}

}  // namespace

const arb_library& arb() {
  static const arb_library library = loaded();
  return library;
}

}  // namespace polhode::detail

#endif
