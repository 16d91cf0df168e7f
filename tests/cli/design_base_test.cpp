// What designs start from: which output, of a model or of its scene.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

/// A model, a scene of it, and a compiler that compiles nothing.
class Base {
 public:
  Base() {
    write_text(path() / "rotor.toml",
               "format = 1\n[model]\nname = \"rotor\"\n[[coordinate]]\nname = \"q\"\n"
               "unit = \"rad\"\n[parameters]\nJ = { value = 2, unit = \"kg*m^2\" }\n"
               "k = { value = 3, unit = \"J\" }\n"
               "[energy]\nT = \"1/2*J*dot(q)^2\"\nV = \"k*(1 - cos(q))\"\n");
    write_text(path() / "two.scene.toml",
               "format = 1\nmodel = \"rotor.toml\"\nname = \"two\"\n[outputs]\n"
               "potential_energy = true\ngravity = true\n");
    write_text(path() / "idle.sh", "test \"$1\" = --version\n");
  }

  [[nodiscard]] const std::filesystem::path& path() const { return workspace_.path(); }
  [[nodiscard]] Outcome measure(const std::string& words) const {
    return shell("CXX='sh idle.sh' elgen tradeoff --format json " + words, path());
  }
  [[nodiscard]] std::string subject(const std::string& words) const {
    const Outcome outcome = measure(words);
    INFO(outcome.errors);
    REQUIRE(outcome.status == 4);
    return nlohmann::json::parse(outcome.output).at("subject");
  }

 private:
  Workspace workspace_;
};

}  // namespace

TEST_CASE_METHOD(Base, "it is inverse_dynamics, the first output of a scene, or what is named") {
  CHECK(subject("rotor.toml") == "inverse_dynamics");
  CHECK(subject("two.scene.toml") == "gravity");
  CHECK(subject("--of potential_energy two.scene.toml") == "potential_energy");
}

TEST_CASE_METHOD(Base, "what is not one output is refused") {
  const Outcome outcome = measure("--of gravity,bias rotor.toml");
  CHECK(outcome.status == 2);
  CHECK(mentions(outcome.errors, "`gravity,bias` is not one output"));
}

}  // namespace elgen::test
