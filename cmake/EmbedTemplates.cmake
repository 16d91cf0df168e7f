# SPDX-License-Identifier: GPL-3.0-or-later
# elgen_embed_templates(TARGET FOLDER): embeds every template below FOLDER in TARGET as a string. Access:
# `std::string_view elgen::embedded_template(std::string_view path)` (include/elgen/templates.hpp).
function(elgen_embed_templates target folder)
  file(GLOB_RECURSE paths CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/${folder}
       ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.mustache)
  set(absolute)
  foreach(path IN LISTS paths)
    list(APPEND absolute ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/${path})
  endforeach()
  set(output ${CMAKE_CURRENT_BINARY_DIR}/embedded_templates.cpp)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${CMAKE_CURRENT_SOURCE_DIR}/${folder} "-DPATHS=${paths}"
            -DOUTPUT=${output} -P ${CMAKE_CURRENT_SOURCE_DIR}/cmake/WriteTemplates.cmake
    DEPENDS ${absolute} ${CMAKE_CURRENT_SOURCE_DIR}/cmake/WriteTemplates.cmake
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()
