# The checker is a project of its own: src/checker is configured, built and installed apart, where
# no other package than its own is looked for and a warning is an error, and the program verifies a
# certificate and refuses a forged one. SOURCES, WORK, CERTIFICATES, COMPILER, LAUNCHER, FLAGS and
# GENERATOR are given.

file(REMOVE_RECURSE "${WORK}")
function(run expected)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL expected)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nended with ${status}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

set(without)
foreach(package IN ITEMS MPFR fmt CLI11 TBB tomlplusplus pugixml GTest)
  list(APPEND without "-DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON")
endforeach()
run(0 "${CMAKE_COMMAND}" -S "${SOURCES}" -B "${WORK}/build" -G "${GENERATOR}" ${without}
  "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}"
  # At -O3 g++ 12 warns of an overlap inside of std::string's own operator+ (GCC's bug 105651).
  "-DCMAKE_CXX_FLAGS=${FLAGS}" "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG" -DCMAKE_COMPILE_WARNING_AS_ERROR=ON)
run(0 "${CMAKE_COMMAND}" --build "${WORK}/build" --target polhode-check)
run(0 "${CMAKE_COMMAND}" --install "${WORK}/build" --prefix "${WORK}/prefix")
foreach(file IN ITEMS bin/polhode-check include/polhode/checker/check.hpp)
  if(NOT EXISTS "${WORK}/prefix/${file}")
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()

set(program "${WORK}/prefix/bin/polhode-check")
run(0 "${program}" "${CERTIFICATES}/beta.json")
if(NOT output MATCHES "1 certificate: 1 verified\n$")
  message(FATAL_ERROR "it printed:\n${output}")
endif()
file(READ "${CERTIFICATES}/beta.json" text)
string(REPLACE "0.0289" "0.0288" text "${text}")
file(WRITE "${WORK}/forged.json" "${text}")
run(1 "${program}" "${WORK}/forged.json")
if(NOT output MATCHES "refuted: at /statement: ")
  message(FATAL_ERROR "it printed:\n${output}")
endif()
