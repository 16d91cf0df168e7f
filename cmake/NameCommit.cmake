# SPDX-License-Identifier: GPL-3.0-or-later
# elgen_name_commit(TARGET): compiles the hash of the current git commit into TARGET. CMake runs again after a commit.
# Without git or a repository the hash is empty.
function(elgen_name_commit target)
  set(ELGEN_COMMIT)
  if(EXISTS ${PROJECT_SOURCE_DIR}/.git)
    execute_process(COMMAND git rev-parse --git-path logs/HEAD --short=12 HEAD
                    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
                    OUTPUT_VARIABLE lines ERROR_QUIET)
    if(lines MATCHES "^(.+)\n([0-9a-f]+)\n$")
      set(ELGEN_COMMIT ${CMAKE_MATCH_2})
      file(REAL_PATH "${CMAKE_MATCH_1}" log BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
      if(EXISTS "${log}")
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${log}")
      endif()
    endif()
  endif()
  configure_file(src/cli/help/commit.cpp.in commit.cpp @ONLY)
  set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/commit.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_sources(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/commit.cpp)
endfunction()
