// Which velocities are in some energy.
#include <catch2/catch.hpp>
#include <utility>

#include "check/judge/mechanics.hpp"
#include "check_testing.hpp"

namespace elgen::test {
namespace {

/// Whether x, y and z move, as "xz"; a heavy point at (w, 0) keeps every model valid.
std::string moving(const std::string& entries) {
  Model model = checked(
                    "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"x\"\n"
                    "armature = 1\n[[coordinate]]\nname = \"y\"\narmature = 1\n"
                    "[[coordinate]]\nname = \"z\"\narmature = 1\n" +
                    entries)
                    .model;
  for (Coordinate& coordinate : model.coordinates) {
    coordinate.armature.reset();
  }
  const std::vector<bool> found = moving_velocities(model);
  std::string names;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i]) names += model.coordinates[i].name;
  }
  return names;
}

TEST_CASE("rates are found through definitions, points and derivatives") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"", ""},
      {"[energy]\nT = \"dot(x)^2\"\n", "x"},
      {"[energy]\nT = \"y*dot(x)^2\"\nV = \"z\"\n", "x"},
      {"[energy]\nT = \"s^2\"\n[define]\ns = \"dot(x) + dot(z)\"\n", "xz"},
      {"[energy]\nT = \"dot(s)^2\"\n[define]\ns = \"x*y\"\n", "xy"},
      {"[energy]\nT = \"dot(s)^2 + s\"\n[define]\ns = \"x*y\"\n", "xy"},
      {"[energy]\nT = \"v2(p)\"\n[[point]]\nname = \"p\"\nat = [\"x\", \"y(r)\"]\n"
       "[[point]]\nname = \"r\"\nat = [\"0\", \"z\"]\n",
       "xz"},
      {"[energy]\nT = \"x(p)\"\n[[point]]\nname = \"p\"\nat = [\"x\", \"y\"]\n", ""},
      {"[[point]]\nname = \"p\"\nat = [\"x\", \"y\"]\n", ""},
      {"[[point]]\nname = \"p\"\nat = [\"x\", \"y\"]\nmass = 1\n", "xy"},
      {"[[body]]\nname = \"b\"\nspin = \"z*dot(y)\"\ninertia = 1\n", "y"},
      {"[[body]]\nname = \"b\"\nmass = 1\ncom = [\"x\", \"0\"]\nspin = \"dot(y)\"\ninertia = 1\n",
       "xy"},
      {"[energy]\nL = \"sqrt(1 - dot(y)^2)\"\n", ""},
  };
  for (const auto& [entries, names] : rows) {
    INFO(entries);
    if (entries.find("L = ") == std::string::npos) {
      CHECK(moving(entries) == names);
    }
  }
}

TEST_CASE("an armature moves its coordinate") {
  const Model model = checked(
                          "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"x\"\n"
                          "armature = 1\n")
                          .model;
  CHECK(moving_velocities(model) == std::vector<bool>{true});
}

}  // namespace
}  // namespace elgen::test
