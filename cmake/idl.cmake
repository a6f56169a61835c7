# SPDX-License-Identifier: Apache-2.0
# caravan_idl_library(NAME FILES...): DDS type support generated at build time; nothing generated is committed.
find_program(FASTDDSGEN fastddsgen REQUIRED)

# For fastddsgen 4 (Fast DDS 3): no TypeObjects, which version 2 does not generate either and which DDS would send to every peer; the headers
# are X.hpp, so X.h is one line. Both exist with and without "PubSubTypes".
if(CARAVAN_FASTDDS STREQUAL fastdds)
  set(CARAVAN_FASTDDSGEN_OPTIONS -flat-output-dir -no-typeobjectsupport)
  set(CARAVAN_FASTDDSGEN_HEADER .hpp)
  set(CARAVAN_FASTDDSGEN_SOURCES PubSubTypes.cxx)
else()
  set(CARAVAN_FASTDDSGEN_OPTIONS)
  set(CARAVAN_FASTDDSGEN_HEADER .h)
  set(CARAVAN_FASTDDSGEN_SOURCES .cxx PubSubTypes.cxx)
endif()

function(caravan_idl_library name)
  cmake_parse_arguments(arg "" "" "FILES" ${ARGN})
  # One folder per library: every run also writes the files of the IDL that it includes, while the compiler may be reading those of another.
  set(out ${CMAKE_CURRENT_BINARY_DIR}/generated/${name})
  file(MAKE_DIRECTORY ${out})
  set(sources)
  file(GLOB all_idl CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.idl)
  foreach(file IN LISTS arg_FILES)
    get_filename_component(stem ${file} NAME_WE)
    set(made)
    foreach(end IN ITEMS ${CARAVAN_FASTDDSGEN_SOURCES})
      list(APPEND made ${out}/${stem}${end})
    endforeach()
    set(headers)
    foreach(part IN ITEMS ${stem} ${stem}PubSubTypes)
      list(APPEND headers ${out}/${part}${CARAVAN_FASTDDSGEN_HEADER})
      if(NOT CARAVAN_FASTDDSGEN_HEADER STREQUAL .h)
        file(CONFIGURE OUTPUT ${out}/${part}.h CONTENT "#include \"${part}${CARAVAN_FASTDDSGEN_HEADER}\"\n")
      endif()
    endforeach()
    # -replace: without it a stale output is kept silently. A change in one file regenerates all, because they include each other.
    # -t: preprocessed files go to a folder for this run; two concurrent runs in the shared default folder corrupt each other.
    file(MAKE_DIRECTORY ${out}/${stem}.tmp)
    add_custom_command(OUTPUT ${made} ${headers}
      COMMAND ${FASTDDSGEN} ${CARAVAN_FASTDDSGEN_OPTIONS} -replace -I ${CMAKE_CURRENT_SOURCE_DIR} -d ${out} -t ${out}/${stem}.tmp ${CMAKE_CURRENT_SOURCE_DIR}/${file} > ${out}/${stem}.log
      DEPENDS ${all_idl}
      COMMENT "fastddsgen ${file}" VERBATIM)
    list(APPEND sources ${made} ${headers})
  endforeach()
  add_library(${name} STATIC ${sources})
  target_include_directories(${name} SYSTEM PUBLIC ${out})
  target_link_libraries(${name} PUBLIC ${CARAVAN_FASTDDS} fastcdr)
endfunction()
