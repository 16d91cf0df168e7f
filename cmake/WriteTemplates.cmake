# SPDX-License-Identifier: GPL-3.0-or-later
# Writes OUTPUT, a C++ file with the templates in PATHS, relative to FOLDER, as raw strings.
set(text "// Written by cmake/WriteTemplates.cmake from templates/.\n#include \"elgen/templates.hpp\"\n\n")
string(APPEND text "namespace elgen {\n\nstd::string_view embedded_template(std::string_view path) {\n")
foreach(path IN LISTS PATHS)
  file(READ ${FOLDER}/${path} content)
  string(APPEND text "  if (path == \"${path}\") return R\"==elgen==(${content})==elgen==\";\n")
endforeach()
string(APPEND text "  return {};\n}\n\n}  // namespace elgen\n")
file(WRITE ${OUTPUT} "${text}")
