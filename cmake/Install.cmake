# SPDX-License-Identifier: GPL-3.0-or-later
# `cmake --install`: the program, its completions and manual, the schemas, the CMake package, the models, examples and
# recipes, and the pages. `cpack -G DEB`: the same as a Debian package.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS elgen)
set(share ${CMAKE_INSTALL_DATADIR})

# The installed program prints these files at install time; the lock keeps two installations from writing them at
# once. For packages Debian's zsh reads completions from another folder.
install(CODE "
  file(LOCK \"${CMAKE_CURRENT_BINARY_DIR}/pages.lock\" GUARD PROCESS)
  set(zsh site-functions)
  if(CMAKE_INSTALL_PREFIX STREQUAL \"/usr\")
    set(zsh vendor-completions)
  endif()
  foreach(page \"man/man1/elgen.1 man\" \"bash-completion/completions/elgen completions bash\"
          \"zsh/\${zsh}/_elgen completions zsh\" \"fish/vendor_completions.d/elgen.fish completions fish\"
          \"elgen/schemas/model.schema.json schema model\" \"elgen/schemas/scene.schema.json schema scene\")
    separate_arguments(words UNIX_COMMAND \"\${page}\")
    list(POP_FRONT words path)
    execute_process(COMMAND \"$<TARGET_FILE:elgen>\" \${words} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
    file(WRITE \"${CMAKE_CURRENT_BINARY_DIR}/pages/\${path}\" \"\${text}\")
    get_filename_component(folder \"\${path}\" DIRECTORY)
    file(INSTALL \"${CMAKE_CURRENT_BINARY_DIR}/pages/\${path}\"
         DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${share}/\${folder}\")
  endforeach()")

# Only scripts get a run bit, whatever the umask of the clone was.
install(DIRECTORY examples models recipes DESTINATION ${share}/elgen PATTERN build EXCLUDE PATTERN "*.md" EXCLUDE)
install(PROGRAMS recipes/gallery/gallery DESTINATION ${share}/elgen/recipes/gallery)
install(PROGRAMS recipes/sweeps/slurm.sh recipes/sweeps/sweep DESTINATION ${share}/elgen/recipes/sweeps)
install(FILES tests/urdf/robots/gripper.urdf DESTINATION ${share}/elgen/examples)
install(FILES .pre-commit-hooks.yaml DESTINATION ${share}/elgen/recipes)
install(FILES packaging/copyright DESTINATION ${share}/doc/elgen)

install(CODE "
  set(source \"${PROJECT_SOURCE_DIR}\")
  set(staged \"${CMAKE_CURRENT_BINARY_DIR}/pages/doc\")
  set(destination \"\${CMAKE_INSTALL_PREFIX}/${share}\")")
install(SCRIPT cmake/InstallPages.cmake)
# `elgen help` names the pages, if they are installed.
file(RELATIVE_PATH pages ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_DATADIR}/doc/elgen)
target_compile_definitions(elgen PRIVATE ELGEN_PAGES="${pages}")

# ARCH_INDEPENDENT: the package works on every architecture, so a 64-bit elgen serves a 32-bit project.
set(package ${share}/cmake/elgen)
configure_package_config_file(cmake/elgenConfig.cmake.in elgenConfig.cmake INSTALL_DESTINATION ${package}
                              PATH_VARS CMAKE_INSTALL_BINDIR NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(elgenConfigVersion.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/elgenConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/elgenConfigVersion.cmake
              cmake/ElgenGenerate.cmake
        DESTINATION ${package})

cmake_host_system_information(RESULT system QUERY DISTRIB_PRETTY_NAME)
set(CPACK_PACKAGE_CONTACT "the elgen authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "symbolic Euler-Lagrange equation generator")
set(CPACK_PACKAGE_DESCRIPTION "Derives the equations of motion of mechanical systems and writes them as C++ and C.
 Built for ${system}.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
# `verify`, `simulate` and `tradeoff` call a compiler; `diff --against` calls git.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "g++")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "cmake, git")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
include(CPack)
