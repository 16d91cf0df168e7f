// Tests inputs that are wrenches on frames or forces on points: names, units, axes, locks, and
// refused inputs. The columns of a wrench in B are the transposed Jacobian of the twist.
#include <catch2/catch.hpp>

#include "pipeline/constrained_testing.hpp"
#include "sample/states.hpp"
#include "verify/structure/expectations.hpp"

namespace elgen::test {
namespace {

std::string armed(const std::string& more) { return model_file("panda7") + more; }

std::string output(const std::string& axes) {
  return "\n[[output]]\nname = \"hand\"\nframe = \"link7\"\njacobian = true\naxes = \"" + axes +
         "\"\n";
}

/// A planar leg of two links; `more` adds its inputs.
std::string leg(const std::string& more) {
  return R"toml(format = 1
[model]
name = "leg"
[[coordinate]]
name = "hip"
unit = "rad"
[[coordinate]]
name = "knee"
unit = "rad"
[parameters]
m = { value = 1, unit = "kg" }
l = { value = 0.3, unit = "m" }
[[frame]]
name = "thigh"
parent = "world"
rotate = [["z", "hip"]]
[[frame]]
name = "shank"
parent = "thigh"
translate = ["l", "0"]
rotate = [["z", "knee"]]
[[point]]
name = "toe"
frame = "shank"
at = ["l", "0"]
mass = "m"
[[point]]
name = "kneecap"
frame = "shank"
at = ["0", "0"]
mass = "m"
)toml" + more;
}

/// A frame, a wrench on it and its pose, for a model or a scene of the leg.
const std::string sole =
    "[[frame]]\nname = \"sole\"\nparent = \"shank\"\ntranslate = [\"l\", \"0\"]\n"
    "rotate = [[\"z\", \"pi/3\"]]\n[[input]]\nname = \"w\"\nwrench = \"sole\"\n"
    "in = \"sole\"\n[[output]]\nname = \"pose\"\nframe = \"sole\"\njacobian = true\n";

/// The report on the [[expect]] of the leg with a motor at the knee, in a scene with `sole`.
ExpectationReport judged(const std::string& expect) {
  const std::string motor = "[[input]]\nname = \"motor\"\nunit = \"N*m\"\non = \"knee\"\n";
  const Products products = derived(inputs_of(leg(motor + "[[expect]]\n" + expect), sole), "bias");
  const auto& [model, scene] = *products.checked;
  return check_expectations({model, scene, *products.program}, nullptr, 1);
}

std::vector<std::string> input_names_of(const Model& model) {
  std::vector<std::string> names;
  for (const Input& input : model.inputs) names.push_back(input.name);
  return names;
}

std::string messages(const std::string& model, const std::string& scene = "") {
  return format(run_pipeline(inputs_of(model, scene), {.goals = {Goal::inspect}}).diagnostics);
}

}  // namespace

TEST_CASE("the columns of a wrench are the transposed Jacobian of the twist") {
  for (const std::string axes : {"world", "link7"}) {
    INFO(axes);
    const Constrained system(armed("\n[[input]]\nname = \"f\"\nwrench = \"link7\"\nin = \"" + axes +
                                   "\"\n" + output(axes)),
                             "input_matrix,hand_jacobian");
    State state = system.nominal();
    Sampler draw(3);
    draw_motion(system.model(), draw, 0, state);
    const ExactNumbers b = system.exactly(OutputKind::input_matrix, "", state);
    const ExactNumbers jacobian = system.exactly(OutputKind::user_jacobian, "", state);
    ExactNumbers block;
    for (std::size_t row = 0; row < 6; ++row) {
      for (std::size_t i = 0; i < 7; ++i) block.push_back(b[i * 13 + 7 + row]);
    }
    check_digits(block, jacobian, 50);
    CHECK(system.model().inputs[7].name == "f_tx");
    CHECK(system.model().inputs[9].unit_text == "N*m");
    CHECK(system.model().inputs[10].unit_text == "N");
  }
}

TEST_CASE("in a plane a torque has one component and a force has two") {
  const Constrained system(leg("[[input]]\nname = \"w\"\nwrench = \"shank\"\n[[input]]\nname = "
                               "\"g\"\nat = \"toe\"\n"),
                           "input_matrix");
  CHECK(input_names_of(system.model()) ==
        std::vector<std::string>{"w_tz", "w_fx", "w_fy", "g_fx", "g_fy"});
  State state = system.nominal();
  state.q = {cln::cl_RA(3) / 10, cln::cl_RA(-7) / 5};
  const double l = 0.3;
  const double a = 0.3;
  const double b = 0.3 - 1.4;
  const std::vector<double> expected{1,
                                     -l * std::sin(a),
                                     l * std::cos(a),
                                     -l * (std::sin(a) + std::sin(b)),
                                     l * (std::cos(a) + std::cos(b)),
                                     1,
                                     0,
                                     0,
                                     -l * std::sin(b),
                                     l * std::cos(b)};
  const std::vector<double> found = system.double_field(OutputKind::input_matrix, "", state);
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    CHECK(found[i] == Approx(expected[i]).margin(1e-15));
}

TEST_CASE("components that act only on locked coordinates are removed, with a note") {
  const std::string model =
      leg("[[input]]\nname = \"w\"\nwrench = \"thigh\"\n[[input]]\nname = "
          "\"g\"\nat = \"toe\"\n");
  const std::string found_messages = messages(model, "[lock]\nhip = { value = 0.4 }\n");
  using Catch::Contains;
  CHECK_THAT(found_messages,
             Contains("E616") && Contains("`w_tz`, `w_fx`, `w_fy` act only on locked coordinates"));
  CHECK_THAT(found_messages, !Contains("`g_fx`"));
}

TEST_CASE("a wrench on a moving frame keeps all components") {
  const std::string model = leg("[[input]]\nname = \"w\"\nwrench = \"thigh\"\n");
  CHECK_FALSE(mentions(messages(model, "[lock]\nknee = { value = 0.4 }\n"), "E616"));
}

TEST_CASE("additions of a scene give the values that additions of the model give") {
  const std::string outputs = "input_matrix,bias,pose,pose_jacobian";
  const Constrained whole(leg(sole), outputs);
  const Constrained system(leg(""), outputs, sole);
  State state = system.nominal();
  Sampler draw(3);
  draw_motion(system.model(), draw, 0, state);
  for (const OutputKind kind : {OutputKind::input_matrix, OutputKind::bias, OutputKind::user_value,
                                OutputKind::user_jacobian}) {
    check_digits(system.exactly(kind, "", state), whole.exactly(kind, "", state), 50);
  }
}

TEST_CASE("the model's expectations are judged without the inputs of the scene") {
  const ExpectationReport right =
      judged("input_matrix = [[\"0\"], [\"1\"]]\nconserved = [\"E\"]\n");
  CHECK(right.diagnostics.empty());
  REQUIRE(right.rows.size() == 3);
  for (const CertificateRow& row : right.rows) CHECK(row.verdict == Verdict::holds);
  const ExpectationReport wrong = judged("input_matrix = [[\"1\"], [\"1\"]]\n");
  REQUIRE(wrong.diagnostics.size() == 1);
  CHECK(wrong.diagnostics[0].code == Code::E510);
}

TEST_CASE("files and options may number the components of a wrench") {
  const PipelineSources inputs =
      inputs_of(leg("[[input]]\nname = \"g\"\nat = \"toe\"\n"
                    "[[output]]\nname = \"load\"\nvalue = [\"g[2]\", \"g_fy\"]\n"
                    "[[equilibrium]]\nname = \"rest\"\nat = { hip = 0, knee = 0 }\n"
                    "inputs = { \"g[2]\" = 0 }\n"
                    "[[expect]]\nload = [1, 1]\nat = { \"g[2]\" = 1 }\n"),
                "[numeric]\nmax_error = 1e-9\nranges = { \"g[1]\" = [-1, 1] }\n");
  const Products products = products_with(
      &Products::checked, inputs,
      {.scene = {.laws = {make_source("command line", "g[1]=2")}}, .goals = {Goal::check}});
  const auto& [model, scene] = *products.checked;
  for (const ExpressionId value : model.outputs[0].values) CHECK(to_string(model, value) == "g_fy");
  CHECK_FALSE(model.equilibria[0].inputs[0].has_value());
  CHECK(model.equilibria[0].inputs[1].has_value());
  CHECK(model.expectations[0].state->leaves[0].number == 1);
  CHECK(scene.numerics.ranges[0].name == "g_fx");
  CHECK(scene.laws.count("g_fx") == 1);
}

TEST_CASE("invalid wrenches are refused") {
  using Catch::Contains;
  const auto input = [](const std::string& keys) {
    return messages(leg("[[input]]\nname = \"w\"\n" + keys));
  };
  CHECK_THAT(input("wrench = \"shnk\"\n"), Contains("E201") && Contains("did you mean `shank`?"));
  CHECK_THAT(input("at = \"heel\"\n"), Contains("unknown point `heel`"));
  CHECK_THAT(input("wrench = \"shank\"\non = \"knee\"\n"),
             Contains("E112") && Contains("one of `on`, `wrench` and `at`"));
  CHECK_THAT(input("wrench = \"shank\"\nat = \"toe\"\n"), Contains("E112"));
  CHECK_THAT(input("wrench = \"shank\"\nunit = \"N\"\n"),
             Contains("torques are in N*m and forces in N\n") && Contains("omit `unit`"));
  CHECK_THAT(input("wrench = \"shank\"\nfor = \"i in 1..2\"\n"),
             Contains("a wrench cannot be repeated"));
  const std::string rod =
      "[[constraint]]\nname = \"floor\"\nequation = \"y(toe) = -l\"\n[[input]]\nname = \"motor\"\n"
      "unit = \"N*m\"\non = \"hip\"\n[[input]]\nname = \"w\"\nwrench = \"shank\"\n";
  CHECK_THAT(messages(leg(rod), "[outputs]\nconstrained_inverse_dynamics = true\n"),
             Contains("E603") && Contains("needs motors as inputs"));
}

}  // namespace elgen::test
