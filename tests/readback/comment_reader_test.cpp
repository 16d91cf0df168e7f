// The equations above functions are compared, row by row.
#include <catch2/catch.hpp>

#include "changes.hpp"

namespace elgen {

using test::c99;
using test::Change;
using test::cpp;
using test::expect_refused;

TEST_CASE("another comment is refused") {
  const std::string h = "wide.hpp";
  const std::string row = "///     [ m*l*cos(theta), m*l^2          ]\n";
  for (const Change& change : std::vector<Change>{
           {cpp(), h, "symmetric.", row, "", "entry 2 is missing"},
           {cpp(), h, "symmetric.", row, row + row, "one entry too many"},
           {cpp(), h, "symmetric.", row, "///     [ m*l*cos(theta) ]\n", "another length"},
           {cpp(), h, "symmetric.", row, "///     nothing\n", "no equation"},
           {cpp(), h, "Potential energy at", "= m*l*g", "= m*g", "`potential_energy`"},
           {cpp(), h, "Jacobian of", "[0, 0] =", "[0] =", "[0] instead of [0, 0]"},
           {cpp(), h, "Acceleration, and", "///     acceleration:\n", "", "one entry too many"},
           {c99(), "wide_scene.h", "Generalized momentum.", "dot(x) ]", "dot(theta) ]",
            "`momentum`"}}) {
    expect_refused(change);
  }
}

}  // namespace elgen
