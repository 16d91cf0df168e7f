// A header that says something else than what was derived is refused, whatever differs.
#include <catch2/catch.hpp>

#include "changes.hpp"

namespace elgen {

using test::c99;
using test::Change;
using test::cpp;
using test::eigen;
using test::expect_refused;
using test::Written;

TEST_CASE("what is written is read back") {
  for (const Written* all : {&cpp(), &eigen(), &c99()}) {
    std::vector<SourcePointer> sources;
    CHECK(format(test::read_changed(*all, "no file", "", sources)).empty());
  }
}

TEST_CASE("a C++ header that says something else is refused") {
  const std::string h = "wide.hpp";
  const std::string mass = "> mass_matrix(";
  const std::string force = "> applied_force(";
  const std::string sight = "> sight(";
  const std::string solved = "> forward_dynamics(";
  for (const Change& change : std::vector<Change>{
           // names
           {cpp(), h, mass, "p.m * p.l", "p.m * p.M",
            "`mass_matrix`: `t_679f3` has `M` instead of `l`"},
           {cpp(), h, mass, "t_679f3 * cos_theta", "t_679f3 * sin_theta", "not declared here"},
           {cpp(), h, mass, "cos_theta = cos(", "cos_theta = sin(", "`sin` is not declared"},
           {cpp(), h, mass, "using std::cos", "using std::sin", "`cos` is not declared"},
           {cpp(), h, sight, "sin_theta, cos_theta", "cos_theta, sin_theta", "instead of"},
           {cpp(), h, sight, "sin_theta, cos_theta", "sin_theta, sin_theta", "is declared twice"},
           {cpp(), h, sight, "sin_theta, cos_theta", "sin_theta", "`,`"},
           {cpp(), h, sight, "SineCosine<Scalar>::of(q[1])", "SineCosine<Scalar>::of(q[0])",
            "`sin_theta` has `q[0]` instead of `q[1]`"},
           {cpp(), h, sight, "SineCosine<Scalar>", "sign_of<Scalar>", "`SineCosine`"},
           {cpp(), h, "namespace detail", "{sin(angle), cos(angle)}", "{sin(angle), sin(angle)}",
            "`cos`"},
           {cpp(), h, force, "larger", "smaller", "has `min(k[1], k[2])`"},
           {cpp(), h, force, "number_0p7", "number_1_3", "has `1/3` instead of `0.7`"},
           {cpp(), h, mass, "Coordinates<Scalar>& q", "Coordinates<Scalar>& v", "instead of `q`"},
           // brackets and signs
           {cpp(), h, sight, "(constant<Scalar>(2.0) + cos_theta)",
            "constant<Scalar>(2.0) + cos_theta", "instead of"},
           {cpp(), h, sight, "(constant<Scalar>(2.0)", "(constant<Scalar>(2.0)(", "instead of"},
           {cpp(), h, "> coriolis_matrix(", "-p.m", "p.m", "entry 1 of the result"},
           {cpp(), h, sight, "q[0] + p.l", "q[0] - p.l", "entry 0 of the result"},
           {cpp(), h, force, "-(number", "+(number", "an operand"},
           {cpp(), h, force, "* detail", "- detail", "has `"},
           // operands and their order
           {cpp(), h, sight, "q[0] / p.l", "p.l / q[0]", "is `l / q[0]` instead of `q[0] / l`"},
           {cpp(), h, "> bias(", "p.b * v[1] - t_9250f * p.g", "t_9250f * p.g - p.b * v[1]",
            "entry 1"},
           {cpp(), h, sight,
            "atan2(q[0] + p.l * sin_theta, p.l * (constant<Scalar>(2.0) + cos_theta))",
            "atan2(p.l * (constant<Scalar>(2.0) + cos_theta), q[0] + p.l * sin_theta)", "atan2("},
           {cpp(), h, mass, "q[1]", "q[0]", "`cos_theta` has `q[0]` instead of `q[1]`"},
           {cpp(), h, mass, "q[1]", "q[2]", "no index of 2 numbers"},
           {cpp(), h, force, "p.k[0]", "p.k[1]", "has `k[2]` instead of `k[1]`"},
           {cpp(), h, force, "p.k[0]", "p.k", "`[`"},
           // entries and statements
           {cpp(), h, mass, "p.M + p.m, t_bff8f", "t_bff8f, p.M + p.m", "entry 0 of the result"},
           {cpp(), h, "> coriolis_matrix(",
            "-p.m * p.l * sin_theta * v[1],\n      constant<Scalar>(0.0)",
            "constant<Scalar>(0.0),\n      -p.m * p.l * sin_theta * v[1]", "entry 1"},
           {cpp(), h, mass, "t_bff8f, t_bff8f, ", "t_bff8f, ", "entry 2"},
           {cpp(), h, mass, "p.m, t_bff8f", "p.m, p.m, t_bff8f", "entry 1"},
           {cpp(), h, mass, "t_bff8f, t_679f3 * p.l", "t_bff8f, t_679f3 * p.l, p.l",
            "instead of `}`"},
           {cpp(), h, mass, "  const Scalar cos_theta = cos(q[1]);\n", "",
            "instead of `cos(q[1])`"},
           {cpp(), h, mass, "  const Scalar cos_theta = cos(q[1]);\n",
            "  const Scalar cos_theta = cos(q[1]);\n  const Scalar cos_theta = cos(q[0]);\n",
            "`cos_theta` is `cos(q[0])`"},
           {cpp(), h, solved, "{{acceleration_x, acceleration_theta}}",
            "{{acceleration_theta, acceleration_x}}", "entry 0 of `acceleration`"},
           {cpp(), h, "struct ForwardDynamics", "acceleration", "relative_pivots",
            "instead of `acceleration`"},
           // literals: of float, double, long double, and of every other type
           {cpp(), h, "number_0p7()", "0.7F", "0.8F", "`0.8F` is not 0.7"},
           {cpp(), h, "number_0p7()", " 0.7,", " 0.70000000000001,", "is not 0.7"},
           {cpp(), h, "number_0p7()", "0.7L", "0.7000000000000000001L", "is not 0.7"},
           {cpp(), h, "number_0p7()", "0.7L", "0.7", "is not 0.7"},
           {cpp(), h, "number_1_3()", "3333333L", "3333334L", "is not 1/3"},
           {cpp(), h, "number_1_3()", "{3}", "{4}", "is not 1/3"},
           {cpp(), h, "number_pi_sqrt_2()", "560696", "560697", "is not 4.4428"},
           {cpp(), h, sight, "constant<Scalar>(2.0)", "constant<Scalar>(4.0)",
            "has `4` instead of `2`"},
           {cpp(), h, sight, "constant<Scalar>(2.0)", "constant<Scalar>(2.1)", "a float holds"},
           // defaults and declarations
           {cpp(), h, "struct Parameters", "1.1F", "1.2F", "`1.2F` is not 1.1"},
           {cpp(), h, "struct Parameters", "{981}", "{982}", "is not 9.81"},
           {cpp(), h, "struct Parameters", "constant<Scalar>(2.0)", "constant<Scalar>(3.0)",
            "is not 2"},
           {cpp(), h, "struct Parameters", "Scalar m", "Scalar n", "`n` instead of `m`"},
           {cpp(), h, "coordinate_ranges", "-2.0", "-2.5", "is not -2"},
           {cpp(), h, "coordinate_names", "theta", "thera", "instead of"},
           {cpp(), h, "coordinate_count", "2", "3", "`3` instead of `2`"},
           {cpp(), h, "larger(", "x < y", "x > y", "instead of `<`"},
           {cpp(), h, "power_of_ten(int", "% 2 == 1", "% 2 == 0", "`0` instead of `1`"},
           {cpp(), h, "is_regular(", "return false", "return true", "instead of `false`"},
           // equations to read
           {cpp(), h, "symmetric.", "m*l^2 ", "m*l^3 ", "`mass_matrix`: `m*l^3`"},
           {cpp(), h, "potential energy. 2", "-m*l*g", "m*l*g", "`gravity`"},
           {cpp(), h, "Kinetic energy.", "1/2*", "1/3*", "`kinetic_energy`"},
           {cpp(), h, "Acceleration, and", "cos(theta)", "sin(theta)", "`forward_dynamics`"},
           {cpp(), h, "Acceleration, and", "relative_pivots:", "pivots:", "another field"},
           {cpp(), h, "Jacobian of", "[1, 0] = 1/l", "[0, 1] = 1/l", "[0, 1] instead of [1, 0]"},
           {cpp(), h, "Jacobian of", "///     [1, 1] = 0\n", "", "entry 3 is missing"},
           {cpp(), h, "Mass matrix", "row-major", "column-major", "the shape"},
           {cpp(), h, "//   function", "closed", "recursive", "the row should be"},
           {cpp(), h, "//   mass_matrix", "3", "4", "the row should be"}}) {
    expect_refused(change);
  }
}

TEST_CASE("a header of Eigen that says something else is refused") {
  const std::string h = "wide_scene_eigen.hpp";
  const std::string jacobian = "> sight_jacobian(";
  for (const Change& change : std::vector<Change>{
           {eigen(), h, jacobian, "result(1) =", "result(2) =", "entry 2 of the result"},
           {eigen(), h, jacobian, "result(3) =", "result(2) =", "entry 2 is written twice"},
           {eigen(), h, jacobian, "result(3) =", "result(4) =", "entry 4 of 4"},
           {eigen(), h, jacobian, "  result(3) = constant<Scalar>(0.0);\n", "",
            "entry 3 of the result is missing"},
           {eigen(), h, jacobian, "return result", "return q", "instead of `result`"},
           {eigen(), h, jacobian, "  return result;\n", "", "a return"},
           {eigen(), h, "Matrix<Scalar, 2, 2> mass_matrix", "2, 2", "2, 3", "`3` instead of `2`"},
           {eigen(), h, "> gravity(", "Argument<Scalar, 2>", "Argument<Scalar, 3>",
            "instead of `2`"},
           {eigen(), h, "> gravity(", "sin_theta", "cos_theta", "is not declared here"},
           {eigen(), h, "> forward_dynamics(", "result.acceleration(0)", "result.acceleration(1)",
            "entry 1 of `acceleration`"},
           {eigen(), h, "> forward_dynamics(", "result.relative_pivots(0)",
            "result.acceleration(0)", "entry 0 is written twice"},
           {eigen(), h, "Matrix =", "Eigen::ColMajor>", "Eigen::RowMajor>",
            "instead of `ColMajor`"},
           {eigen(), h, "kinetic_energy(", "constant<Scalar>(0.5)", "constant<Scalar>(0.25)",
            "has `0.25` instead of `0.5`"},
           {eigen(), h, "#include \"", "wide", "wild", "instead of"},
           {eigen(), "wide_scene.hpp", "> sight_jacobian(", "t_ee720, constant<Scalar>(1.0) / p.l,",
            "constant<Scalar>(1.0) / p.l, t_ee720,", "entry 0"}}) {
    expect_refused(change);
  }
}

TEST_CASE("a C header that says something else is refused") {
  const std::string h = "wide_scene.h";
  const std::string mass = "_mass_matrix(";
  const std::string force = "_applied_force(";
  for (const Change& change : std::vector<Change>{
           {c99(), h, mass, "p->l", "p->m", "has `m` instead of `l`"},
           {c99(), h, mass, "p->m", "p.m", "instead of `->`"},
           {c99(), h, mass, "cosf(", "cos(", "`cos` is not declared here"},
           {c99(), h, mass, "cosf(", "sinf(", "sin(q[1])"},
           {c99(), h, mass, "const float cos", "const double cos", "instead of `float`"},
           {c99(), h, mass, "result[1]", "result[2]", "entry 2 is written twice"},
           {c99(), h, mass, "float q[2]", "float q[3]", "`3` instead of `2`"},
           {c99(), h, force, "(void)q", "(void)x", "`x` is no argument"},
           {c99(), h, force, "0.7f", "0.7", "no literal of type float"},
           {c99(), h, force, "0.7f", "0.70001f", "instead of"},
           {c99(), h, force, "4.442883f", "4.442884f", "instead of"},
           {c99(), h, force, "fabsf", "fabs", "not declared"},
           {c99(), h, force, "sign_of(v[0])", "sign_of(v[1])", "has `v[1]` instead of `v[0]`"},
           {c99(), h, force, "sign_of(v[0])", "(v[0])", "is not declared here"},
           {c99(), h, "DEFAULT_PARAMETERS", "9.81f", "9.82f", "`9.82f` is not 9.81"},
           {c99(), h, "DEFAULT_PARAMETERS", "0.7f, 2.0f", "2.0f, 0.7f", "`2.0f` is not 0.7"},
           {c99(), h, "DEFAULT_PARAMETERS", "0.3f, /* b */ ", "/* b */ ", "is not 0.3"},
           {c99(), h, "_parameters {", "float k[2]", "float k[3]", "`3` instead of `2`"},
           {c99(), h, "_VELOCITY_COUNT", "2", "1", "`1` instead of `2`"},
           {c99(), h, "_smaller(", "y < x", "x < y", "instead of `y`"},
           {c99(), h, "_gravity(", "result[1] = -", "result[1] = ", "entry 1"},
           {c99(), h, "result->acceleration[0]", "acceleration", "relative_pivots",
            "relative_pivots"},
           {c99(), h, "Mass matrix", "cos(theta)", "sin(theta)", "`mass_matrix`"}}) {
    expect_refused(change);
  }
}

}  // namespace elgen
