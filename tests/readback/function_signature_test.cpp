// Types and arguments of a definition are those of the function.
#include <catch2/catch.hpp>

#include "changes.hpp"

namespace elgen {

using test::c99;
using test::Change;
using test::cpp;
using test::eigen;
using test::expect_refused;

TEST_CASE("another signature is refused") {
  const std::string h = "wide.hpp";
  for (const Change& change : std::vector<Change>{
           {cpp(), h, "N SquareMatrix<Scalar> mass", "SquareMatrix", "Forces",
            "`Forces` instead of `SquareMatrix`"},
           {cpp(), h, "N SquareMatrix<Scalar> mass", "mass_matrix", "matrix", "instead of"},
           {cpp(), h, "> inverse_dynamics(", "Accelerations", "Velocities", "instead of"},
           {cpp(), h, "> inverse_dynamics(", " noexcept", "", "instead of `noexcept`"},
           {cpp(), h, "struct ForwardDynamics", "Accelerations<", "SquareMatrix<",
            "`SquareMatrix` instead of `Accelerations`"},
           {cpp(), h, "struct Dynamics", "Scalar kinetic_energy", "Forces<Scalar> kinetic_energy",
            "`Forces` instead of `Scalar`"},
           {eigen(), "_eigen.hpp", "struct ForwardDynamics", "Vector<Scalar, 2>",
            "Vector<Scalar, 3>", "`3` instead of `2`"},
           {c99(), "wide_scene.h", "void wide_scene_gravity", "result[2]", "result[1]",
            "`1` instead of `2`"},
           {c99(), "wide_scene.h", "_forward_dynamics_result {", "acceleration[2]",
            "acceleration[3]", "`3` instead of `2`"}}) {
    expect_refused(change);
  }
}

}  // namespace elgen
