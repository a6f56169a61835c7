# SPDX-License-Identifier: Apache-2.0
include(CTest)
if(BUILD_TESTING)
  include(GoogleTest)
  # A header instead of definitions for every file: files that do not use these paths compile the same in every checkout.
  set(CARAVAN_BUILD_PATHS_DIR ${CMAKE_BINARY_DIR}/generated/build_paths)
  file(CONFIGURE OUTPUT ${CARAVAN_BUILD_PATHS_DIR}/build_paths.hpp CONTENT [[
#pragma once
#define CARAVAN_SOURCE_DIR "@PROJECT_SOURCE_DIR@"
#define CARAVAN_BIN_DIR "@CMAKE_RUNTIME_OUTPUT_DIRECTORY@"
]] @ONLY)

  # The headers of nearly every test, compiled once: that saves a third of a test's compile time. Test files still include what they use, which
  # a build with another compiler shows. GCC wrongly warns of code of the standard library that comes from a precompiled header.
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    set(CARAVAN_TEST_HEADERS_OPTIONS -Wno-array-bounds -Wno-stringop-overflow -Wno-maybe-uninitialized)
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/test_headers.cpp CONTENT "")
    add_library(caravan_test_headers OBJECT ${CMAKE_BINARY_DIR}/generated/test_headers.cpp)
    target_link_libraries(caravan_test_headers PRIVATE caravan_warnings GTest::gmock)
    target_compile_options(caravan_test_headers PRIVATE ${CARAVAN_TEST_HEADERS_OPTIONS})
    target_precompile_headers(caravan_test_headers PRIVATE
      <gmock/gmock.h> <gtest/gtest.h>
      <algorithm> <chrono> <filesystem> <fstream> <functional> <map> <memory> <optional> <set> <sstream> <string> <thread> <vector>)
  endif()
endif()

# caravan_reuse_test_headers(NAME): compiles a program of tests with the common headers, where there are any.
function(caravan_reuse_test_headers name)
  if(TARGET caravan_test_headers)
    target_precompile_headers(${name} REUSE_FROM caravan_test_headers)
    target_compile_options(${name} PRIVATE ${CARAVAN_TEST_HEADERS_OPTIONS})
  endif()
endfunction()

# caravan_test(NAME LABEL level SOURCES... LINK... [TIMEOUT seconds] [SLOW]): a GoogleTest program; every case is a ctest with that label.
# With SLOW the label is <level>-slow: gtest_discover_tests takes only one label. TIMEOUT is the time that a case may take on an idle machine. On
# other machines tests wait longer themselves (tests/support/patience.hpp); ctest ends a stuck case at ten times that. Cases that may take long start
# first, so that no long one is left when all others have ended.
function(caravan_test name)
  cmake_parse_arguments(arg "SLOW" "LABEL;TIMEOUT" "SOURCES;LINK" ${ARGN})
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 60)
  endif()
  math(EXPR arg_TIMEOUT "10 * ${arg_TIMEOUT}")
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE caravan_warnings GTest::gmock GTest::gtest_main ${arg_LINK})
  caravan_reuse_test_headers(${name})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  target_include_directories(${name} PRIVATE ${CARAVAN_BUILD_PATHS_DIR})
  set(label ${arg_LABEL})
  if(arg_SLOW)
    string(APPEND label -slow)
  endif()
  gtest_discover_tests(${name} TEST_PREFIX "${arg_LABEL}." DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS ${label} TIMEOUT ${arg_TIMEOUT} COST ${arg_TIMEOUT})
endfunction()
