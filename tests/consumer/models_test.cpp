// Models in examples/ have the same equations and values as the models of the same name in models/.
#include <catch2/catch.hpp>
#include <filesystem>

#include "support/shell.hpp"

namespace elgen::test {

TEST_CASE("a model in examples has the equations and values of its namesake in models") {
  const std::filesystem::path source = ELGEN_SOURCE_DIR;
  std::size_t compared = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source / "examples")) {
    const auto namesake = source / "models" / entry.path().filename();
    if (entry.path().extension() != ".toml" || !std::filesystem::exists(namesake)) continue;
    ++compared;
    const Outcome outcome = shell(
        "elgen diff --allow extended '" + namesake.string() + "' '" + entry.path().string() + "'",
        source);
    INFO(outcome.output << outcome.errors);
    CHECK(outcome.status == 0);
    const bool is_equal = mentions(outcome.output, "the equations are the same");
    CHECK((is_equal || mentions(outcome.output, "T, V, D, Q, B identical")));
    CHECK(!mentions(outcome.output, "the value of"));
  }
  CHECK(compared >= 2);
}

}  // namespace elgen::test
