# The checker uses nothing of the prover: no symbol of the prover's or of MPFR is missing from its
# library; its sources include GMP, Boost's headers over it, a reader of JSON, the standard library,
# themselves, the texts of the claims and the digest's header, and nothing else; and the program
# polhode-check needs GMP and the C++ runtime alone. LIBRARY, PROGRAM, SOURCES, HEADERS, NM and
# READELF are given.

execute_process(COMMAND "${NM}" --demangle "${LIBRARY}"
  OUTPUT_VARIABLE symbols RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${NM} does not read ${LIBRARY}")
endif()
string(REPLACE ";" "," symbols "${symbols}")
string(REGEX MATCHALL "[^\n]+" lines "${symbols}")
list(LENGTH lines count)
if(count LESS 100 OR NOT symbols MATCHES "__gmpz_" OR NOT symbols MATCHES "polhode::checker::check\\(")
  message(FATAL_ERROR "these are not the checker's symbols (${count} lines)")
endif()
foreach(line IN LISTS lines)
  if(line MATCHES "mpfr|mpfi|arb_")
    message(FATAL_ERROR "the checker uses MPFR: ${line}")
  endif()
  if(line MATCHES " U .*polhode::" AND NOT line MATCHES " U polhode::(checker::|sha256\\()")
    if(NOT line MATCHES " U .*polhode::checker::")
      message(FATAL_ERROR "the checker uses the prover: ${line}")
    endif()
  endif()
endforeach()

# An ELF program names its libraries.
execute_process(COMMAND "${READELF}" --dynamic "${PROGRAM}"
  OUTPUT_VARIABLE dynamic RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${READELF} does not read ${PROGRAM}")
endif()
string(REGEX MATCHALL "Shared library: \\[[^\n]*\\]" libraries "${dynamic}")
if(NOT libraries MATCHES "libgmp")
  message(FATAL_ERROR "polhode-check does not name its libraries: ${libraries}")
endif()
foreach(library IN LISTS libraries)
  # Sanitizers bring a library of their own.
  if(NOT library MATCHES "\\[(libgmp|libstdc\\+\\+|libc\\+\\+|libgcc_s|libc|libm|libpthread|libasan|libubsan|libtsan|ld-linux[a-z0-9_-]*)\\.so")
    message(FATAL_ERROR "polhode-check needs more than GMP: ${library}")
  endif()
endforeach()

file(GLOB sources "${SOURCES}/*.?pp" "${SOURCES}/claims/*.?pp" "${SOURCES}/program/*.?pp" "${HEADERS}/*.hpp")
list(LENGTH sources count)
if(count LESS 60)
  message(FATAL_ERROR "these are not the checker's sources: ${sources}")
endif()
foreach(source IN LISTS sources)
  file(STRINGS "${source}" includes REGEX "^ *# *include")
  foreach(include IN LISTS includes)
    if(NOT include MATCHES "^#include (<[a-z_]+>|<(fcntl|unistd|sys/stat)\\.h>|<boost/multiprecision/gmp\\.hpp>|<nlohmann/json\\.hpp>|\"(checker/|claims/)?[a-z_]+\\.hpp\"|\"statements/[A-Za-z0-9_]+\\.hpp\"|\"polhode/checker/[a-z]+\\.hpp\"|\"base/sha256\\.hpp\")$")
      message(FATAL_ERROR "${source}: ${include}")
    endif()
  endforeach()
endforeach()
