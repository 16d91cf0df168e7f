# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the pages into share/doc/elgen, in the layout of the project. Symbolic links stand for the models, examples
# and recipes, which are installed in share/elgen, so that relative links of the pages lead somewhere. A link to a file
# that only a clone has becomes text.
#
# `source`: the folder of the project; `staged`: a folder of the build; `destination`: the folder `share`.
set(pages README.md CHANGELOG.md LICENSE REUSE.toml packaging/copyright models/README.md models/REFERENCE.md
          templates/README.md templates/LICENSE src/README.md src/cli/README.md examples/README.md recipes/README.md
          recipes/sweeps/README.md)
set(only_in_clone "\\[[^]]*\\]\\((\\.\\./)*((tests|generated|src/parse)/[^)#]*)[^)]*\\)")

file(REMOVE_RECURSE "${staged}")
foreach(page IN LISTS pages)
  file(READ "${source}/${page}" text)
  string(REGEX REPLACE "${only_in_clone}" "\\2 (in a clone)" text "${text}")
  file(WRITE "${staged}/elgen/${page}" "${text}")
endforeach()

file(GLOB_RECURSE files RELATIVE "${source}" "${source}/examples/*" "${source}/models/*" "${source}/recipes/*")
list(FILTER files EXCLUDE REGEX "\\.md$|/build/")
foreach(file IN LISTS files)
  get_filename_component(folder "${file}" DIRECTORY)
  file(RELATIVE_PATH target "/doc/elgen/${folder}" "/elgen/${file}")
  file(MAKE_DIRECTORY "${staged}/elgen/${folder}")
  file(CREATE_LINK "${target}" "${staged}/elgen/${file}" SYMBOLIC)
endforeach()

file(INSTALL "${staged}/elgen" DESTINATION "${destination}/doc" TYPE DIRECTORY)
