# Finds PARI, number theory, and defines PARI::PARI, for use as #include <pari/pari.h>.

find_path(PARI_INCLUDE_DIR pari/pari.h)
find_library(PARI_LIBRARY pari)
mark_as_advanced(PARI_INCLUDE_DIR PARI_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(PARI REQUIRED_VARS PARI_LIBRARY PARI_INCLUDE_DIR)

if(PARI_FOUND AND NOT TARGET PARI::PARI)
  add_library(PARI::PARI UNKNOWN IMPORTED)
  set_target_properties(PARI::PARI PROPERTIES
    IMPORTED_LOCATION "${PARI_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${PARI_INCLUDE_DIR}")
endif()
