// draft_joint: coordinates, damping and friction, and chains of mimic joints, whose ratios
// multiply.
#include <catch2/catch.hpp>

#include "urdf/draft.hpp"
#include "urdf/urdf_testing.hpp"

namespace elgen::test {

using Catch::Contains;

namespace {

/// An arm that slides by the joint `a`, and a joint `k` of this type whose `elements` mimic `a`.
std::string mimicking(const std::string& type, const std::string& elements) {
  return with_arm(
      "<link name=\"b\"/>\n"
      "<joint name=\"a\" type=\"prismatic\"><parent link=\"base\"/><child link=\"arm\"/></joint>\n"
      "<joint name=\"k\" type=\"" +
      type + "\"><parent link=\"base\"/><child link=\"b\"/>" + elements + "</joint>");
}

std::string hinge(const std::string& name, const std::string& child, const std::string& inside) {
  return "<joint name=\"" + name + "\" type=\"revolute\"><parent link=\"base\"/><child link=\"" +
         child + "\"/><axis xyz=\"0 0 1\"/>" + inside + "</joint>\n";
}

/// The imported model of three hinges: `k` mimics `b`, which mimics `a`.
std::string mimic_chain(const std::string& of_k, const std::string& of_b) {
  return imported(with_arm("<link name=\"l\"/><link name=\"f\"/>" +
                           hinge("k", "f", "<mimic joint=\"b\" " + of_k + "/>") +
                           hinge("b", "l", "<mimic joint=\"a\" " + of_b + "/>") +
                           hinge("a", "arm", "")));
}

}  // namespace

TEST_CASE("a revolute joint is an angle and a torque, with the limits of the file") {
  const std::string model = imported(arm_on(
      "revolute",
      "<axis xyz=\"0 0 -1\"/><limit lower=\"-1.5\" upper=\"2\" effort=\"87\" velocity=\"3\"/>"));
  CHECK_THAT(model, Contains(R"(
[[coordinate]]
name       = "j"
unit       = "rad"
range      = [-1.5, 2]
rate_range = [-3, 3]
doc        = "revolute joint: base to arm"
)"));
  CHECK_THAT(model, Contains(R"(
[[input]]
name   = "tau_j"
unit   = "N*m"
on     = "j"
limits = [-87, 87]
doc    = "torque of j"
)"));
  CHECK_THAT(model, Contains("rotate = [[\"z\", \"-j\"]]"));
}

TEST_CASE("a continuous joint has a full turn as its range, and limits of 0 are ignored") {
  const std::string model = imported(
      arm_on("continuous", "<limit lower=\"0\" upper=\"0\" effort=\"0\" velocity=\"0\"/>"));
  CHECK_THAT(model, Contains("range = [\"-pi\", \"pi\"]\nwrap  = true\n"));
  CHECK_THAT(model, !Contains("rate_range"));
  CHECK_THAT(model, !Contains("limits"));
  CHECK_THAT(imported(arm_on("revolute", "<limit effort=\"1\"/>")), !Contains("range"));
}

TEST_CASE("an oblique axis is three numbers, normalised if a joint slides along it") {
  const std::string oblique = "<axis xyz=\"0.6 0 -0.8\"/>";
  CHECK_THAT(imported(arm_on("revolute", oblique)),
             Contains("rotate = [[[\"0.6\", \"0\", \"-0.8\"], \"j\"]]"));
  CHECK_THAT(imported(arm_on("prismatic", oblique)),
             Contains("translate = [\"0.6*j\", \"0\", \"-0.8*j\"]"));
  CHECK_THAT(imported(arm_on("prismatic", "<axis xyz=\"0.7 -0.7 0\"/>")),
             Contains("translate = [\"0.7*j/sqrt(0.7^2 + 0.7^2)\", "
                      "\"-0.7*j/sqrt(0.7^2 + 0.7^2)\", \"0\"]"));
}

TEST_CASE("displacements along an oblique axis are divided by its length") {
  const std::string model =
      imported(mimicking("prismatic", "<axis xyz=\"1 -1 0\"/><mimic joint=\"a\" offset=\"0.5\"/>"));
  CHECK_THAT(model, Contains("translate = [\"(a + offset_k)/sqrt(1^2 + 1^2)\", "
                             "\"-(a + offset_k)/sqrt(1^2 + 1^2)\", \"0\"]"));
}

TEST_CASE("a floating joint has three lengths and an attitude, and no input") {
  const std::string model = imported(arm_on("floating", ""));
  CHECK_THAT(model, Contains("name  = \"j_x\"\nunit  = \"m\"\nlatex = 'x'\n"));
  CHECK_THAT(model, Contains("name  = \"j_attitude\"\nkind  = \"rotation\"\nlatex = 'e'\n"));
  CHECK_THAT(model, !Contains("[[input]]"));
  CHECK_THAT(model, Contains("translate = [\"j_x\", \"j_y\", \"j_z\"]\n"
                             "rotation  = \"j_attitude\"\n"));
}

TEST_CASE("a planar joint has two lengths in its plane and an angle about its normal") {
  const std::string model = imported(arm_on("planar", "<axis xyz=\"0 1 0\"/>"));
  CHECK(model.find("name  = \"j_z\"") < model.find("name  = \"j_x\""));
  CHECK_THAT(model, Contains("name  = \"j_angle\"\nunit  = \"rad\"\n"
                             "range = [\"-pi\", \"pi\"]\nwrap  = true\nlatex = '\\varphi'\n"));
  CHECK_THAT(model, Contains("translate = [\"j_x\", \"0\", \"j_z\"]\n"
                             "rotate    = [[\"y\", \"j_angle\"]]\n"));
  CHECK_THAT(model, Contains("name = \"f_j_z\"\nunit = \"N\"\non   = \"j_z\"\n"
                             "doc  = \"force of j\"\n"));
  CHECK_THAT(model, Contains("name = \"tau_j_angle\"\nunit = \"N*m\"\non   = \"j_angle\"\n"
                             "doc  = \"torque of j\"\n"));
}

TEST_CASE("a mimic joint has no coordinate and no input") {
  const std::string model =
      imported(mimicking("revolute", "<mimic joint=\"a\" multiplier=\"-25\" offset=\"0.5\"/>"));
  CHECK(model.find("[[coordinate]]") == model.rfind("[[coordinate]]"));
  CHECK(model.find("[[input]]") == model.rfind("[[input]]"));
  CHECK_THAT(model, Contains("\"ratio_k*a + offset_k\"]]"));
  CHECK(after(model, "ratio_k  = ") == "{ value = -25, unit = \"rad/m\" }");
  CHECK(after(model, "offset_k = ") == "{ value = 0.5, unit = \"rad\" }");
}

TEST_CASE("a mimic joint with ratio 1, -1 or 0 needs no parameter") {
  const auto model = [](const std::string& multiplier) {
    return imported(mimicking(
        "prismatic", "<mimic joint=\"a\" multiplier=\"" + multiplier + "\" offset=\"1\"/>"));
  };
  CHECK_THAT(model("1"), Contains("translate = [\"a + offset_k\", "));
  CHECK_THAT(model("-1.0"), Contains("translate = [\"-a + offset_k\", "));
  CHECK_THAT(model("0"), Contains("translate = [\"offset_k\", "));
}

TEST_CASE("between an angle and a length a ratio of 1 has a unit and is a parameter") {
  const std::string model = imported(mimicking("revolute", "<mimic joint=\"a\"/>"));
  CHECK_THAT(model, Contains("\"ratio_k*a\"]]"));
  CHECK(after(model, "ratio_k = ") == "{ value = 1, unit = \"rad/m\" }");
}

TEST_CASE("damping is a term of D, friction is a force") {
  const std::string model =
      imported(arm_on("prismatic", "<dynamics damping=\"2\" friction=\"3\"/>"));
  CHECK_THAT(model, Contains("D = \"\"\"\n  1/2*damping_j*dot(j)^2\n\"\"\"\n"));
  CHECK_THAT(model, Contains("[[force]]\non    = \"j\"\n"
                             "value = \"-friction_j*tanh(dot(j)/j_stiction_rate)\"\n"));
  CHECK_THAT(after(model, "damping_j "), Contains("unit = \"N*s/m\""));
  CHECK_THAT(after(model, "friction_j "), Contains("unit = \"N\""));
  CHECK_THAT(after(model, "j_stiction_rate "), Contains("value = 0.01, unit = \"m/s\""));
}

TEST_CASE("damping and friction of a mimic joint act on the shared coordinate") {
  const std::string dynamics = "<dynamics damping=\"2\" friction=\"3\"/>";
  const std::string geared =
      imported(mimicking("revolute", "<mimic joint=\"a\" multiplier=\"2\"/>" + dynamics));
  CHECK_THAT(geared, Contains("\n  1/2*damping_k*(ratio_k*dot(a))^2\n"));
  CHECK_THAT(geared,
             Contains("on    = \"a\"\n"
                      "value = \"-ratio_k*friction_k*tanh(ratio_k*dot(a)/k_stiction_rate)\"\n"));
  const std::string opposite =
      imported(mimicking("prismatic", "<mimic joint=\"a\" multiplier=\"-1\"/>" + dynamics));
  CHECK_THAT(opposite, Contains("\n  1/2*damping_k*dot(a)^2\n"));
  CHECK_THAT(opposite, Contains("value = \"-friction_k*tanh(dot(a)/k_stiction_rate)\"\n"));
  CHECK_THAT(imported(mimicking("prismatic", "<mimic joint=\"a\" multiplier=\"0\"/>" + dynamics)),
             !Contains("[[force]]"));
}

TEST_CASE("the ratios of a chain of mimics multiply, and offsets are scaled by them") {
  const std::string model =
      mimic_chain("multiplier=\"2\" offset=\"0.1\"", "multiplier=\"3\" offset=\"0.2\"");
  CHECK_THAT(model, Contains("\"ratio_k*ratio_b*a + ratio_k*offset_b + offset_k\"]]"));
  CHECK_THAT(model, Contains("\"ratio_b*a + offset_b\"]]"));
  CHECK(model.find("ratio_b ") == model.rfind("ratio_b "));
  CHECK(after(model, "#     f    ") == "k, revolute like b");
}

TEST_CASE("signs in a chain of mimics stay signs") {
  CHECK_THAT(mimic_chain("multiplier=\"-1\"", "multiplier=\"-1\""),
             Contains("rotate = [[\"z\", \"a\"]]"));
  CHECK_THAT(mimic_chain("multiplier=\"2\"", "multiplier=\"-1\""), Contains("\"-ratio_k*a\"]]"));
  CHECK_THAT(mimic_chain("multiplier=\"-1\"", "multiplier=\"2\""), Contains("\"-ratio_b*a\"]]"));
}

TEST_CASE("damping in a chain of mimics acts on the coordinate at its end") {
  const std::string model = imported(
      with_arm("<link name=\"l\"/><link name=\"f\"/>" +
               hinge("k", "f", "<mimic joint=\"b\" multiplier=\"2\"/><dynamics damping=\"0.5\"/>") +
               hinge("b", "l", "<mimic joint=\"a\" multiplier=\"3\"/>") + hinge("a", "arm", "")));
  CHECK_THAT(model, Contains("1/2*damping_k*(ratio_k*ratio_b*dot(a))^2"));
}

}  // namespace elgen::test
