// Closed forms in [[expect]], and the units of outputs.
#include <catch2/catch.hpp>

#include "check_testing.hpp"
#include "model/output_units.hpp"
#include "model/requests.hpp"

namespace elgen::test {

namespace {

const std::string sprung_masses = R"toml(format = 1
[model]
name = "masses"
[sizes]
n = 2
[[coordinate]]
for = "i in 1..n"
name = "x[i]"
unit = "m"
[parameters]
m = { size = "n", value = 1, unit = "kg" }
k = { value = 1, unit = "N/m" }
[energy]
T = "sum(i, 1, n, 1/2*m[i]*dot(x[i])^2)"
V = "1/2*k*x[1]^2"
[[expect]]
)toml";

Model sliding_pendulum() {
  return checked(R"toml(format = 1
[model]
name = "a"
[[coordinate]]
name = "x"
unit = "m"
[[coordinate]]
name = "q"
unit = "rad"
[[coordinate]]
name = "free"
[[input]]
name = "u"
unit = "V"
[parameters]
m = { value = 1, unit = "kg" }
J = { value = 1, unit = "kg*m^2" }
c = 1
[energy]
T = "m*dot(x)^2 + J*dot(q)^2 + c*dot(free)^2"
[[force]]
on = "x"
value = "u*c"
)toml")
      .model;
}

std::string unit(const Model& model, const char* output, std::uint32_t row, std::uint32_t column) {
  const auto request = find_request(model, output);
  REQUIRE(request);
  const std::string found = unit_text_of_entry(model, {request->kind, "", row, column});
  return found.empty() ? "not known" : found;
}

}  // namespace

TEST_CASE("closed forms are columns, matrices, or single entries by index") {
  CHECK(dump_lines(
            sprung_masses +
                "gravity = [\"k*x[1]\", \"0\"]\nmass_matrix = [[\"m[1]\", 0], [0, \"m[2]\"]]\n",
            "expect") ==
        "expect gravity 2 1 = [k*x[1], 0]\nexpect mass_matrix 2 2 = [m[1], 0, 0, m[2]]\n");
  CHECK(dump_lines(sprung_masses +
                       "mass_matrix_entry = { for = [\"i in 1..n\", \"j in 1..n\"], value = "
                       "\"delta(i, j)*m[i]\" }\nmomentum_entry = { for = \"i in 1..n\", value = "
                       "\"m[i]*dot(x[i])\" }\n",
                   "expect") ==
        "expect mass_matrix 2 2 = [1*m[1], 0*m[1], 0*m[2], 1*m[2]]\n"
        "expect momentum 2 1 = [m[1]*dot(x[1]), m[2]*dot(x[2])]\n");
  CHECK(dump_lines(sprung_masses +
                       "potential_energy = \"1/2*k*x[1]^2\"\nconserved = [\"dot(x[2])\", \"k\"]\n",
                   "expect") ==
        "expect potential_energy 1 1 = [1/2*k*x[1]^2]\nexpect conserved 2 1 = [dot(x[2]), k]\n");
}

TEST_CASE("an entry of a matrix has two indices, even if the matrix is 1 x 1") {
  const std::string chain = model_file("chain");
  for (const std::string size : {"n=1", "n=2"}) {
    INFO(size);
    CHECK(messages(chain, {.sizes = {size}}) == "");
  }
}

TEST_CASE("closed forms with a wrong shape or name") {
  const Rows rows{
      {"gravity = [\"k*x[1]\"]\n", "E517 17:11 1 x 1 entries, but `gravity` is 2 x 1\n"},
      {"mass_matrix = [\"m[1]\", \"m[2]\"]\n",
       "E517 17:15 no list of rows, but `mass_matrix` is 2 x 2 | a matrix is a list of rows: [[…], "
       "[…]]\n"},
      {"mass_matrix = [[\"m[1]\", 0], [0]]\n",
       "E517 17:15 rows of different lengths, but `mass_matrix` is 2 x 2 | a matrix is a list of "
       "rows: [[…], "
       "[…]]\n"},
      {"gravty = [\"0\", \"0\"]\n",
       "E601 17:1 unknown output `gravty` | did you mean `gravity`?\n"},
      {"linearization = [\"0\"]\n",
       "E517 17:17 no list of rows, but `linearization` is 4 x 4 | a matrix is a list of rows: "
       "[[…], "
       "[…]]\n"},
      {"gravity = { for = \"i in 1..n\", value = \"0\" }\n",
       "E601 17:1 `gravity` gives a formula for each entry, but its name lacks the suffix | did "
       "you mean `gravity_entry`?\n"},
      {"gravity_entry = { for = \"i in 1..n-1\", value = \"k*x[1]\" }\n",
       "E517 17:49 no entry 2, 1 of `gravity`\n"},
      {"gravity_entry = { for = \"i in 1..n+1\", value = \"k*x[1]\" }\n",
       "E517 17:49 entry 3, 1, but `gravity` is 2 x 1\n"},
      {"gravity_entry = { for = [\"i in 1..n\", \"j in 1..n\"], value = \"0\" }\n",
       "E517 17:25 2 indices, but an entry of `gravity` has 1\n"},
      {"gravity = [\"kk\", \"0\"]\n",
       "E201 17:13 unknown name `kk` | did you mean `k`? (parameter, line 12)\n"},
      {"gravity = [\"k\", \"0\"]\n", "E403 17:13 `k` is in kg/s^2, but a closed form is in N\n"},
      {"conserved = [\"p(k)\"]\n",
       "E212 17:17 `k` is no coordinate, so it has no momentum | `p(NAME)` is dL/d(dot(NAME)) of a "
       "coordinate, or of `NAME[k]` of a rotation\n"},
      {"conserved = [\"p(x)\"]\n", "E208 17:17 `x` needs an index: `x` has the elements 1 to 2\n"},
      {"conserved = [\"E - p(x[1])\"]\n",
       "E401 17:19 `p(x[1])` is in kg*m/s, but the sum is in J\n"},
      {"momentum = [\"p(x[1])\", \"0\"]\n",
       "E319 17:14 `p(x[1])` is a momentum, but a closed form takes none | it is allowed in "
       "`[[expect]]`: in `conserved`, and in outputs that take momenta\n"},
      {"input_matrix = [[\"1\"], [\"0\"]]\n",
       "E603 17:1 `input_matrix` needs inputs, but the model has none\n"},
  };
  check_rows(rows, [&](const std::string& expect) { return messages(sprung_masses + expect); });
}

TEST_CASE("an equation with another error is not reported as free of accelerations") {
  const std::string rotor =
      "format = 1\n[model]\nname = \"c1\"\n[[coordinate]]\nname = \"q\"\nunit = \"rad\"\n"
      "[[point]]\nname = \"P\"\nat = [\"NAME*cos(q)\", \"0\"]\n[parameters]\n"
      "I = { value = 2, unit = \"m\" }\nJ = { value = 1, unit = \"kg*m^2\" }\n[energy]\n"
      "T = \"1/2*J*dot(q)^2\"\n[[expect]]\nequations = [\"EQUATION\"]\n";
  const auto said = [&](const std::string& name, const std::string& equation) {
    return messages(replaced(replaced(rotor, "NAME", name), "EQUATION", equation));
  };
  const std::string reserved =
      "E204 11:1 `I` is reserved: it is a macro of C or C++ | `I_1` is free\n";
  const std::string none =
      "E540 16:15 `J*q = 0` contains no acceleration | the acceleration of `x` is `dot(dot(x))`\n";
  CHECK(said("I", "J*dot(dot(q)) = -I*sin(q)") == reserved);
  CHECK(said("I", "dot(dot(x(P))) = 0") == reserved);
  CHECK(said("I", "J*dot(dot(q)) = -nothing*sin(q)") ==
        reserved + "E201 16:32 unknown name `nothing`\n");
  CHECK(said("I", "J*q = 0") == reserved + none);
}

TEST_CASE("fewer equations than accelerations are allowed, and may contain multipliers") {
  const std::string masses =
      "format = 1\n[model]\nname = \"c2\"\n[[coordinate]]\nname = \"x\"\nunit = \"m\"\n"
      "[[coordinate]]\nname = \"y\"\nunit = \"m\"\n[[point]]\nname = \"P\"\n"
      "at = [\"x\", \"y\"]\nmass = 1\n";
  const std::string wall = "[[constraint]]\nname = \"wall\"\nequation = \"x = 0\"\n";
  const auto said = [&](const std::string& more, const std::string& equation) {
    return messages(masses + more + "[[expect]]\nequations = [\"" + equation + "\"]\n");
  };
  const std::string loop = "[[constraint]]\nname = \"loop\"\ncoincide = [\"P\", \"Nobody\"]\n";
  CHECK(said(loop, "dot(dot(x)) = 0") == "E201 16:19 unknown point `Nobody`\n");
  const std::string note =
      "E405 13:8 `1` contains no name, so it is in kg, the SI unit of its key\n";
  CHECK(said("", "dot(dot(x)) = 0") == note);
  CHECK(said(wall, "lambda(wall) = 0") == note);
  CHECK(said(wall, "2*lambda_wall = lambda(wall)") == note);
  CHECK(said(wall, "dot(dot(x)) = lambda_wal") == "E201 18:29 unknown name `lambda_wal`\n");
  CHECK(said("", "dot(dot(x)) = lambda_wall") == "E201 15:29 unknown name `lambda_wall`\n");
  CHECK(said(wall, "x = 0") ==
        "E540 18:15 `x = 0` contains no acceleration | the acceleration of `x` is "
        "`dot(dot(x))`\n");
}

TEST_CASE("the rate of an acceleration or a multiplier is refused") {
  const std::string rod =
      "format = 1\n[model]\nname = \"rod\"\n[[coordinate]]\nname = \"x\"\n"
      "[[coordinate]]\nname = \"y\"\n[[constraint]]\nname = \"rod\"\n"
      "equation = \"x^2 + y^2 = 1\"\n[energy]\nT = \"dot(x)^2 + dot(y)^2\"\n[[expect]]\n"
      "equations = [\"EQUATION\"]\n";
  const auto said = [&](const std::string& equation) {
    return messages(replaced(rod, "EQUATION", equation));
  };
  const std::string refused =
      " is the rate of an acceleration or a multiplier, which the equations of motion do not "
      "give\n";
  CHECK(said("dot(dot(dot(x))) = 0") == "E319 14:15 `dot(dot(dot(x)))`" + refused);
  CHECK(said("dot(dot(x)) = dot(lambda(rod)*x)") == "E319 14:29 `dot(lambda(rod)*x)`" + refused);
  CHECK(said("dot(x*dot(x)) = 2*lambda(rod)") ==
        "E520 5:9 `x`, `y`: no unit, so expressions with it are not checked\n");
}

TEST_CASE(
    "E and p(NAME) have their meaning only in conserved, unless the model declares the name") {
  const std::string p = "[define]\np = \"k*x[1]\"\n";
  const Model model =
      checked(sprung_masses + "conserved = [\"E\", \"p(x[2])\", \"p/k\"]\n" + p).model;
  const std::vector<ExpressionId>& entries = model.expectations.front().entries;
  CHECK(is_leaf(model.expressions[entries[0]], Opcode::energy));
  CHECK(is_leaf(model.expressions[entries[1]], Opcode::momentum));
  CHECK(model.expressions[entries[1]].index == 1);
  CHECK(to_string(model, entries[1]) == "p(x[2])");
  CHECK(to_string(model, entries[2]) == "p/k");
  const std::string unknown = messages(sprung_masses + "gravity = [\"E\", \"0\"]\n");
  CHECK(unknown.find("E201 17:13 unknown name `E`") == 0);
}

TEST_CASE("a name E of the model has priority, with one note") {
  const std::string own =
      sprung_masses +
      "conserved = [\"E\", \"2*E\", \"energy_function\"]\n[define]\nE = \"k*x[1]^2\"\n";
  CHECK(messages(own) ==
        "E213 17:15 `E` is the definition of the model here | `energy_function` is v dL/dv - L in "
        "every model\n");
  const Model model = checked(own).model;
  const std::vector<ExpressionId>& entries = model.expectations.front().entries;
  CHECK(refers_to_entry(model.expressions[entries[0]], NamedKind::definition));
  CHECK(is_leaf(model.expressions[entries[2]], Opcode::energy));
}

TEST_CASE("large closed forms are kept only for verification") {
  const std::string model = sprung_masses +
                            "mass_matrix_entry = { for = [\"i in 1..n\", \"j in 1..n\"], value = "
                            "\"delta(i, j)*m[i]\" }\ngravity_entry = { for = \"i in 1..n\", value "
                            "= \"delta(i, 1)*k*x[i]\" }\n";
  CheckOptions wanted;
  wanted.sizes = {"n=64"};
  CHECK(dump_lines(model, "expect mass", wanted).empty());
  CHECK(checked(model, wanted).model.expectations.size() == 1);
  wanted.purpose = purpose::verify;
  const Model large = checked(model, wanted).model;
  REQUIRE(large.expectations.size() == 2);
  CHECK(large.expectations[0].entries.size() == 64 * 64);
  CHECK(to_string(large, large.expectations[0].entries.back()) == "1*m[64]");
}

TEST_CASE("errors in large closed forms are always found") {
  CHECK(messages(sprung_masses +
                     "mass_matrix_entry = { for = [\"i in 1..n\", \"j in 1..n\"], value = "
                     "\"delta(i, j)*mm[i]\" }\n",
                 {.sizes = {"n=1000"}}) ==
        "E201 17:78 unknown name `mm` | did you mean `m`? (parameter, line 11)\n");
}

TEST_CASE("units of outputs follow from the units of coordinates and inputs") {
  const Model model = sliding_pendulum();
  CHECK(unit(model, "mass_matrix", 0, 0) == "kg");
  CHECK(unit(model, "mass_matrix", 0, 1) == "kg*m");
  CHECK(unit(model, "mass_matrix", 1, 1) == "kg*m^2");
  CHECK(unit(model, "coriolis_matrix", 0, 0) == "kg/s");
  CHECK(unit(model, "bias", 0, 0) == "N");
  CHECK(unit(model, "bias", 1, 0) == "N*m");
  CHECK(unit(model, "momentum", 1, 0) == "kg*m^2/s");
  CHECK(unit(model, "momentum", 0, 0) == "kg*m/s");
  CHECK(unit(model, "kinetic_energy", 0, 0) == "J");
  CHECK(unit(model, "forward_dynamics", 0, 0) == "m/s^2");
  CHECK(unit(model, "input_matrix", 0, 0) == to_string(*find_unit("N") / *find_unit("V")));
}

TEST_CASE("relative pivots have no unit, and rates of angles are in rad/s") {
  const Model model = sliding_pendulum();
  const auto pivot = unit_of_entry(model, {OutputKind::forward_dynamics, "relative_pivots", 0, 0});
  REQUIRE(pivot);
  CHECK(to_string(*pivot) == "1");
  CHECK(velocity_unit_text(model, model.velocities[0]) == "m/s");
  CHECK(velocity_unit_text(model, model.velocities[1]) == "rad/s");
  CHECK(velocity_unit_text(model, model.velocities[2]).empty());
}

TEST_CASE("a missing unit makes the unit of the entry unknown") {
  const Model model = sliding_pendulum();
  CHECK(unit(model, "mass_matrix", 0, 2) == "not known");
  CHECK(unit(model, "bias", 2, 0) == "not known");
  CHECK(unit(model, "forward_dynamics", 2, 0) == "not known");
  CHECK(unit(model, "dynamics", 0, 0) == "not known");
}

}  // namespace elgen::test
