// draft_joint: coordinates, inputs, couplings, and what brakes.
#include <catch2/catch.hpp>

#include "urdf/drafting.hpp"
#include "urdf/urdf_testing.hpp"

namespace elgen::test {

namespace {

urdf::Draft draft_of(const std::string& text) {
  const urdf::Robot robot = robot_of(text);
  return urdf::make_draft(robot, tree_of(robot));
}

const urdf::FrameDraft& last_frame(const urdf::Draft& draft) {
  return draft.links.back().frames.back();
}

/// An arm that slides by `a`, and a second one that mimics it.
std::string mimicking(const std::string& type, const std::string& elements) {
  return with_arm(
      "<link name=\"b\"/>\n"
      "<joint name=\"a\" type=\"prismatic\"><parent link=\"base\"/><child link=\"arm\"/></joint>\n"
      "<joint name=\"k\" type=\"" +
      type + "\"><parent link=\"base\"/><child link=\"b\"/>" + elements + "</joint>");
}

}  // namespace

TEST_CASE("a revolute joint is an angle and a torque, with the limits of the file") {
  const urdf::Draft draft = draft_of(arm_on(
      "revolute",
      "<axis xyz=\"0 0 -1\"/><limit lower=\"-1.5\" upper=\"2\" effort=\"87\" velocity=\"3\"/>"));
  REQUIRE(draft.coordinates.size() == 1);
  const urdf::CoordinateDraft& q = draft.coordinates[0];
  CHECK(q.name == "j");
  CHECK(q.unit == "rad");
  CHECK(q.low == "-1.5");
  CHECK(q.high == "2");
  CHECK(q.rate == "3");
  CHECK_FALSE(q.wraps);
  REQUIRE(draft.inputs.size() == 1);
  CHECK(draft.inputs[0].name == "tau_j");
  CHECK(draft.inputs[0].unit == "N*m");
  CHECK(draft.inputs[0].on == "j");
  CHECK(draft.inputs[0].limit == "87");
  CHECK(last_frame(draft).rotate.back().axis[0] == "z");
  CHECK(last_frame(draft).rotate.back().angle == "-j");
}

TEST_CASE("a continuous joint turns all the way round, limits of 0 are none") {
  const urdf::Draft draft = draft_of(
      arm_on("continuous", "<limit lower=\"0\" upper=\"0\" effort=\"0\" velocity=\"0\"/>"));
  CHECK(draft.coordinates[0].wraps);
  CHECK(draft.coordinates[0].low == "\"-pi\"");
  CHECK(draft.coordinates[0].rate.empty());
  CHECK(draft.inputs[0].limit.empty());
  CHECK(draft_of(arm_on("revolute", "<limit effort=\"1\"/>")).coordinates[0].low.empty());
}

TEST_CASE("an oblique axis is three numbers, and of length 1 where something slides along it") {
  const std::string oblique = "<axis xyz=\"0.6 0 -0.8\"/>";
  CHECK(last_frame(draft_of(arm_on("revolute", oblique))).rotate.back().axis ==
        urdf::Components{"0.6", "0", "-0.8"});
  CHECK(last_frame(draft_of(arm_on("prismatic", oblique))).translate ==
        urdf::Components{"0.6*j", "0", "-0.8*j"});
  CHECK(last_frame(draft_of(arm_on("prismatic", "<axis xyz=\"0.7 -0.7 0\"/>"))).translate ==
        urdf::Components{"0.7*j/sqrt(0.7^2 + 0.7^2)", "-0.7*j/sqrt(0.7^2 + 0.7^2)", "0"});
}

TEST_CASE("all of what slides along an oblique axis is divided by its length") {
  const urdf::Draft draft =
      draft_of(mimicking("prismatic", "<axis xyz=\"1 -1 0\"/><mimic joint=\"a\" offset=\"0.5\"/>"));
  CHECK(last_frame(draft).translate ==
        urdf::Components{"(a + offset_k)/sqrt(1^2 + 1^2)", "-(a + offset_k)/sqrt(1^2 + 1^2)", "0"});
}

TEST_CASE("a floating joint has three lengths and an attitude, and nothing drives it") {
  const urdf::Draft draft = draft_of(arm_on("floating", ""));
  REQUIRE(draft.coordinates.size() == 4);
  CHECK(draft.coordinates[0].name == "j_x");
  CHECK(draft.coordinates[0].unit == "m");
  CHECK(draft.coordinates[3].name == "j_attitude");
  CHECK(draft.coordinates[3].unit.empty());
  CHECK(draft.inputs.empty());
  CHECK(last_frame(draft).translate == urdf::Components{"j_x", "j_y", "j_z"});
  CHECK(last_frame(draft).rotation == "j_attitude");
}

TEST_CASE("a planar joint has two lengths in its plane and an angle about its normal") {
  const urdf::Draft draft = draft_of(arm_on("planar", "<axis xyz=\"0 1 0\"/>"));
  REQUIRE(draft.coordinates.size() == 3);
  CHECK(draft.coordinates[0].name == "j_z");
  CHECK(draft.coordinates[1].name == "j_x");
  CHECK(draft.coordinates[2].name == "j_angle");
  CHECK(last_frame(draft).translate == urdf::Components{"j_x", "0", "j_z"});
  CHECK(last_frame(draft).rotate.back().axis[0] == "y");
  REQUIRE(draft.inputs.size() == 3);
  CHECK(draft.inputs[0].name == "f_j_z");
  CHECK(draft.inputs[2].name == "tau_j_angle");
}

TEST_CASE("a joint that mimics has no coordinate and no input") {
  const urdf::Draft draft =
      draft_of(mimicking("revolute", "<mimic joint=\"a\" multiplier=\"-25\" offset=\"0.5\"/>"));
  CHECK(draft.coordinates.size() == 1);
  CHECK(draft.inputs.size() == 1);
  CHECK(last_frame(draft).rotate.back().angle == "ratio_k*a + offset_k");
  const auto& parameters = draft.parameters.back().parameters;
  REQUIRE(parameters.size() == 2);
  CHECK(parameters[0].unit == "rad/m");
  CHECK(parameters[1].unit == "rad");
}

TEST_CASE("a joint that mimics by 1, -1 or 0 needs no ratio") {
  const auto way = [](const std::string& multiplier) {
    return last_frame(draft_of(mimicking("prismatic", "<mimic joint=\"a\" multiplier=\"" +
                                                          multiplier + "\" offset=\"1\"/>")))
        .translate[0];
  };
  CHECK(way("1") == "a + offset_k");
  CHECK(way("-1.0") == "-a + offset_k");
  CHECK(way("0") == "offset_k");
}

TEST_CASE("between an angle and a length 1 has a unit, and is a ratio") {
  const urdf::Draft draft = draft_of(mimicking("revolute", "<mimic joint=\"a\"/>"));
  CHECK(last_frame(draft).rotate.back().angle == "ratio_k*a");
  const auto& parameters = draft.parameters.back().parameters;
  REQUIRE(parameters.size() == 1);
  CHECK(parameters[0].unit == "rad/m");
}

TEST_CASE("damping is a term of D, friction a force") {
  const std::string dynamics = "<dynamics damping=\"2\" friction=\"3\"/>";
  const urdf::Draft draft = draft_of(arm_on("prismatic", dynamics));
  CHECK(draft.dissipation == std::vector<std::string>{"1/2*damping_j*dot(j)^2"});
  REQUIRE(draft.forces.size() == 1);
  CHECK(draft.forces[0].on == "j");
  CHECK(draft.forces[0].value == "-friction_j*tanh(dot(j)/j_stiction_rate)");
  const auto& parameters = draft.parameters.back().parameters;
  CHECK(parameters[0].unit == "N*s/m");
  CHECK(parameters[1].unit == "N");
  CHECK(parameters[2].unit == "m/s");
  CHECK(parameters[2].value == "0.01");
}

TEST_CASE("what brakes a joint that mimics brakes the coordinate it shares") {
  const std::string dynamics = "<dynamics damping=\"2\" friction=\"3\"/>";
  const urdf::Draft geared =
      draft_of(mimicking("revolute", "<mimic joint=\"a\" multiplier=\"2\"/>" + dynamics));
  CHECK(geared.dissipation == std::vector<std::string>{"1/2*damping_k*(ratio_k*dot(a))^2"});
  CHECK(geared.forces[0].on == "a");
  CHECK(geared.forces[0].value == "-ratio_k*friction_k*tanh(ratio_k*dot(a)/k_stiction_rate)");
  const urdf::Draft opposite =
      draft_of(mimicking("prismatic", "<mimic joint=\"a\" multiplier=\"-1\"/>" + dynamics));
  CHECK(opposite.dissipation == std::vector<std::string>{"1/2*damping_k*dot(a)^2"});
  CHECK(opposite.forces[0].value == "-friction_k*tanh(dot(a)/k_stiction_rate)");
  CHECK(draft_of(mimicking("prismatic", "<mimic joint=\"a\" multiplier=\"0\"/>" + dynamics))
            .forces.empty());
}

}  // namespace elgen::test
