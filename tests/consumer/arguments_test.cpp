// SPDX-License-Identifier: GPL-3.0-or-later
// elgen_generate() and find_package() where something is wrong: CMake stops and says it.
#include <catch2/catch.hpp>

#include "consumer/projects.hpp"

namespace elgen::test {

namespace {

/// A project of one model whose CMakeLists.txt ends with the `lines`.
class Configured : public Workspace {
 public:
  explicit Configured(const std::string& lines,
                      const std::string& find = "find_package(elgen CONFIG REQUIRED)")
      : Workspace("a project ") {
    prepare("cp '" + models + "/cart_pole.toml' .");
    write("CMakeLists.txt", "cmake_minimum_required(VERSION 3.21)\nproject(wrong NONE)\n" + find +
                                "\n" + lines + "\n");
  }

  [[nodiscard]] Outcome configure(const std::string& options = finding_elgen()) const {
    return run("cmake -S . -B build -G Ninja " + options);
  }

  /// An executable file in this folder.
  void write_program(const std::string& name, const std::string& script) const {
    write(name, "#!/bin/sh\n" + script + "\n");
    prepare("chmod +x " + name);
  }
};

/// On one line, with one blank between words: CMake breaks lines as it likes.
std::string on_one_line(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const char next = c == '\n' ? ' ' : c;
    if (next != ' ' || line.empty() || line.back() != ' ') line += next;
  }
  return line;
}

struct Mistake {
  std::string lines;
  std::string message;
};

}  // namespace

TEST_CASE("wrong arguments of elgen_generate are told") {
  const Mistake mistakes[] = {
      {"elgen_generate(INPUTS cart_pole.toml)",
       "elgen_generate: TARGET is missing; write elgen_generate(TARGET plant INPUTS "
       "cart_pole.toml"},
      {"elgen_generate(TARGET plant)", "elgen_generate: INPUTS is missing; write"},
      {"elgen_generate(TARGET plant INPUTS)", "elgen_generate: INPUTS is missing; write"},
      {"elgen_generate(TARGET plant INPUTS cart_pole.toml CHECK_AGAINST)",
       "elgen_generate: the folder of CHECK_AGAINST is missing; write"},
      {"set(ELGEN_EXECUTABLE elgen)\nelgen_generate(TARGET plant INPUTS cart_pole.toml)",
       "elgen_generate: ELGEN_EXECUTABLE is not an absolute path: elgen"},
      {"elgen_generate(TARGET INPUTS cart_pole.toml)", "elgen_generate: TARGET is missing; write"},
      {"elgen_generate(plant SCENES a.toml TARGET plant INPUTS cart_pole.toml)",
       "elgen_generate: unknown argument `plant SCENES a.toml`; write"},
      {"elgen_generate(TARGET plant INPUTS pole.toml)", "elgen_generate: there is no /"},
      {"elgen_generate(TARGET plant INPUTS cart_pole.toml ./cart_pole.toml)",
       "elgen_generate: two INPUTS would both be written to `cart_pole`; one is /"},
      {"add_custom_target(plant)\nelgen_generate(TARGET plant INPUTS cart_pole.toml)",
       "elgen_generate: `plant` is another target already"},
      {"elgen_generate(TARGET plant INPUTS cart_pole.toml)\n"
       "elgen_generate(TARGET plant INPUTS cart_pole.toml)",
       "elgen_generate: `plant` is another target already"},
  };
  for (const auto& [lines, message] : mistakes) {
    INFO(lines);
    const Outcome outcome = Configured(lines).configure();
    CHECK(outcome.status != 0);
    INFO(outcome.errors);
    CHECK(mentions(on_one_line(outcome.errors), message));
  }
}

TEST_CASE("the first time CMake tells the error of an input as elgen does") {
  const Configured project("elgen_generate(TARGET plant INPUTS cart_pole.toml)");
  project.prepare("sed -i 's/mass = \"m\"/mass = \"mq\"/' cart_pole.toml");
  const Outcome outcome = project.configure();
  CHECK(outcome.status != 0);
  CHECK(mentions(outcome.errors,
                 "/cart_pole.toml:52:9: error[E201]: unknown name `mq`\n   52 | mass = \"mq\"\n"));
  CHECK(mentions(on_one_line(outcome.errors),
                 "/cart_pole.toml has the errors above; mend them and run CMake again"));
}

TEST_CASE("an elgen that does not run or lists no sources is told") {
  const Configured project("elgen_generate(TARGET plant INPUTS cart_pole.toml)");
  const auto told = [&](const std::string& program) {
    return on_one_line(
        project.configure(finding_elgen() + " -DELGEN_EXECUTABLE=" + program).errors);
  };
  CHECK(mentions(told("none"),
                 "/none does not run here (No such file or directory); "
                 "ELGEN_EXECUTABLE names another"));
  project.write_program("foreign", "echo 'wrong architecture' >&2\nexit 126");
  CHECK(mentions(told("foreign"),
                 "/foreign does not run here (126); ELGEN_EXECUTABLE names "
                 "another wrong architecture"));
  project.write_program("other", "echo other 1.0");
  CHECK(mentions(told("other"), "/other does not run here (0)"));
  project.write_program("old",
                        "case $1 in --version) echo elgen 0.0.1 ;; *) \"$ELGEN\" \"$@\" | "
                        "sed 's/\"sources\"/\"old\"/' ;; esac");
  CHECK(mentions(told("old"), "/old is too old: it does not list sources"));
}

TEST_CASE("find_package finds this version and no newer one") {
  const auto outcome = [](const std::string& version) {
    return Configured("", "find_package(elgen " + version + " CONFIG REQUIRED)").configure();
  };
  CHECK(outcome("0.1").status == 0);
  CHECK(outcome("0.1.0 EXACT").status == 0);
  for (const std::string newer : {"0.1.1", "0.2", "1.0"}) {
    const Outcome refused = outcome(newer);
    CHECK(refused.status != 0);
    CHECK(mentions(refused.errors, "requested version \"" + newer + "\""));
    CHECK(mentions(refused.errors, "elgenConfig.cmake, version: 0.1.0"));
  }
}

TEST_CASE("another elgen generates again, however old its file is") {
  const Configured project("elgen_generate(TARGET plant INPUTS cart_pole.toml)");
  const auto generates = [&](const std::string& version) {
    project.write_program("mine", "\"$ELGEN\" \"$@\" | sed s/0.1.0/" + version + "/");
    project.prepare("touch -d '3 days ago' mine");
    REQUIRE(project.configure(finding_elgen() + " -DELGEN_EXECUTABLE=mine").status == 0);
    return mentions(project.run("cmake --build build --target plant_generate").output,
                    "Generating cart_pole");
  };
  CHECK(generates("0.1.0"));
  CHECK_FALSE(generates("0.1.0"));
  CHECK(generates("0.1.1"));
  CHECK_FALSE(generates("0.1.1"));
}

TEST_CASE("a package found in a folder serves those above and beside it") {
  const Configured project("elgen_generate(TARGET plant INPUTS cart_pole.toml)",
                           "add_subdirectory(dependencies)");
  project.write("dependencies/CMakeLists.txt", "find_package(elgen CONFIG REQUIRED)\n");
  CHECK(project.configure().status == 0);
}

TEST_CASE("a library is installed with its plant") {
  const Configured project(
      "elgen_generate(TARGET plant INPUTS cart_pole.toml)\n"
      "add_library(controller STATIC controller.cpp)\n"
      "target_link_libraries(controller PUBLIC plant)\n"
      "install(TARGETS controller plant EXPORT controller INCLUDES DESTINATION include)\n"
      "install(DIRECTORY ${CMAKE_BINARY_DIR}/CMakeFiles/elgen/plant/ TYPE INCLUDE\n"
      "        FILES_MATCHING PATTERN *.hpp)\n"
      "install(EXPORT controller DESTINATION share/cmake/controller)");
  project.prepare("sed -i 's/ NONE/ CXX/' CMakeLists.txt");
  project.write("controller.cpp", "#include \"cart_pole/cart_pole.hpp\"\n");
  REQUIRE(project.configure().status == 0);
  CHECK(project.run("cmake --build build && cmake --install build --prefix p").status == 0);
  CHECK(project.run("ls p/include/cart_pole").output == "cart_pole.hpp\n");
  CHECK(mentions(project.read("p/share/cmake/controller/controller.cmake"), "cxx_std_17"));
}

TEST_CASE("CHECK_AGAINST is a test that fails where committed code is stale") {
  const Configured project(
      "enable_testing()\n"
      "elgen_generate(TARGET plant INPUTS cart_pole.toml CHECK_AGAINST generated)");
  project.prepare("elgen generate -q cart_pole.toml && sed -i 's/ NONE/ CXX/' CMakeLists.txt");
  REQUIRE(project.configure().status == 0);
  const std::string test = "ctest --test-dir build -R '^plant.generated$' --output-on-failure";
  CHECK(mentions(project.run(test).output, "1/1 Test #1: plant.generated"));
  CHECK(project.run(test).status == 0);
  project.prepare("sed -i 's/0.1, /0.2, /' cart_pole.toml");
  const Outcome stale = project.run(test);
  CHECK(stale.status != 0);
  CHECK(mentions(stale.output, "generated/cart_pole/cart_pole.hpp"));
}

TEST_CASE("a project compiled for another machine runs the elgen of this one", "[.all]") {
  const Configured project(
      "elgen_generate(TARGET plant INPUTS cart_pole.toml)\n"
      "add_executable(user user.cpp)\n"
      "target_link_libraries(user PRIVATE plant)");
  project.prepare("sed -i 's/ NONE/ CXX/' CMakeLists.txt && mkdir root");
  project.write("user.cpp", "#include \"cart_pole/cart_pole.hpp\"\nint main() {}\n");
  project.write("cross.cmake",
                "set(CMAKE_SYSTEM_NAME Linux)\nset(CMAKE_SYSTEM_PROCESSOR other)\n"
                "set(CMAKE_FIND_ROOT_PATH \"${CMAKE_CURRENT_LIST_DIR}/root\")\n"
                "set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)\n"
                "set(CMAKE_CROSSCOMPILING_EMULATOR /bin/false)\n");
  const std::string cross = "-DCMAKE_TOOLCHAIN_FILE=cross.cmake ";
  const std::string package = (installed() / "share/cmake/elgen").string();
  const auto builds = [&](const std::string& options) {
    project.prepare("rm -rf build");
    const Outcome configured = project.configure(cross + options);
    INFO(configured.errors);
    return configured.status == 0 && project.run("cmake --build build").status == 0;
  };
  CHECK_FALSE(builds(finding_elgen()));
  CHECK(builds("'-Delgen_DIR=" + package + "'"));

  // The package of the other machine is found in its root; its elgen does not run here.
  project.prepare("mkdir -p root/usr/bin root/usr/share/cmake && cp -r '" + package +
                  "' root/usr/share/cmake && echo foreign > root/usr/bin/elgen");
  CHECK_FALSE(builds(""));
  CHECK(builds("\"-DELGEN_EXECUTABLE=$ELGEN\""));
}

}  // namespace elgen::test
