# Installs BUILD_DIR to an empty prefix, builds the consumer project beside this file against that
# prefix alone, runs it, and compares what it prints with README.md, which shows the program as
# well.

set(work "${BUILD_DIR}/consumer")
set(prefix "${work}/prefix")
file(REMOVE_RECURSE "${work}")

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}\nended with ${status}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${prefix}")
run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${work}/build" -G "${GENERATOR}"
  "-DCMAKE_PREFIX_PATH=${prefix}"
  "-DCMAKE_BUILD_TYPE=Release"
  "-DCMAKE_CXX_COMPILER=${COMPILER}"
  "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}"
  # g++ 12 sees overlapping copies where std::string is appended to (gcc.gnu.org/PR105651); clang
  # does not know the option.
  "-DCMAKE_CXX_FLAGS=${FLAGS} -Wall -Wextra -Wconversion -Wshadow -Wpedantic -Werror -Wno-unknown-warning-option -Wno-restrict")
run("${CMAKE_COMMAND}" --build "${work}/build")

run("${work}/build/consumer")
set(printed "0.74682413281242702539946743613185300535449968681261 +- 2e-55")
if(NOT output STREQUAL "${printed}\n")
  message(FATAL_ERROR "the consumer printed:\n${output}")
endif()

set(certificate "${CMAKE_CURRENT_LIST_DIR}/../../proofs/certificates/beta.json")
run("${work}/build/consumer_checker" "${certificate}")
if(NOT output STREQUAL "verified: claim \"beta\"\n")
  message(FATAL_ERROR "the checker's consumer printed:\n${output}")
endif()
run("${prefix}/bin/polhode-check" "${certificate}")
run("${prefix}/bin/polhode-check" --version)
if(NOT output STREQUAL "${VERSION}${SUFFIX}\n")
  message(FATAL_ERROR "the installed checker's --version printed:\n${output}")
endif()

run("${work}/build/consumer_everything")
if(NOT output STREQUAL "${VERSION} 0.373412066406213...\n0.246824132812427... 1\n")
  message(FATAL_ERROR "the consumer of all headers printed:\n${output}")
endif()

# The ports of Boost's examples: each ends with 0 where Polhode's answer is proved.
set(ports "${CMAKE_CURRENT_LIST_DIR}/../../examples/boost")
run("${CMAKE_COMMAND}" -S "${ports}" -B "${work}/ports" -G "${GENERATOR}"
  "-DCMAKE_PREFIX_PATH=${prefix}"
  "-DCMAKE_CXX_COMPILER=${COMPILER}"
  "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}"
  "-DCMAKE_CXX_FLAGS=${FLAGS} -Wall -Wextra")
run("${CMAKE_COMMAND}" --build "${work}/ports")
file(READ "${CMAKE_CURRENT_LIST_DIR}/../../docs/boost.md" page)
file(GLOB programs "${ports}/*.cpp")
list(LENGTH programs count)
if(count LESS 10)
  message(FATAL_ERROR "examples/boost has ${count} programs")
endif()
foreach(program IN LISTS programs)
  get_filename_component(name "${program}" NAME_WE)
  run("${work}/ports/${name}")
  if(NOT output MATCHES "Boost .*Polhode ")
    message(FATAL_ERROR "examples/boost/${name} printed:\n${output}")
  endif()
  string(FIND "${page}" "| `${name}` |" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "docs/boost.md does not list examples/boost/${name}.cpp")
  endif()
endforeach()

# What must not compile, and the sentence that says why.
set(sentences
  "this double is not the decimal it looks like"
  "this function takes numbers of one type only"
  "leave out mutable"
  "cannot branch on its argument"
  "A float has too few digits"
  "sin is a function of x"
  "Real is double, long double"
  "Real is double, long double"
  "this double is not the decimal it looks like"
  "Write sin(x) for std::sin(x)"
  "this function takes numbers of one type only"
  "this function takes numbers of one type only"
  "this double is not the decimal it looks like"
  "a double, float or mpfr_float in a formula is not an exact number"
  "a double or float variable in a formula is not an exact number"
  "cannot branch on its argument")
set(number 0)
foreach(sentence IN LISTS sentences)
  math(EXPR number "${number} + 1")
  execute_process(COMMAND "${COMPILER}" -std=c++20 -fsyntax-only "-I${prefix}/include" "-DREFUSED=${number}"
    "${CMAKE_CURRENT_LIST_DIR}/refused.cpp"
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(FIND "${output}" "${sentence}" place)
  string(REGEX MATCHALL " error: " errors "${output}")
  list(LENGTH errors count)
  if(status EQUAL 0 OR place EQUAL -1 OR count GREATER 2)
    message(FATAL_ERROR "refused.cpp with REFUSED=${number} is to be refused by \"${sentence}\", and was:\n${output}")
  endif()
endforeach()

# An older standard of C++: one line, whichever header comes first.
foreach(header IN ITEMS version.hpp polhode.hpp real/roots.hpp arithmetic/magnitude.hpp)
  file(WRITE "${work}/older.cpp" "#include <polhode/${header}>\n")
  execute_process(COMMAND "${COMPILER}" -std=c++17 -fsyntax-only "-I${prefix}/include" "${work}/older.cpp"
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(REGEX MATCHALL "error: " errors "${output}")
  list(LENGTH errors count)
  if(status EQUAL 0 OR NOT count EQUAL 1 OR NOT output MATCHES "Polhode needs C\\+\\+20")
    message(FATAL_ERROR "${header} with -std=c++17 is to be refused in one line, and was:\n${output}")
  endif()
endforeach()

run("${prefix}/bin/polhode" --version)
if(NOT output MATCHES "${VERSION}")
  message(FATAL_ERROR "the installed program's --version printed:\n${output}")
endif()

file(READ "${CMAKE_CURRENT_LIST_DIR}/main.cpp" program)
file(READ "${CMAKE_CURRENT_LIST_DIR}/../../README.md" readme)
string(REPLACE "\n" "\n    " program "    ${program}")
string(REPLACE "\n    \n" "\n\n" program "${program}")
string(STRIP "${program}" program)
foreach(text IN ITEMS "${program}" "prints `${printed}`")
  string(FIND "${readme}" "${text}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "README.md does not show what tests/consumer/main.cpp is or prints:\n${text}")
  endif()
endforeach()

file(STRINGS "${CMAKE_CURRENT_LIST_DIR}/../../CITATION.cff" cited REGEX "^version: ")
if(NOT cited STREQUAL "version: ${VERSION}${SUFFIX}")
  message(FATAL_ERROR "CITATION.cff has \"${cited}\", and the version is ${VERSION}${SUFFIX}")
endif()
