// elgen_generate() in a CMake project. For each edit the table lists the inputs for which elgen ran
// and the compiled sources; the next build does nothing.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <catch2/catch.hpp>
#include <iostream>
#include <regex>
#include <set>
#include <vector>

#include "consumer/projects.hpp"
#include "pages/page.hpp"

namespace elgen::test {

namespace {

/// The distinct matches of `pattern` in `log`, sorted, with blanks between; "-" if there are none.
std::string found(const std::string& log, const std::string& pattern) {
  const std::vector<std::string> matches = all_matches(log, std::regex(pattern));
  const std::set<std::string> names(matches.begin(), matches.end());
  return names.empty() ? "-" : fmt::format("{}", fmt::join(names, " "));
}

/// An edit of a project. `row`: "INPUTS | SOURCES" or "INPUTS | SOURCES | PLACE OF THE ERROR".
struct Edit {
  const char* title;
  const char* command;
  const char* row;
  bool is_rebuild_empty = true;  ///< the next build does nothing
};

/// A project with two callers; each uses the code of one input.
class Project : public Workspace {
 public:
  Project(const std::string& generator, const std::filesystem::path& prefix)
      : Workspace("a project ") {
    prepare("mkdir models && cp '" + models + "/cart_pole.toml' '" + models +
            "/double_pendulum.toml' models && sed 's|\\.\\./||' '" + models +
            "/scenes/balance.scene.toml' > models/balance.scene.toml");
    write("CMakeLists.txt",
          "cmake_minimum_required(VERSION 3.21)\nproject(callers CXX)\n"
          "find_package(elgen 0.1 CONFIG REQUIRED)\n"
          "elgen_generate(TARGET plant INPUTS models/balance.scene.toml "
          "models/double_pendulum.toml)\nadd_subdirectory(callers)\n");
    write("callers/CMakeLists.txt",
          "add_executable(cart cart.cpp)\nadd_executable(pendulum pendulum.cpp)\n"
          "target_link_libraries(cart PRIVATE plant)\n"
          "target_link_libraries(pendulum PRIVATE plant)\n");
    write("callers/cart.cpp",
          "#include \"cart_pole_balance/cart_pole_balance.hpp\"\n"
          "int main() { return cart_pole_balance::input_count == 1 ? 0 : 1; }\n");
    write("callers/pendulum.cpp",
          "#include \"double_pendulum/double_pendulum.hpp\"\n"
          "int main() { return double_pendulum::coordinate_count == 2 ? 0 : 1; }\n");
    prepare("cmake -S . -B build -G '" + generator + "' " + finding_elgen(prefix));
  }

  /// The row of the build after an edit. A successful build is repeated: the second build must do
  /// nothing or, if the edit dates a file in the future, only run CMake and elgen once.
  [[nodiscard]] std::string row(const Edit& edit) const {
    prepare(edit.command);
    const Outcome built = run("cmake --build build");
    if (built.status == 0) {
      const std::string again = run("cmake --build build").output;
      CHECK(found(again, "(Building|Linking)") == "-");
      const std::size_t runs = edit.is_rebuild_empty ? 0 : 1;
      CHECK(count(again, "] Generating ") == runs);
      CHECK(count(again, "-- Configuring done") == runs);
    }
    const std::string log = built.output + built.errors;
    std::string row = found(log, "\\] Generating (\\w+)") + " | " +
                      found(log, "Building CXX object .*/(\\w+\\.cpp)");
    const std::string place = "(models/[^\n]*error\\[E[0-9]+\\]|fatal error: [^\n:]*)";
    if (built.status != 0) row += " | " + found(log, place);
    return row;
  }
};

constexpr Edit edits[] = {
    {"the first build", "true", "cart_pole_balance double_pendulum | cart.cpp pendulum.cpp"},
    {"nothing", "true", "- | -"},
    {"a value in the scene's model", "sed -i 's/0.1, /0.3, /' models/cart_pole.toml",
     "cart_pole_balance | cart.cpp"},
    {"a value in the other model", "sed -i 's/9.81/9.8/' models/double_pendulum.toml",
     "double_pendulum | pendulum.cpp"},
    {"a comment and a blank", "printf '# comment\n \n' >> models/cart_pole.toml",
     "cart_pole_balance | -"},
    {"the scene renamed", "sed -i 's/^name .*/name = \"upright\"/' models/balance.scene.toml",
     "cart_pole_upright | cart.cpp | fatal error: cart_pole_balance/cart_pole_balance.hpp"},
    {"the scene named back", "sed -i 's/\"upright\"/\"balance\"/' models/balance.scene.toml",
     "cart_pole_balance | cart.cpp"},
    {"an error in the model", "sed -i 's/mass = \"m\"/mass = \"mq\"/' models/cart_pole.toml",
     "cart_pole_balance | - | models/cart_pole.toml:52:9: error[E201]"},
    {"the error mended", "sed -i 's/\"mq\"/\"m\"/' models/cart_pole.toml", "cart_pole_balance | -"},
    {"the model moved away", "mv models/cart_pole.toml .",
     "cart_pole_balance | - | models/balance.scene.toml:4:11: error[E111]"},
    {"the model moved back", "mv cart_pole.toml models", "cart_pole_balance | -"},
    {"renamed, with an error", "sed -i 's/^name .*/name = \"a b\"/' models/balance.scene.toml",
     "cart_pole_balance | - | models/balance.scene.toml:5:9: error[E205]"},
    {"the error mended", "sed -i 's/\"a b\"/\"ab\"/' models/balance.scene.toml",
     "cart_pole_ab | cart.cpp | fatal error: cart_pole_balance/cart_pole_balance.hpp"},
    {"the scene named back", "sed -i 's/\"ab\"/\"balance\"/' models/balance.scene.toml",
     "cart_pole_balance | cart.cpp"},
    {"a header for batches", "printf '[emit]\nbatch = true\n' >> models/balance.scene.toml",
     "cart_pole_balance | cart.cpp"},
    {"a caller of it", "sed -i 's/balance.hpp/balance_batch.hpp/' callers/cart.cpp",
     "- | cart.cpp"},
    {"no header for batches", "sed -i 's/batch = true/batch = false/' models/balance.scene.toml",
     "cart_pole_balance | cart.cpp | fatal error: cart_pole_balance/cart_pole_balance_batch.hpp"},
    {"its caller mended", "sed -i 's/balance_batch.hpp/balance.hpp/' callers/cart.cpp",
     "- | cart.cpp"},
    {"a header deleted, CMake run",
     "rm build/CMakeFiles/elgen/plant/double_pendulum/double_pendulum.hpp && cmake build",
     "double_pendulum | pendulum.cpp"},
    {"a header deleted", "rm build/CMakeFiles/elgen/plant/cart_pole_balance/cart_pole_balance.hpp",
     "cart_pole_balance | cart.cpp"},
    {"a folder deleted", "rm -r build/CMakeFiles/elgen/plant/cart_pole_balance",
     "cart_pole_balance | cart.cpp"},
    {"all folders deleted", "rm -r build/CMakeFiles/elgen",
     "cart_pole_balance double_pendulum | cart.cpp pendulum.cpp"},
    // Ninja removes build.ninja if the interrupt arrives at the end of CMake; then CMake must run
    // again.
    {"an interrupt right after an edit",
     "sed -i 's/0.3, /0.4, /' models/cart_pole.toml; timeout -s INT 0.05 cmake --build build; "
     "[ -e build/build.ninja ] || [ -e build/Makefile ] || cmake build",
     "cart_pole_balance | cart.cpp"},
    {"an older model in its place",
     "sed 's/0.4, /0.5, /' models/cart_pole.toml > n && touch -d '3 days ago' n && "
     "mv n models/cart_pole.toml",
     "- | -"},
    {"the same, CMake run", "cmake build", "cart_pole_balance | cart.cpp"},
    {"a model of tomorrow", "touch -d '1 day' models/cart_pole.toml", "cart_pole_balance | -",
     false},
    {"a value in it",
     "sed -i 's/0.5, /0.6, /' models/cart_pole.toml && touch -d '1 day' "
     "models/cart_pole.toml",
     "cart_pole_balance | cart.cpp", false},
    {"a value, and a date of today", "sed -i 's/0.6, /0.7, /' models/cart_pole.toml",
     "cart_pole_balance | cart.cpp"},
    {"the next value", "sed -i 's/0.7, /0.8, /' models/cart_pole.toml",
     "cart_pole_balance | cart.cpp"},
    {"clean", "cmake --build build --target clean",
     "cart_pole_balance double_pendulum | cart.cpp pendulum.cpp"},
};

void check_builds(const std::string& generator, const std::filesystem::path& prefix) {
  const Project project(generator, prefix);
  std::cout << generator << ": edit | elgen ran for | compiled | failed\n";
  for (const Edit& edit : edits) {
    const std::string row = project.row(edit);
    std::cout << fmt::format("  {:<30} | {}\n", edit.title, row);
    INFO(edit.title);
    CHECK(row == edit.row);
  }
}

}  // namespace

TEST_CASE("after an edit only sources that include changed code are compiled", "[.all]") {
  const std::string generator = GENERATE("Ninja", "Ninja Multi-Config", "Unix Makefiles");
  check_builds(generator, installed());
}

TEST_CASE("every generator builds the examples", "[.all]") {
  const std::string generator = GENERATE("Ninja Multi-Config", "Unix Makefiles");
  const std::string program = generator == "Unix Makefiles" ? "build/" : "build/Debug/";
  for (const std::string name : {"balance", "track"}) {
    INFO(generator << ": " << name);
    CHECK(Example(name, "-G '" + generator + "'").run(program + name).status == 0);
  }
}

TEST_CASE("elgen from a package builds like an installed elgen", "[.all]") {
  const Workspace workspace("a package ");
  if (write_package(workspace).empty()) return;
  workspace.prepare("dpkg-deb -x elgen.deb root");
  for (const std::string file :
       {"bin/elgen", "share/man/man1/elgen.1", "share/bash-completion/completions/elgen",
        "share/zsh/vendor-completions/_elgen", "share/fish/vendor_completions.d/elgen.fish",
        "share/elgen/schemas/model.schema.json", "share/elgen/schemas/scene.schema.json",
        "share/doc/elgen/copyright", "share/doc/elgen/src/cli/README.md",
        "share/doc/elgen/models/cart_pole.toml", "share/elgen/examples/balance/main.cpp",
        "share/elgen/examples/gripper.urdf", "share/elgen/models/scenes/balance.scene.toml",
        "share/elgen/recipes/.pre-commit-hooks.yaml"}) {
    INFO(file);
    CHECK(workspace.run("test -s root/usr/" + file).status == 0);
  }
  const std::string control = workspace.run("dpkg-deb -f elgen.deb").output;
  CHECK(mentions(control, "libginac"));
  CHECK(mentions(control, " Built for "));
  check_builds("Ninja", workspace.path() / "root/usr");
}

}  // namespace elgen::test
