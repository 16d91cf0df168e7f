// function_docs: the exact text of the comment above a function.
#include "emit/code/function_docs.hpp"

#include "emit/code/statements.hpp"
#include "fixture.hpp"

using namespace elgen;
using namespace elgen::test;
using Lines = std::vector<std::string>;

namespace {

Lines docs(const Subject& subject, std::size_t index) {
  const Function& function = subject.program.functions[index];
  const FunctionEquations printed =
      function_equations(subject.program, function, temporary_names(subject.program, function));
  return function_docs({subject.model, subject.program, function, printed, "a.equations.json", {}});
}

}  // namespace

TEST_CASE("sentence, equation and matrix") {
  CHECK(docs(cart_pole(), 0) ==
        Lines{" Mass matrix, symmetric. 2 x 2, row-major [kg, kg*m; kg*m, kg*m^2].", "",
              "     M = d^2 L/dv^2", "", "     [ M + m,          l*m*cos(theta) ]",
              "     [ l*m*cos(theta), l^2*m          ]"});
}

TEST_CASE("a scalar") {
  const Lines lines = docs(cart_pole(), 2);
  CHECK(lines.front() == " Kinetic energy. Scalar [J].");
  CHECK(lines.back() == "     = 1/2*M*dot(x)^2");
}

TEST_CASE("fields have headings") {
  const Lines lines = docs(cart_pole(), 4);
  CHECK(std::count(lines.begin(), lines.end(), "     acceleration:") == 1);
  CHECK(std::count(lines.begin(), lines.end(), "     relative_pivots:") == 1);
}

TEST_CASE("dynamics refers to its outputs") {
  CHECK(docs(cart_pole(), 5) ==
        Lines{" All chosen outputs without the arguments a and u, computed at once."});
}

TEST_CASE("a user's output is documented by the user") {
  Subject subject = cart_pole();
  UserOutput output;
  output.name = "tip";
  output.doc = "position of the tip";
  subject.model.outputs.push_back(output);
  subject.program.functions[2].kind = OutputKind::user_value;
  CHECK(docs(subject, 2).front() == " Output `tip`: position of the tip. Scalar.");
}

TEST_CASE("rows that are no argument of the function are named") {
  Subject subject = cart_pole();
  Point bob;
  bob.name = "bob";
  bob.mass = 0;
  subject.model.points.push_back(bob);
  subject.program.functions[2].kind = OutputKind::regressor_parameters;
  CHECK(docs(subject, 2).front().ends_with(" Scalar [kg], of bob.m."));
}

TEST_CASE("a function that compares numbers documents it") {
  Subject subject = cart_pole();
  subject.program = read_program(
      "coordinates x theta\nfunction applied_force\n  0 = velocity x\n  1 = sign 0\n"
      "  result 2 1 = 1 1\n");
  const Lines lines = docs(subject, 0);
  CHECK(mentions(lines.at(0) + lines.at(1),
                 ". Needs an ordered Scalar, or a pack of ordered numbers."));
}

TEST_CASE("a step documents its method") {
  Subject subject = cart_pole();
  subject.program = read_program(
      "coordinates x\nstep\nfunction advance = step 1\n  0 = coordinate x\n  1 = step\n"
      "  result coordinates 1 1 = 0\n  result rates 1 1 = 1\n");
  CHECK(
      docs(subject, 0) ==
      Lines{
          " One step of length h at constant inputs: Verlet's method (kick, drift, kick), which is",
          " symplectic and of order 2.", "",
          "     v += h/2 a(q, t), q += h v, v += h/2 a(q, t + h)"});
}

TEST_CASE("a step of a model with constraints documents drift or projection") {
  Subject subject = cart_pole();
  const auto said = [&](const std::string& kind) {
    subject.program =
        read_program("coordinates x\nstep\nfunction step = step 0" + kind +
                     "\n  0 = coordinate x\n"
                     "  1 = step\n  result coordinates 1 1 = 0\n  result rates 1 1 = 1\n");
    std::string text;
    for (const std::string& line : docs(subject, 0)) text += line;
    return text;
  };
  CHECK_THAT(said(""), !Catch::Contains("constraints"));
  subject.model.constraints.emplace_back();
  CHECK_THAT(said(""), Catch::Contains("it drifts off the constraints: call `projected`"));
  CHECK_THAT(said(" projected"), Catch::Contains("back to the constraints follows") &&
                                     Catch::Contains("then, at t + h, q - M^-1 A^T"));
  CHECK_THAT(said(" projected"), !Catch::Contains("drifts"));
}

TEST_CASE("a composed step documents its order and its substeps") {
  Subject subject = cart_pole();
  subject.program = read_program(
      "coordinates x\nstep\nfunction step = step 1 order 4\n  0 = coordinate x\n  1 = step\n"
      "  result coordinates 1 1 = 0\n  result rates 1 1 = 1\n");
  const Lines lines = docs(subject, 0);
  CHECK_THAT(lines[0] + lines[1],
             Catch::Contains("drift, kick), which is symplectic and of order 4."));
  CHECK(lines.back() ==
        "     in sequence over 0.414491 h, 0.414491 h, -0.657963 h, 0.414491 h, 0.414491 h");
}

TEST_CASE("an iterating step documents the number of iterations and its residual") {
  Subject subject = cart_pole();
  subject.program = read_program(
      "coordinates x\nstep\nfunction step = step 2 5\n  0 = coordinate x\n  1 = step\n"
      "  result coordinates 1 1 = 0\n  result rates 1 1 = 1\n  result residual 1 1 = 1\n");
  const Lines lines = docs(subject, 0);
  REQUIRE(lines.size() > 4);
  CHECK_THAT(lines[1] + lines[2], Catch::Contains("`residual` is the error of the momentum"));
  CHECK_THAT(lines.end()[-2],
             Catch::StartsWith("     5 times: M w = p + h/2 (dL/dq + F) - b, all at ("));
  CHECK(field_summary({subject.model, subject.program, subject.program.functions[0], {}, "", {}},
                      subject.program.functions[0].fields[2]) == "Scalar [kg*m/s]");
}

TEST_CASE("long rows become indexed lines, long lists refer to the sidecar") {
  Subject subject = cart_pole();
  FunctionEquations printed;
  const std::string wide = "some_long_name*another_long_name + a_third_long_name";
  printed.entries = {Formulas(4, name_formula(wide))};
  const Function& mass_matrix = subject.program.functions[0];
  const auto lines = [&] {
    return function_docs({subject.model, subject.program, mass_matrix, printed, "a.json", {}});
  };
  CHECK(lines().back() == "     [1, 1] = " + wide);
  for (int i = 0; i < 100; ++i) {
    printed.definitions.push_back({name_formula("x" + std::to_string(i)), number_formula(1)});
  }
  CHECK(lines().back() == "     100 definitions and 4 entries: see a.json.");
}

TEST_CASE("summary of a field") {
  const Subject subject = cart_pole();
  const Function& function = subject.program.functions[4];
  const FunctionEquations printed;
  CHECK(field_summary({subject.model, subject.program, function, printed, "", {}},
                      function.fields[0]) == "2 entries [m/s^2, 1/s^2]");
}

TEST_CASE("units of rows are separated by semicolons, and equal units are written once") {
  const Model model = cart_pole_model();
  CHECK(units_text(model, OutputKind::mass_matrix, {"", 2, 2, {}}) == "kg, kg*m; kg*m, kg*m^2");
  CHECK(units_text(model, OutputKind::forward_dynamics, {"relative_pivots", 2, 1, {}}) == "1");
  CHECK(units_text(model, OutputKind::gravity, {"", 2, 1, {}}) == "N, N*m");
  CHECK(units_text(model, OutputKind::kinetic_energy, {"", 1, 1, {}}) == "J");
}

TEST_CASE("an unknown unit suppresses the list of units") {
  Model model = cart_pole_model();
  model.velocities[1].unit.reset();
  CHECK(units_text(model, OutputKind::mass_matrix, {"", 2, 2, {}}) == "");
}
