// A report as people read it.
#include <catch2/catch.hpp>

#include "diff/versions.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string report(const std::string& before, const std::string& after, bool lists_all = false) {
  return to_text({.systems = {compared(before, after)}}, lists_all);
}

}  // namespace

TEST_CASE("one sign is told in a dozen lines, its cause first") {
  CHECK(report(cart, edited(cart, "\"-g\"", "\"g\"")) ==
        "changed      model.toml:55:17  [gravity] vector[2]: -g -> g\n"
        "             V = m*l*g*cos(theta) -> -m*l*g*cos(theta);  T, D, Q, B identical\n"
        "             [[expect]] is not changed with it: 5 entries no longer hold (bias[2], "
        "conserved[2], gravity[2], inverse_dynamics[2], ...)\n"
        "warns        E512: gravity pulls along +y\n"
        "follows      14 of 74 entries differ, 0 rewritten\n"
        "for one      gravity[2] = -m*l*g*sin(theta) -> m*l*g*sin(theta), difference "
        "2*m*l*g*sin(theta)\n"
        "             at theta = 1.68: -0.488 -> 0.488 J, 2 of the largest\n"
        "interface    unchanged\n"
        "different    the equations differ\n");
}

TEST_CASE("what breaks silently stands first") {
  const std::string text =
      report(spring(), edited(edited(spring(), "k = 3\n", ""), "m = {", "k = 3\nm = {"));
  CHECK(starts_with(text,
                    "interface    breaks: members of Parameters are in another order: m, k -> "
                    "k, m; callers compile and mean something else\n"));
  CHECK(mentions(text, "\nbreaks       the code of callers breaks\n"));
}

TEST_CASE("nothing, and nothing but text, is one line") {
  CHECK(report(cart, cart) == "equal        the equations are the same\n");
  CHECK(report(cart, cart + "#\n") == "equal        the equations are the same\n");
}

TEST_CASE("every entry is listed where that is asked for") {
  const std::string text = report(spring("k*(1 - cos(x))"), spring("2*k*sin(x/2)^2 + m*x"), true);
  CHECK(mentions(text, "potential_energy = "));
  CHECK(mentions(text, "gravity = k*sin(x) -> m + k*sin(x), difference m\n"));
  const std::string equal = report(spring("k*(1 - cos(x))"), spring("2*k*sin(x/2)^2"), true);
  CHECK(mentions(equal, "potential_energy: equal, written differently (proved)\n"));
}

TEST_CASE("files that came or went are told, and count") {
  const DiffReport report{.added = {"a.toml"}};
  CHECK(impact_of(report) == Impact::extended);
  CHECK(starts_with(to_text(report, false), "added        a.toml\n"));
  CHECK(impact_of({.removed = {"a.toml"}}) == Impact::breaks);
}
