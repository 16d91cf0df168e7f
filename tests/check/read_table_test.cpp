// The tables that are not repeated: [model], [define], [gravity], [energy].
#include <catch2/catch.hpp>
#include <utility>

#include "check_testing.hpp"

namespace elgen::test {
namespace {

std::string named(const std::string& name) {
  return "format = 1\n[model]\nname = \"" + name +
         "\"\n[[coordinate]]\nname = \"x\"\nunit = \"m\"\n"
         "[energy]\nT = \"0*dot(x)^2\"\n";
}

TEST_CASE("a model's name is lower case and free in C++") {
  CHECK(messages(named("arm_2")).empty());
  CHECK(messages(named("Arm")) ==
        "E205 3:9 `Arm` is not lower-case letters, digits and underscores\n");
  CHECK(messages(named("class")) == "E204 3:9 `class` is reserved: it is a keyword of C++\n");
}

TEST_CASE("the texts of the header are kept") {
  const Model model = checked(
                          "format = 1\n[model]\nname = \"a\"\ntitle = \"A\"\ndescription = \"B\"\n"
                          "reference = \"C\"\n[[coordinate]]\nname = \"x\"\nunit = \"m\"\n"
                          "[energy]\nT = \"0*dot(x)^2\"\n")
                          .model;
  CHECK(model.title == "A");
  CHECK(model.description == "B");
  CHECK(model.reference == "C");
}

TEST_CASE("definitions come in any order") {
  const std::string model = block("V = \"a*x\"\n[define]\na = \"b/2\"\nb = \"k*x\"\n");
  CHECK(dumped(model, "definition") == "definition a = b/2\ndefinition b = k*x\n");
  CHECK(messages(model).empty());
}

TEST_CASE("gravity is an acceleration of two or three components") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"[gravity]\nvector = [\"0\", \"-m\"]\n",
       "E403 13:17 `-m` is in kg, but gravity is in m/s^2\n"},
      {"[gravity]\nvector = [\"0\"]\n", "E104 13:10 1 component, but a vector has 2 or 3\n"},
      {"[gravity]\nvector = [\"0\", \"x\"]\n",
       "E319 13:17 `x` is a coordinate, and gravity takes none\n"},
      {"[[point]]\nname = \"p\"\nat = [\"x\", \"0\", \"0\"]\n[gravity]\nvector = [\"0\", \"0\"]\n",
       "E516 16:10 2 components, but other vectors of this model have 3\n"},
  };
  for (const auto& [entries, expected] : rows) {
    INFO(entries);
    CHECK(messages(block(entries)) == expected);
  }
}

TEST_CASE("energies are in joule, dissipation in watt, none takes an input") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"V = \"m*x\"\n", "E403 12:6 `m*x` is in kg*m, but V is in J\n"},
      {"D = \"k*x^2\"\n", "E403 12:6 `k*x^2` is in J, but D is in W\n"},
      {"V = \"u*x\"\n[[input]]\nname = \"u\"\nunit = \"N\"\n",
       "E319 12:6 `u` is an input, and V takes none\n"},
      {"V = \"abs(k*x^2)\"\n",
       "E315 12:6 `abs(k*x^2)` is a function with a kink, and V takes none | a smooth stand-in is "
       "tanh(x/width)\n"},
      {"V = \"e*x\"\n[define]\ne = \"u\"\n[[input]]\nname = \"u\"\nunit = \"N\"\n",
       "E319 12:6 `e` contains an input, and V takes none\n"},
  };
  for (const auto& [entries, expected] : rows) {
    INFO(entries);
    CHECK(messages(block(entries)) == expected);
  }
}

}  // namespace
}  // namespace elgen::test
