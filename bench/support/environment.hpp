#pragma once

// What a figure was measured with: the head of every table.

#include <algorithm>
#include <fstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gmp.h>
#include <link.h>
#include <mpfr.h>

#ifdef POLHODE_HAVE_ARB
#include <arb.h>
#endif

namespace polhode::bench {
namespace detail {

[[nodiscard]] inline std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "processor unknown";
}

/// "6.2.1 (the distribution's)", judged by where the dynamic linker found the library.
[[nodiscard]] inline std::string with_origin(const std::string& version, const char* library) {
  struct search {
    std::string name;
    std::string path;
  } wanted{library, {}};
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* data) {
        auto* s = static_cast<search*>(data);
        const std::string path = info->dlpi_name;
        if (path.find('/' + s->name + ".so") == std::string::npos) return 0;
        s->path = path;
        return 1;
      },
      &wanted);
  if (wanted.path.empty()) return version + " (linked statically)";
  const bool of_system = wanted.path.rfind("/lib", 0) == 0 || wanted.path.rfind("/usr/lib", 0) == 0;
  return version + (of_system ? " (the distribution's)" : " (not the distribution's)");
}

}  // namespace detail

/// Names and values.
[[nodiscard]] inline std::vector<std::pair<std::string, std::string>> environment() {
  std::vector<std::pair<std::string, std::string>> result{
      {"machine", detail::processor() + ", " + std::to_string(std::thread::hardware_concurrency()) +
                      " processors, one thread used"},
      {"compiler", __VERSION__},
      {"GMP", detail::with_origin(gmp_version, "libgmp")},
      {"MPFR", detail::with_origin(mpfr_get_version(), "libmpfr")},
  };
#ifdef POLHODE_HAVE_ARB
  result.emplace_back("FLINT", detail::with_origin(flint_version, "libflint"));
#if __FLINT_VERSION < 3
  result.emplace_back("Arb", detail::with_origin(arb_version, "libflint-arb"));
#endif
#endif
  return result;
}

}  // namespace polhode::bench
