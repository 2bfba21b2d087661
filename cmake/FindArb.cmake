# Finds Arb, ball arithmetic, and defines Arb::Arb, for use as #include <arb.h>.
#
# Arb 2 is a library of its own beside FLINT 2 (named flint-arb by Debian, arb elsewhere), with
# headers that include each other by bare name; since FLINT 3 it is part of FLINT.

find_package(MPFR QUIET)
find_path(Arb_INCLUDE_DIR arb.h PATH_SUFFIXES arb flint)
find_path(Arb_FLINT_INCLUDE_DIR flint/flint.h)
find_library(Arb_FLINT_LIBRARY flint)
find_library(Arb_LIBRARY NAMES flint-arb arb flint)
mark_as_advanced(Arb_INCLUDE_DIR Arb_FLINT_INCLUDE_DIR Arb_FLINT_LIBRARY Arb_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Arb
  REQUIRED_VARS Arb_LIBRARY Arb_FLINT_LIBRARY Arb_INCLUDE_DIR Arb_FLINT_INCLUDE_DIR MPFR_FOUND)

if(Arb_FOUND AND NOT TARGET Arb::Arb)
  add_library(Arb::Arb UNKNOWN IMPORTED)
  set_target_properties(Arb::Arb PROPERTIES
    IMPORTED_LOCATION "${Arb_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${Arb_INCLUDE_DIR};${Arb_FLINT_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${Arb_FLINT_LIBRARY};MPFR::MPFR")
endif()
