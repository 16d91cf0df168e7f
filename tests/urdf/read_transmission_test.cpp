// read_transmission: rotors become armatures of coordinates.
#include <catch2/catch.hpp>

#include "urdf/urdf_testing.hpp"

namespace elgen::test {

using Catch::Contains;

namespace {

std::string motor(const std::string& joint, const std::string& inside) {
  return "<transmission name=\"t\"><type>x</type><joint name=\"" + joint +
         "\"><hardwareInterface/></joint>\n<actuator name=\"a\"><mechanicalReduction>5"
         "</mechanicalReduction>" +
         inside + "</actuator></transmission>\n";
}

std::string driven(const std::string& type, const std::string& motors) {
  return with_arm("<joint name=\"j\" type=\"" + type +
                  "\"><parent link=\"base\"/><child link=\"arm\"/></joint>\n" + motors);
}

const std::string rotor = "<drake:rotor_inertia value=\"1e-4\"/>";
const std::string gear = "<drake:gear_ratio value=\"100\"/>";

}  // namespace

TEST_CASE("a rotor behind a gear is felt by the square of its ratio") {
  const std::string model = imported(driven("revolute", motor("j", rotor + gear)));
  CHECK_THAT(model, Contains("armature = \"rotor_j*gear_j^2\"\n"));
  CHECK_THAT(after(model, "rotor_j "), Contains("{ value = 1e-4, unit = \"kg*m^2\", assume"));
  CHECK_THAT(after(model, "gear_j  "), Contains("value = 100,  unit = \"1\""));
}

TEST_CASE("without a gear the rotor turns with the joint, and one that slides has a ratio") {
  CHECK_THAT(imported(driven("continuous", motor("j", rotor))),
             Contains("armature = \"rotor_j\"\n"));
  const std::string slides = imported(driven("prismatic", motor("j", rotor)));
  CHECK_THAT(slides, Contains("armature = \"rotor_j*gear_j^2\"\n"));
  CHECK_THAT(slides, Contains("unit = \"rad/m\""));
}

TEST_CASE("a rotor of a joint that mimics is felt by the coordinate it shares") {
  const std::string model = imported(with_arm(
      "<link name=\"f\"/><joint name=\"k\" type=\"revolute\"><parent link=\"base\"/><child "
      "link=\"f\"/><mimic joint=\"j\" multiplier=\"3\"/></joint><joint name=\"j\" "
      "type=\"revolute\"><parent link=\"base\"/><child link=\"arm\"/></joint>" +
      motor("k", rotor) + motor("j", rotor + gear)));
  CHECK_THAT(model, Contains("armature = \"rotor_k*(ratio_k)^2 + rotor_j*gear_j^2\"\n"));
}

TEST_CASE("a rotor of no joint is noted, other transmissions are silent") {
  CHECK(import_messages(driven("revolute", motor("j", gear))).empty());
  CHECK(import_messages(driven("revolute", motor("k", rotor))) ==
        "E815 6:65 `<drake:rotor_inertia>` in `<actuator>` is not imported | `k` is no joint that "
        "turns or slides\n");
  CHECK(import_messages(driven("revolute", motor("j", "<drake:rotor_inertia value=\"-1\"/>"))) ==
        "E811 6:92 the rotor inertia `-1` is negative\n");
}

}  // namespace elgen::test
