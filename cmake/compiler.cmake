# SPDX-License-Identifier: Apache-2.0
# Compiler settings of every target: C++20, warnings as errors, floating point that does not depend on the optimiser.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
set(CARAVAN_PYTHON_DIR ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/caravan/python)

# A fused multiply-add rounds once instead of twice, so a run would depend on the compiler's choice.
add_compile_options(-ffp-contract=off)

# Line numbers without variables: a backtrace is whole, and the compiler needs a quarter less time. For a debugger: -DCMAKE_BUILD_TYPE=Debug.
add_compile_options($<$<CONFIG:RelWithDebInfo>:-g1>)

set(CARAVAN_SANITIZE "" CACHE STRING "Sanitizers for the whole build, as in -fsanitize=")
if(CARAVAN_SANITIZE)
  add_compile_options(-fsanitize=${CARAVAN_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${CARAVAN_SANITIZE})
  # GCC 12 reports members of std::regex as uninitialised in a build with AddressSanitizer.
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()

# ccache is used where it is installed; nothing depends on it. The sloppiness is what it demands for precompiled headers.
find_program(CARAVAN_CCACHE ccache)
if(CARAVAN_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CARAVAN_CCACHE})
endif()

add_library(caravan_warnings INTERFACE)
target_compile_options(caravan_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror)
# GCC 12 wrongly reports overlapping copies in std::string's operator+ (GCC bug 105651), from -O3 on.
target_compile_options(caravan_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)

# caravan_library(NAME SOURCES... LINK ...): a static library whose headers are included from the repository root.
function(caravan_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  if(arg_SOURCES)
    add_library(${name} STATIC ${arg_SOURCES})
    target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
    target_link_libraries(${name} PUBLIC ${arg_LINK} PRIVATE caravan_warnings ${arg_PRIVATE_LINK})
  else()
    add_library(${name} INTERFACE)
    target_include_directories(${name} INTERFACE ${PROJECT_SOURCE_DIR})
    target_link_libraries(${name} INTERFACE ${arg_LINK})
  endif()
endfunction()

# caravan_parts_of_shared(NAME...): these static libraries can be linked into a shared one. Nobody replaces their functions there, so calls
# between them stay direct.
function(caravan_parts_of_shared)
  set_target_properties(${ARGN} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  foreach(name IN LISTS ARGN)
    target_compile_options(${name} PRIVATE -fno-semantic-interposition)
  endforeach()
endfunction()

# caravan_executable(NAME SOURCES... LINK ...)
function(caravan_executable name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE caravan_warnings ${arg_LINK})
endfunction()
