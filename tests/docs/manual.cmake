# The manual's examples as tests. Every block of a page docs/*.md that opens with ```cpp is compiled
# as the body of one test, with `using namespace polhode;` before it and its #include lines moved
# out; what it prints to std::cout must be the block that opens with ```text and follows it, or
# nothing where none does. So the page is the only copy of an example.

# manual_test(PAGE OUTPUT COUNT): writes PAGE's examples to OUTPUT and their number to COUNT.
function(manual_test page output count)
  file(READ "${page}" rest)
  get_filename_component(name "${page}" NAME_WE)
  # A ; would split a list, and [ would quote one: the text is only ever cut by position.
  set(includes "")
  set(tests "")
  set(n 0)
  set(line 1)
  while(TRUE)
    string(FIND "${rest}" "\n```cpp\n" start)
    if(start EQUAL -1)
      break()
    endif()
    string(SUBSTRING "${rest}" 0 ${start} before)
    string(REGEX REPLACE "[^\n]" "" newlines "${before}")
    string(LENGTH "${newlines}" passed)
    math(EXPR line "${line} + ${passed} + 2")
    math(EXPR start "${start} + 8")
    string(SUBSTRING "${rest}" ${start} -1 rest)
    string(FIND "${rest}" "\n```\n" end)
    if(end EQUAL -1)
      message(FATAL_ERROR "${page}:${line}: the example does not end")
    endif()
    string(SUBSTRING "${rest}" 0 ${end} code)
    string(REGEX REPLACE "[^\n]" "" newlines "${code}")
    string(LENGTH "${newlines}" inside)
    math(EXPR end "${end} + 5")
    string(SUBSTRING "${rest}" ${end} -1 rest)

    set(printed "")
    string(FIND "${rest}" "```text\n" text)
    if(text EQUAL 0)
      string(SUBSTRING "${rest}" 8 -1 text)
      string(FIND "${text}" "```\n" end)
      string(SUBSTRING "${text}" 0 ${end} printed)
    endif()

    string(REGEX MATCHALL "#include [^\n;]*\n" found "${code}\n")
    foreach(include IN LISTS found)
      string(APPEND includes "${include}")
    endforeach()
    string(REGEX REPLACE "#include [^\n;]*(\n|$)" "\n" code "${code}")
    math(EXPR n "${n} + 1")
    string(APPEND tests "
TEST(Manual_${name}, Example${n}AtLine${line}) {
  testing::internal::CaptureStdout();
  {
    using namespace polhode;
#line ${line} \"${page}\"
${code}
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), R\"manual(${printed})manual\");
}
")
    math(EXPR line "${line} + ${inside} + 2")
  endwhile()
  set(${count} ${n} PARENT_SCOPE)
  if(n GREATER 0)
    file(GENERATE OUTPUT "${output}" CONTENT
      "// Made of ${page} by tests/docs/manual.cmake.\n#include <iostream>\n#include <gtest/gtest.h>\n${includes}${tests}")
  endif()
endfunction()

file(GLOB pages CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/docs/*.md")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${pages})
set(manual_sources)
foreach(page IN LISTS pages)
  get_filename_component(name "${page}" NAME_WE)
  set(output "${CMAKE_CURRENT_BINARY_DIR}/docs/${name}.cpp")
  manual_test("${page}" "${output}" count)
  if(count GREATER 0)
    list(APPEND manual_sources "${output}")
  endif()
endforeach()

add_executable(test_docs ${manual_sources})
target_compile_options(test_docs PRIVATE
  $<$<CXX_COMPILER_ID:Clang>:-Wno-gnu-zero-variadic-macro-arguments>)  # from GoogleTest's macros
target_link_libraries(test_docs PRIVATE
  polhode::polhode nlohmann_json::nlohmann_json fmt::fmt GTest::gtest_main polhode_warnings)
gtest_discover_tests(test_docs
  TEST_PREFIX "docs/"
  DISCOVERY_TIMEOUT 120
  PROPERTIES LABELS docs TIMEOUT 600)
