# SPDX-License-Identifier: Apache-2.0
# caravan_idl_library(NAME FILES...): DDS type support generated at build time; nothing generated is committed.
find_program(FASTDDSGEN fastddsgen REQUIRED)

function(caravan_idl_library name)
  cmake_parse_arguments(arg "" "" "FILES" ${ARGN})
  # A folder for each library: every run writes the files of what it includes too, while others may be read by the compiler.
  set(out ${CMAKE_CURRENT_BINARY_DIR}/generated/${name})
  file(MAKE_DIRECTORY ${out})
  set(sources)
  file(GLOB all_idl CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.idl)
  foreach(file IN LISTS arg_FILES)
    get_filename_component(stem ${file} NAME_WE)
    set(made ${out}/${stem}.cxx ${out}/${stem}PubSubTypes.cxx)
    set(headers ${out}/${stem}.h ${out}/${stem}PubSubTypes.h)
    # -replace: without it a stale output is kept silently. A change in one file regenerates all, since they include each other.
    # -t: preprocessed files go to a folder of the run's own; two runs at a time in the shared default garble each other.
    file(MAKE_DIRECTORY ${out}/${stem}.tmp)
    add_custom_command(OUTPUT ${made} ${headers}
      COMMAND ${FASTDDSGEN} -replace -I ${CMAKE_CURRENT_SOURCE_DIR} -d ${out} -t ${out}/${stem}.tmp ${CMAKE_CURRENT_SOURCE_DIR}/${file} > ${out}/${stem}.log
      DEPENDS ${all_idl}
      COMMENT "fastddsgen ${file}" VERBATIM)
    list(APPEND sources ${made} ${headers})
  endforeach()
  add_library(${name} STATIC ${sources})
  target_include_directories(${name} SYSTEM PUBLIC ${out})
  target_link_libraries(${name} PUBLIC fastrtps fastcdr)
endfunction()
