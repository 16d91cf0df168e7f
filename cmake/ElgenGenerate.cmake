# SPDX-License-Identifier: 0BSD
# elgen_generate(TARGET name INPUTS model-or-scene... [CHECK_AGAINST folder])
#
# Makes the interface library `name` of the code that elgen writes of models and scenes; its users write
# `#include "cart_pole/cart_pole.hpp"`. An edit of an input, or of the model that a scene names, compiles again what
# includes code that it changed. The code stands in the build tree only. CHECK_AGAINST adds a test, `name.generated`,
# which fails where the code that is committed in `folder` is not current.
#
# Paths are relative to the folder of the caller. ELGEN_EXECUTABLE names another elgen than the one of the package.

function(elgen_generate)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "TARGET;CHECK_AGAINST" "INPUTS")
  _elgen_check_arguments()
  _elgen_find_program()
  set(directory "${CMAKE_CURRENT_BINARY_DIR}/elgen/${arg_TARGET}")
  set(inputs)
  set(stamps)
  set(all_files)
  foreach(relative IN LISTS arg_INPUTS)
    get_filename_component(input "${relative}" ABSOLUTE)
    _elgen_list()
    set(stamp "${directory}/${name}/elgen.stamp")
    if(stamp IN_LIST stamps)
      message(FATAL_ERROR "elgen_generate: two INPUTS would both be written to `${name}`; one is ${input}")
    endif()
    _elgen_add_command()
    list(APPEND inputs "${input}")
    list(APPEND stamps "${stamp}")
    list(APPEND all_files ${files})
  endforeach()
  _elgen_remove_old_folders()

  add_custom_target(${arg_TARGET}_generate DEPENDS ${stamps})
  if(NOT TARGET ${arg_TARGET})
    add_library(${arg_TARGET} INTERFACE)
  endif()
  add_dependencies(${arg_TARGET} ${arg_TARGET}_generate)
  target_include_directories(${arg_TARGET} INTERFACE "${directory}")
  if(all_files MATCHES "\\.hpp")
    target_compile_features(${arg_TARGET} INTERFACE cxx_std_17)
  endif()
  # Every compiler then gives the same bits.
  target_compile_options(${arg_TARGET} INTERFACE
    $<$<COMPILE_LANG_AND_ID:C,GNU,Clang,AppleClang>:-ffp-contract=off>
    $<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>:-ffp-contract=off>)
  if(DEFINED arg_CHECK_AGAINST)
    get_filename_component(folder "${arg_CHECK_AGAINST}" ABSOLUTE)
    add_test(NAME ${arg_TARGET}.generated COMMAND "${program}" generate -q --check -o "${folder}" ${inputs})
  endif()
endfunction()

macro(_elgen_check_arguments)
  set(usage "write elgen_generate(TARGET plant INPUTS cart_pole.toml [CHECK_AGAINST generated])")
  if(DEFINED arg_UNPARSED_ARGUMENTS)
    list(JOIN arg_UNPARSED_ARGUMENTS " " unknown)
    message(FATAL_ERROR "elgen_generate: unknown argument `${unknown}`; ${usage}")
  endif()
  foreach(keyword TARGET INPUTS)
    if(NOT DEFINED arg_${keyword})
      message(FATAL_ERROR "elgen_generate: ${keyword} is missing; ${usage}")
    endif()
  endforeach()
  if(TARGET ${arg_TARGET})
    get_target_property(type ${arg_TARGET} TYPE)
    if(NOT type STREQUAL "INTERFACE_LIBRARY" OR TARGET ${arg_TARGET}_generate)
      message(FATAL_ERROR "elgen_generate: `${arg_TARGET}` is another target already")
    endif()
  endif()
endmacro()

# Sets `program`. A path instead of the imported target: an emulator, which commands of targets run in, would be of
# no use to the elgen of this machine.
macro(_elgen_find_program)
  if(ELGEN_EXECUTABLE)
    set(program "${ELGEN_EXECUTABLE}")
  else()
    get_target_property(program elgen::elgen LOCATION)
  endif()
  execute_process(COMMAND "${program}" --version RESULT_VARIABLE status OUTPUT_VARIABLE version ERROR_VARIABLE error)
  if(NOT status EQUAL 0 OR NOT version MATCHES "^elgen ")
    message(FATAL_ERROR "elgen_generate: ${program} does not run here (${status}); ELGEN_EXECUTABLE names another\n${error}")
  endif()
endmacro()

# Sets the `name`, `files` and `sources` of `input` by what elgen lists. Where the input has an error, what was listed
# before is used, and `has_error` set, for the build to tell it; the first time it is told here.
macro(_elgen_list)
  if(NOT EXISTS "${input}")
    message(FATAL_ERROR "elgen_generate: there is no ${input}")
  endif()
  set(list_outputs "${program}" generate -q -o "${directory}" --list-outputs "${input}")
  string(MD5 listing "${directory} ${input}")
  set(listing "ELGEN_LISTING_${listing}")
  set(has_error FALSE)
  execute_process(COMMAND ${list_outputs} --format json RESULT_VARIABLE status OUTPUT_VARIABLE json ERROR_QUIET)
  if(NOT status EQUAL 0)
    set(has_error TRUE)
    set(json "$CACHE{${listing}}")
    if(NOT json)
      execute_process(COMMAND ${list_outputs} OUTPUT_QUIET ERROR_VARIABLE errors)
      message("${errors}")
      message(FATAL_ERROR "elgen_generate: ${input} has the errors above")
    endif()
  endif()
  string(REPLACE "\n" "" json "${json}")
  set(${listing} "${json}" CACHE INTERNAL "the files and sources of ${input}")
  string(JSON name GET "${json}" systems 0 name)
  _elgen_get_paths(files path)
  _elgen_get_paths(sources)
endmacro()

# Sets the variable `member` to the list of that name, or of the members of its objects.
macro(_elgen_get_paths member)
  set(${member})
  string(JSON count ERROR_VARIABLE missing LENGTH "${json}" systems 0 ${member})
  if(missing)
    message(FATAL_ERROR "elgen_generate: ${program} is too old: it does not list ${member}")
  endif()
  math(EXPR last "${count} - 1")
  foreach(i RANGE ${last})
    string(JSON path GET "${json}" systems 0 ${member} ${i} ${ARGN})
    list(APPEND ${member} "${path}")
  endforeach()
endmacro()

# The stamp is touched whatever was written, so that Make and Ninja know when elgen ran; the files keep their times
# where they stay as they were, and nothing is compiled. As byproducts they are known to Ninja, which then looks at
# them again before it compiles.
macro(_elgen_add_command)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${program}" "${input}" ${sources})
  if(has_error)
    file(REMOVE "${stamp}")
    set(sources "${input}")
  endif()
  add_custom_command(
    OUTPUT "${stamp}"
    BYPRODUCTS ${files}
    COMMAND "${program}" generate -q -o "${directory}" "${input}"
    COMMAND "${CMAKE_COMMAND}" -E touch "${stamp}"
    DEPENDS ${sources} "${program}"
    COMMENT "Generating ${name}"
    VERBATIM)
  file(GLOB old_files "${directory}/${name}/${name}*")
  list(REMOVE_ITEM old_files ${files})
  foreach(file IN LISTS old_files)
    file(REMOVE "${file}")
  endforeach()
endmacro()

# Callers of a name that is no more then fail to compile, instead of reading what was once written.
macro(_elgen_remove_old_folders)
  file(GLOB old_stamps "${directory}/*/elgen.stamp")
  list(REMOVE_ITEM old_stamps ${stamps})
  foreach(stamp IN LISTS old_stamps)
    get_filename_component(folder "${stamp}" DIRECTORY)
    file(REMOVE_RECURSE "${folder}")
  endforeach()
endmacro()
