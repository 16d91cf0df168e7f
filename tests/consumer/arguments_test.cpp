// elgen_generate() and find_package() with errors: CMake stops with a message.
#include <catch2/catch.hpp>

#include "consumer/projects.hpp"

namespace elgen::test {

namespace {

/// A project with one model; `lines` are the end of its CMakeLists.txt.
class ConfiguredProject : public Workspace {
 public:
  explicit ConfiguredProject(const std::string& lines,
                             const std::string& find = "find_package(elgen CONFIG REQUIRED)")
      : Workspace("a project ") {
    prepare("cp '" + models + "/cart_pole.toml' .");
    write("CMakeLists.txt", "cmake_minimum_required(VERSION 3.21)\nproject(wrong NONE)\n" + find +
                                "\n" + lines + "\n");
  }

  [[nodiscard]] Outcome configure(const std::string& options = finding_elgen()) const {
    return run("cmake -S . -B build -G Ninja " + options);
  }

  /// Writes an executable script in this folder.
  void write_program(const std::string& name, const std::string& script) const {
    write(name, "#!/bin/sh\n" + script + "\n");
    prepare("chmod +x " + name);
  }
};

/// The text on one line with single blanks, because CMake breaks lines.
std::string on_one_line(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const char next = c == '\n' ? ' ' : c;
    if (next != ' ' || line.empty() || line.back() != ' ') line += next;
  }
  return line;
}

struct WrongArguments {
  std::string lines;
  std::string message;
};

/// Paths and hashes of all files of the project and of the code for its target `ok`.
std::string hashes(const Workspace& project) {
  return project
      .run(
          "find . -type f '(' -path './build/CMakeFiles/elgen/ok/*' -o '!' -path './build/*' ')' "
          "-exec sha256sum '{}' + | LC_ALL=C sort -k 2")
      .output;
}

/// A project with generated code in its build folder, and committed code in its source folder.
class ProjectWithCode : public ConfiguredProject {
 public:
  explicit ProjectWithCode(const std::string& lines) : ConfiguredProject(lines) {
    prepare("mkdir src && cd src && elgen generate -q ../cart_pole.toml");
    write("src/main.cpp", "int main() {}\n");
    REQUIRE(configure().status == 0);
    prepare("cmake --build build --target ok_generate");
  }
};

}  // namespace

TEST_CASE("wrong arguments of elgen_generate are reported") {
  const WrongArguments mistakes[] = {
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
    const Outcome outcome = ConfiguredProject(lines).configure();
    CHECK(outcome.status != 0);
    INFO(outcome.errors);
    CHECK(mentions(on_one_line(outcome.errors), message));
  }
}

TEST_CASE("no name of a target touches a file of the project or of another target") {
  const ProjectWithCode project(
      "elgen_generate(TARGET ok INPUTS cart_pole.toml)\nadd_library(other ALIAS ok)\n"
      "if(DEFINED NAME)\n  elgen_generate(TARGET \"${NAME}\" INPUTS cart_pole.toml)\n"
      "  add_custom_target(every ALL)\n  add_dependencies(every \"${NAME}_generate\")\nendif()");
  const std::string before = hashes(project);
  REQUIRE(mentions(before, " ./CMakeLists.txt\n"));
  REQUIRE(mentions(before, " ./build/CMakeFiles/elgen/ok/cart_pole/cart_pole.hpp\n"));
  const auto configured = [&](const std::string& name) {
    return project.configure(finding_elgen() + " '-DNAME=" + name + "'");
  };
  for (const std::string name :
       {"../../..",     "../../../src", "..",      ".",       "...",   "../ok", "ok/..",
        "ok/cart_pole", "a/b",          "/tmp",    "a;b",     "ok;..", "a b",   " ",
        "x::y",         "ok:",          "$<1:ok>", "${NAME}", "~",     "*",     "o?",
        "[ok]",         "a\\b",         "a#b",     "a\"b",    "é"}) {
    const Outcome refused = configured(name);
    INFO(name << ": " << refused.errors);
    CHECK(refused.status != 0);
    CHECK(mentions(on_one_line(refused.errors), "is not a name for a target"));
    CHECK(hashes(project) == before);
  }
  for (const std::string name : {"", "ok", "ok_generate", "other", "all", "clean", "help"}) {
    INFO(name);
    CHECK(configured(name).status != 0);
    CHECK(hashes(project) == before);
  }
  for (const std::string name : {"ok.version", "ok.", ".ok", "-ok", "OK", "o+k", "elgen"}) {
    INFO(name);
    CHECK(configured(name).status == 0);
    CHECK(project.run("cmake --build build").status == 0);
    CHECK(mentions(project.files(), "/elgen/" + name + "/cart_pole/cart_pole.hpp\n"));
    CHECK(hashes(project) == before);
  }
}

TEST_CASE("only files that elgen wrote for a target are removed") {
  const ProjectWithCode project("elgen_generate(TARGET ok INPUTS cart_pole.toml)");
  const std::string folder = "build/CMakeFiles/elgen/ok/";
  project.prepare("cd " + folder +
                  " && printf 'mine' | tee mine.hpp cart_pole/mine.hpp cart_pole/a.stamp && " +
                  "mkdir old && mv cart_pole/cart_pole.md old && cp old/cart_pole.md "
                  "'cart_pole/CMakeLists.txt' " +
                  "&& touch 'cart_pole/x;..' 'cart_pole/x;CMakeLists.txt' && "
                  "printf '%0200d Code generated by elgen' 0 > cart_pole/late.hpp && "
                  "ln -s ../../../../src/generated/cart_pole linked && ln -s ../old/cart_pole.md "
                  "cart_pole/l.md");
  project.prepare("sed -i 's/^name *= \"cart_pole\"/name = \"pole\"/' cart_pole.toml");
  const std::string sources = project.run("sha256sum CMakeLists.txt src/*/*/*").output;
  REQUIRE(project.configure().status == 0);
  CHECK(project.run("cd " + folder + " && find . | LC_ALL=C sort").output ==
        ".\n./cart_pole\n./cart_pole/a.stamp\n./cart_pole/l.md\n./cart_pole/late.hpp\n"
        "./cart_pole/mine.hpp\n./cart_pole/x;..\n./cart_pole/x;CMakeLists.txt\n./linked\n"
        "./mine.hpp\n");
  CHECK(project.run("sha256sum CMakeLists.txt src/*/*/*").output == sources);
}

TEST_CASE("no code is written or removed through a symbolic link") {
  const ProjectWithCode project("elgen_generate(TARGET ok INPUTS cart_pole.toml)");
  for (const std::string link : {"elgen/ok/cart_pole", "elgen/ok", "elgen"}) {
    const std::string path = "build/CMakeFiles/" + link;
    project.prepare("mv " + path +
                    " kept && mkdir -p linked/ok/cart_pole && "
                    "cp src/generated/cart_pole/cart_pole.md linked/ok/cart_pole && "
                    "cp src/generated/cart_pole/cart_pole.md linked/ok && "
                    "cp src/generated/cart_pole/cart_pole.md linked && "
                    "ln -s \"$PWD/linked\" " +
                    path);
    const std::string before = hashes(project);
    const Outcome refused = project.configure();
    INFO(refused.errors);
    CHECK(refused.status != 0);
    CHECK(mentions(on_one_line(refused.errors), "/" + link + " is a symbolic link; remove it"));
    CHECK(hashes(project) == before);
    project.prepare("rm " + path + " && mv kept " + path);
  }
}

TEST_CASE("code is generated and updated below a folder with any character that CMake allows") {
  const ConfiguredProject project("elgen_generate(TARGET plant INPUTS cart_pole.toml)");
  for (const std::string folder : {"h#sh", "# 1", "a $b (c) 'd", "a$b, 100%", "[ok]*?"}) {
    INFO(folder);
    const std::string quoted = "\"$(cat name)\"";
    project.write("name", folder);
    project.prepare("mkdir " + quoted + " && cp CMakeLists.txt cart_pole.toml " + quoted);
    const auto built = [&](const std::string& edit) {
      return project.run("cd " + quoted + " && " + edit + " && cmake --build build --target " +
                         "plant_generate && cat build/CMakeFiles/elgen/plant/*/cart_pole.hpp");
    };
    REQUIRE(
        project.run("cmake -G Ninja -S " + quoted + " -B " + quoted + "/build " + finding_elgen())
            .status == 0);
    const Outcome first = built("true");
    CHECK(first.status == 0);
    CHECK_FALSE(mentions(first.output, "0.321"));
    CHECK(mentions(built("sed -i 's/= 0.1, /= 0.321, /' cart_pole.toml").output, "0.321"));
    CHECK(built("rm -r build/CMakeFiles/elgen").status == 0);
    const Outcome wrong = built("sed -i 's/mass = \"m\"/mass = \"mq\"/' cart_pole.toml");
    CHECK(wrong.status != 0);
    CHECK(mentions(wrong.output + wrong.errors, "error[E201]: unknown name `mq`"));
  }
}

TEST_CASE("at the first configuration CMake shows elgen's error in an input") {
  const ConfiguredProject project("elgen_generate(TARGET plant INPUTS cart_pole.toml)");
  project.prepare("sed -i 's/mass = \"m\"/mass = \"mq\"/' cart_pole.toml");
  const Outcome outcome = project.configure();
  CHECK(outcome.status != 0);
  CHECK(mentions(outcome.errors,
                 "/cart_pole.toml:52:9: error[E201]: unknown name `mq`\n   52 | mass = \"mq\"\n"));
  CHECK(mentions(on_one_line(outcome.errors),
                 "/cart_pole.toml has the errors above; mend them and run CMake again"));
}

TEST_CASE("an elgen that does not run or lists no sources is reported") {
  const ConfiguredProject project("elgen_generate(TARGET plant INPUTS cart_pole.toml)");
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
    return ConfiguredProject("", "find_package(elgen " + version + " CONFIG REQUIRED)").configure();
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

TEST_CASE("another elgen generates again, even if its file is older") {
  const ConfiguredProject project("elgen_generate(TARGET plant INPUTS cart_pole.toml)");
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

TEST_CASE("a package found in a folder is visible in its parent and sibling folders") {
  const ConfiguredProject project("elgen_generate(TARGET plant INPUTS cart_pole.toml)",
                                  "add_subdirectory(dependencies)");
  project.write("dependencies/CMakeLists.txt", "find_package(elgen CONFIG REQUIRED)\n");
  CHECK(project.configure().status == 0);
}

TEST_CASE("a library is installed with its plant") {
  const ConfiguredProject project(
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

TEST_CASE("CHECK_AGAINST is a test that fails if committed code is stale") {
  const ConfiguredProject project(
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

TEST_CASE("a cross-compiled project runs the elgen of the host", "[.all]") {
  const ConfiguredProject project(
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

  // CMake finds the package of the target machine in root/, but root/usr/bin/elgen does not run on
  // the host.
  project.prepare("mkdir -p root/usr/bin root/usr/share/cmake && cp -r '" + package +
                  "' root/usr/share/cmake && echo foreign > root/usr/bin/elgen");
  CHECK_FALSE(builds(""));
  CHECK(builds("\"-DELGEN_EXECUTABLE=$ELGEN\""));
}

}  // namespace elgen::test
