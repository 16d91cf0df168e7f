# SPDX-License-Identifier: 0BSD
# elgen_generate(TARGET name INPUTS model-or-scene... [CHECK_AGAINST folder])
#
# Creates an interface library, `name`, with the code that elgen generates from models and scenes. Sources include it
# as `#include "cart_pole/cart_pole.hpp"`. After an edit of a model, only sources that include changed code are
# recompiled. The code is in the build tree only. CHECK_AGAINST adds a test `name.generated`, which fails if the code
# committed in `folder` is not current.
#
# Paths are relative to the current source folder. ELGEN_EXECUTABLE is the path of an elgen to use instead of the
# package's.

function(elgen_generate)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "TARGET;CHECK_AGAINST" "INPUTS")
  _elgen_check_arguments("${arg_TARGET}" "${arg_INPUTS}" "${arg_UNPARSED_ARGUMENTS}" "${arg_KEYWORDS_MISSING_VALUES}")
  if(NOT TARGET ${arg_TARGET})
    add_library(${arg_TARGET} INTERFACE)
  endif()
  _elgen_find_program(program version)
  # No other files are kept in this folder, not even in an in-source build.
  set(directory "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/elgen/${arg_TARGET}")
  _elgen_check_links(CMakeFiles elgen "${arg_TARGET}")
  set(inputs)
  set(folders)
  set(all_files)
  set(stamps)
  foreach(input IN LISTS arg_INPUTS)
    get_filename_component(input "${input}" ABSOLUTE)
    _elgen_list(listed "${program}" "${directory}" "${input}")
    set(folder "${directory}/${listed_name}")
    if(folder IN_LIST folders)
      message(FATAL_ERROR "elgen_generate: two INPUTS would both be written to `${listed_name}`; one is ${input}")
    endif()
    _elgen_check_links(CMakeFiles elgen "${arg_TARGET}" "${listed_name}")
    _elgen_watch(listed_touched "${program}" "${input}" ${listed_sources})
    if(directory MATCHES "#")
      _elgen_generate_now("${program}" "${directory}" "${input}")
    else()
      _elgen_add_command("${program}" "${version}" "${directory}" "${input}")
      list(APPEND stamps "${folder}/elgen.stamp")
    endif()
    list(APPEND inputs "${input}")
    list(APPEND folders "${folder}")
    list(APPEND all_files ${listed_files})
  endforeach()
  # Stale files are removed, so that sources that include them fail to compile.
  string(REPLACE "${directory}/" "" current "${all_files};${stamps}")
  _elgen_remove_stale("${directory}" ${current})

  add_custom_target(${arg_TARGET}_generate DEPENDS ${stamps})
  add_dependencies(${arg_TARGET} ${arg_TARGET}_generate)
  target_include_directories(${arg_TARGET} INTERFACE "$<BUILD_INTERFACE:${directory}>")
  if(all_files MATCHES "\\.hpp(;|$)")
    target_compile_features(${arg_TARGET} INTERFACE cxx_std_17)
  endif()
  # Without contraction to fused multiply-adds GCC and Clang give the same bits.
  target_compile_options(${arg_TARGET} INTERFACE
    $<$<COMPILE_LANG_AND_ID:C,GNU,Clang,AppleClang>:-ffp-contract=off>
    $<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>:-ffp-contract=off>)
  if(DEFINED arg_CHECK_AGAINST)
    get_filename_component(committed "${arg_CHECK_AGAINST}" ABSOLUTE)
    add_test(NAME ${arg_TARGET}.generated COMMAND "${program}" generate -q --check -o "${committed}" ${inputs})
  endif()
endfunction()

function(_elgen_check_arguments target inputs unknown without_value)
  set(usage "write elgen_generate(TARGET plant INPUTS cart_pole.toml [CHECK_AGAINST generated])")
  if(unknown)
    list(JOIN unknown " " unknown)
    message(FATAL_ERROR "elgen_generate: unknown argument `${unknown}`; ${usage}")
  elseif("CHECK_AGAINST" IN_LIST without_value)
    message(FATAL_ERROR "elgen_generate: the folder of CHECK_AGAINST is missing; ${usage}")
  elseif(target STREQUAL "")
    message(FATAL_ERROR "elgen_generate: TARGET is missing; ${usage}")
  elseif(inputs STREQUAL "")
    message(FATAL_ERROR "elgen_generate: INPUTS is missing; ${usage}")
  endif()
  # The target's name is the name of a folder, so it must be one path component and used by no other target.
  if(NOT target MATCHES "^[A-Za-z0-9_.+-]+$" OR target MATCHES "^[.]+$")
    message(FATAL_ERROR "elgen_generate: `${target}` is not a name for a target: it takes letters, digits, `_`, `.`, `+`, `-`")
  endif()
  set(type INTERFACE_LIBRARY)
  set(aliased FALSE)
  if(TARGET ${target})
    get_target_property(type ${target} TYPE)
    get_target_property(aliased ${target} ALIASED_TARGET)
  endif()
  if(NOT type STREQUAL "INTERFACE_LIBRARY" OR aliased OR TARGET ${target}_generate)
    message(FATAL_ERROR "elgen_generate: `${target}` is another target already")
  endif()
endfunction()

# Stops if one of the nested folders below the build folder is a symbolic link, since its files may belong to another
# project.
function(_elgen_check_links)
  set(path "${CMAKE_CURRENT_BINARY_DIR}")
  foreach(folder IN LISTS ARGN)
    string(APPEND path "/${folder}")
    if(IS_SYMLINK "${path}")
      message(FATAL_ERROR "elgen_generate: ${path} is a symbolic link; remove it, for elgen writes and removes files there")
    endif()
  endforeach()
endfunction()

# Sets `result` to the path of the program and `result_version` to its version. A path instead of the imported target,
# because in a cross build CMake runs targets in an emulator, but this elgen runs on the host.
function(_elgen_find_program result result_version)
  if(ELGEN_EXECUTABLE)
    set(program "${ELGEN_EXECUTABLE}")
  else()
    get_target_property(program elgen::elgen IMPORTED_LOCATION)
  endif()
  if(NOT IS_ABSOLUTE "${program}")
    message(FATAL_ERROR "elgen_generate: ELGEN_EXECUTABLE is not an absolute path: ${program}")
  endif()
  execute_process(COMMAND "${program}" --version RESULT_VARIABLE status OUTPUT_VARIABLE version ERROR_VARIABLE error)
  if(NOT status EQUAL 0 OR NOT version MATCHES "^elgen ")
    message(FATAL_ERROR "elgen_generate: ${program} does not run here (${status}); ELGEN_EXECUTABLE names another\n${error}")
  endif()
  set(${result} "${program}" PARENT_SCOPE)
  set(${result_version} "${version}" PARENT_SCOPE)
endfunction()

# Sets PREFIX_name, PREFIX_files and PREFIX_sources to elgen's listing for an input. If the input has an error, the
# last listing is used and PREFIX_has_error is set, so that the build reports the error. Without an earlier listing
# CMake reports it.
function(_elgen_list prefix program directory input)
  if(NOT EXISTS "${input}")
    message(FATAL_ERROR "elgen_generate: there is no ${input}")
  endif()
  set(list_outputs "${program}" generate -q -o "${directory}" --list-outputs "${input}")
  string(MD5 key "${directory} ${input}")
  set(has_error FALSE)
  execute_process(COMMAND ${list_outputs} --format json RESULT_VARIABLE status OUTPUT_VARIABLE json ERROR_QUIET)
  if(NOT status EQUAL 0)
    set(has_error TRUE)
    set(json "$CACHE{ELGEN_LISTING_${key}}")
    if(NOT json)
      execute_process(COMMAND ${list_outputs} OUTPUT_QUIET ERROR_VARIABLE errors)
      message("${errors}")
      message(FATAL_ERROR "elgen_generate: ${input} has the errors above; mend them and run CMake again")
    endif()
  endif()
  string(REPLACE "\n" "" json "${json}")
  set(ELGEN_LISTING_${key} "${json}" CACHE INTERNAL "the files and sources of ${input}")
  string(JSON name GET "${json}" systems 0 name)
  _elgen_get_paths(files "${program}" "${json}" files path)
  _elgen_get_paths(sources "${program}" "${json}" sources)
  foreach(variable name files sources has_error)
    set(${prefix}_${variable} "${${variable}}" PARENT_SCOPE)
  endforeach()
endfunction()

# Sets `result` to an array of the listing, or to one member of each of its objects.
function(_elgen_get_paths result program json array)
  string(JSON count ERROR_VARIABLE error LENGTH "${json}" systems 0 ${array})
  if(error)
    message(FATAL_ERROR "elgen_generate: ${program} is too old: it does not list ${array}")
  endif()
  set(paths)
  math(EXPR last "${count} - 1")
  foreach(i RANGE ${last})
    string(JSON path GET "${json}" systems 0 ${array} ${i} ${ARGN})
    list(APPEND paths "${path}")
  endforeach()
  set(${result} "${paths}" PARENT_SCOPE)
endfunction()

# Makes CMake run again after an edit of the given files. For a file dated in the future Ninja would rerun CMake
# endlessly, and it remembers such a date. So the rules of each build touch the file in `result`, and CMake runs once
# in the next build.
function(_elgen_watch result)
  set(now "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/elgen.now")
  file(TOUCH "${now}")
  set(${result} "" PARENT_SCOPE)
  list(REMOVE_DUPLICATES ARGN)
  foreach(file IN LISTS ARGN)
    if(NOT "${now}" IS_NEWER_THAN "${file}")
      message(WARNING "elgen_generate: ${file} is dated in the future; `touch` mends it")
      set(${result} "${now}" PARENT_SCOPE)
      set(file "${now}")
    endif()
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  endforeach()
endfunction()

# Adds the command that writes the listed files. It always touches its stamp, so that Make and Ninja know when elgen
# ran. An unchanged file keeps its time, so nothing is recompiled. As byproducts the files are known to Ninja, which
# checks them before compiling. Make depends on the folder instead, whose date changes if a file is removed; the stamp
# is touched twice, so that it is not older than the folder. --force, because INPUTS may now have another model of the
# same name.
function(_elgen_add_command program version directory input)
  set(folder "${directory}/${listed_name}")
  set(stamp "${folder}/elgen.stamp")
  if(listed_has_error)
    set(listed_sources "${input}")  # The model of the scene may be missing.
  endif()
  # A source may be replaced by an older file, because packages keep build times. Without its stamp elgen runs anyway.
  set(seen "${version}${listed_has_error}")
  foreach(source IN LISTS listed_sources)
    file(MD5 "${source}" hash)
    string(APPEND seen "${hash}")
  endforeach()
  string(MD5 key "${stamp}")
  string(MD5 seen "${seen}")
  if(NOT seen STREQUAL "$CACHE{ELGEN_SEEN_${key}}")
    file(REMOVE "${stamp}")
    set(ELGEN_SEEN_${key} "${seen}" CACHE INTERNAL "the elgen and the sources of ${stamp}")
  endif()
  if(CMAKE_GENERATOR MATCHES "Make")
    add_custom_command(OUTPUT "${folder}" COMMAND "${CMAKE_COMMAND}" -E make_directory "${folder}" COMMENT "" VERBATIM)
    list(APPEND listed_sources "${folder}")
  endif()
  if(listed_touched)
    # This file never exists, so its rule always runs.
    add_custom_command(OUTPUT "${folder}/always" COMMAND "${CMAKE_COMMAND}" -E touch "${listed_touched}" VERBATIM
                       COMMENT "Asking for CMake in the next build")
    set_property(SOURCE "${folder}/always" PROPERTY SYMBOLIC TRUE)
    list(APPEND listed_sources "${folder}/always")
  endif()
  add_custom_command(
    OUTPUT "${stamp}"
    BYPRODUCTS ${listed_files}
    COMMAND "${program}" generate -q --force -o "${directory}" "${input}"
    COMMAND "${CMAKE_COMMAND}" -E touch "${stamp}" "${stamp}"
    DEPENDS ${listed_sources} "${program}"
    COMMENT "Generating ${listed_name}"
    VERBATIM)
endfunction()

# Writes the listed files immediately, because CMake supports no rules for files in a folder with `#` in its path.
# CMake runs again after an edit or if one of the files is missing.
function(_elgen_generate_now program directory input)
  message(STATUS "Generating ${listed_name}")
  execute_process(COMMAND "${program}" generate -q --force -o "${directory}" "${input}" RESULT_VARIABLE status ERROR_VARIABLE errors)
  if(NOT status EQUAL 0)
    message("${errors}")
    message(FATAL_ERROR "elgen_generate: the errors above are those of ${input}")
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${listed_files})
endfunction()

# Removes code of old names and outputs: files with elgen's marker that are not among the given relative paths.
# file(GLOB) would split a file name with `;` into two, so only names of letters, digits, `_` and `.` are considered.
function(_elgen_remove_stale directory)
  string(REGEX REPLACE "([][*?])" "[\\1]" pattern "${directory}")
  file(GLOB paths LIST_DIRECTORIES FALSE RELATIVE "${directory}" "${pattern}/*/*")
  foreach(path IN LISTS paths)
    get_filename_component(folder "${path}" DIRECTORY)
    set(file "${directory}/${path}")
    if(path IN_LIST ARGN OR NOT path MATCHES "^[A-Za-z0-9_]+/[A-Za-z0-9_.]+$" OR NOT EXISTS "${file}"
       OR IS_SYMLINK "${file}" OR IS_SYMLINK "${directory}/${folder}")
      continue()
    endif()
    file(READ "${file}" start LIMIT 200)
    if(start MATCHES "Code generated by elgen" OR (path MATCHES "/elgen[.]stamp$" AND start STREQUAL ""))
      file(REMOVE "${file}")
      file(GLOB others "${pattern}/${folder}/*")
      if(others STREQUAL "")
        file(REMOVE_RECURSE "${directory}/${folder}")
      endif()
    endif()
  endforeach()
endfunction()
