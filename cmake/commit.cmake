# SPDX-License-Identifier: Apache-2.0
# cmake -D SOURCE=TREE -D OUT=FILE.cpp [-D GIT=PROGRAM] -P commit.cmake: writes the commit of a source tree as a C++ source. A file that already
# says so stays untouched, and nothing is built again.
set(commit unknown)
set(dirty std::nullopt)

# git(RESULT ARGUMENT...): the output of a git command in the tree, or nothing. A hook of git sets these variables for another repository.
function(git result)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env --unset=GIT_DIR --unset=GIT_WORK_TREE --unset=GIT_INDEX_FILE ${GIT} --no-optional-locks -C ${SOURCE} ${ARGN}
    OUTPUT_VARIABLE output RESULT_VARIABLE failed ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(failed ${failed} PARENT_SCOPE)
  set(${result} "${output}" PARENT_SCOPE)
endfunction()

if(GIT)
  git(top rev-parse --show-toplevel)
  file(REAL_PATH "${SOURCE}" source)
  # Unpacked inside another repository, a tree has no commit of its own.
  if(NOT failed AND top STREQUAL source)
    git(head rev-parse --verify HEAD)
    if(NOT failed)
      set(commit ${head})
      # Files that git does not know are left out: a source of the build is named in a file that it knows.
      git(changes status --porcelain --untracked-files=no)
      if(NOT failed AND changes STREQUAL "")
        set(dirty false)
      elseif(NOT failed)
        set(dirty true)
      endif()
    endif()
  endif()
endif()

file(CONFIGURE OUTPUT ${OUT} CONTENT [[
// Written by cmake/commit.cmake.
#include "runtime/provenance/commit.hpp"

namespace caravan::runtime {

Commit commit_of_build() { return {.id = "@commit@", .dirty = @dirty@}; }

}  // namespace caravan::runtime
]] @ONLY)
