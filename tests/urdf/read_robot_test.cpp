// <robot>: its name, links, joints and rotors, and files that contain something else.
#include <catch2/catch.hpp>

#include "support/text.hpp"
#include "urdf/urdf_testing.hpp"

namespace elgen::test {

using Catch::Contains;

namespace {

std::string link(const std::string& inside) {
  return "<robot name=\"r\"><link name=\"a\">\n" + inside + "\n</link></robot>";
}

/// The messages about a joint of this type with these elements, which are on line 5.
std::string messages_about(const std::string& type, const std::string& elements) {
  return reading_messages(arm_on(type, elements));
}

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

TEST_CASE("a robot has the links and joints of its file in the same order") {
  const urdf::Robot robot = robot_of(arm_on("revolute", ""));
  CHECK(robot.file == "r.urdf");
  CHECK(robot.name == "r");
  REQUIRE(robot.links.size() == 2);
  CHECK(robot.links[1].name.text == "arm");
  REQUIRE(robot.joints.size() == 1);
  CHECK(robot.joints[0].child.text == "arm");
}

TEST_CASE("a robot without a name gets the name of its file") {
  const urdf::Robot robot = robot_of("<robot><link name=\"a\"/></robot>");
  CHECK(robot.name == "r");
  CHECK(robot.model == "r");
}

TEST_CASE("a different root element is an error") {
  CHECK(import_messages("<sdf version=\"1.6\"/>") ==
        "E802 1:2 `<sdf>` is SDF, and elgen reads URDF | convert it to URDF first\n");
  CHECK(import_messages("<mujoco/>") ==
        "E802 1:2 `<mujoco>` is MJCF, and elgen reads URDF | convert it to URDF first\n");
  CHECK(import_messages("<svg/>") == "E802 1:2 `<svg>` is no `<robot>`\n");
}

TEST_CASE("for a file that xacro must expand, no other mistakes are reported") {
  CHECK(import_messages("<robot name=\"r\"><xacro:arm/>\n<joint name=\"${j}\"/></robot>") ==
        "E802 1:18 `<xacro:arm>` is a macro of xacro | expand the file first: `xacro FILE > "
        "robot.urdf`, in ROS 2 `ros2 run xacro xacro FILE > robot.urdf`\n");
}

TEST_CASE("an expression that xacro expanded to nothing is reported") {
  CHECK(import_messages("<robot xmlns:xacro=\"x\"></robot>") ==
        "E803 1:2 `<robot>` has no element `link` | xacro expanded no macro here: expand the file "
        "that calls them\n");
}

TEST_CASE("macros must be expanded first") {
  CHECK(reading_messages("<robot name=\"r\" xmlns:xacro=\"x\">\n<xacro:property name=\"a\"/>\n"
                         "<xacro:arm/></robot>") ==
        "E802 2:2 `<xacro:property>` is a macro of xacro | expand the file first: `xacro FILE > "
        "robot.urdf`, in ROS 2 `ros2 run xacro xacro FILE > robot.urdf`\n");
}

TEST_CASE("materials and transmissions are ignored, other elements give a note") {
  CHECK(reading_messages("<robot name=\"r\"><material name=\"red\"/><transmission/>\n"
                         "<gazebo><a/></gazebo></robot>") ==
        "E815 2:2 `<gazebo>` in `<robot>` is not imported\n");
}

TEST_CASE("an inertial is read in the order xx yy zz xy xz yz") {
  const urdf::Robot robot = robot_of(
      link("<inertial><origin xyz=\"1 2 3\" rpy=\"0 0 1\"/><mass value=\"4\"/><inertia ixx=\"1\" "
           "ixy=\"2\" ixz=\"3\" iyy=\"4\" iyz=\"5\" izz=\"6\"/></inertial>"));
  const urdf::Inertial& inertial = *robot.links[0].inertial;
  CHECK(robot.links[0].has_mass());
  CHECK(inertial.mass.text == "4");
  CHECK(inertial.origin.xyz[1].text == "2");
  CHECK(inertial.origin.rpy[2].text == "1");
  std::string order;
  for (const urdf::FileNumber& number : inertial.inertia) order += number.text;
  CHECK(order == "146235");
}

TEST_CASE("a link without inertial has no mass, and shapes are ignored") {
  const std::string text = link("<visual/><visual/><collision/>");
  CHECK(reading_messages(text).empty());
  CHECK_FALSE(robot_of(text).links[0].has_mass());
}

TEST_CASE("an inertial has a mass and six inertias") {
  CHECK(reading_messages(link("<inertial/>")) ==
        "E803 2:2 `<inertial>` has no element `inertia`\n"
        "E803 2:2 `<inertial>` has no element `mass`\n");
  CHECK(reading_messages(link("<inertial><mass/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\"/>"
                              "</inertial>")) ==
        "E803 2:12 `<mass>` has no attribute `value`\n"
        "E803 2:19 `<inertia>` has no attribute `ixy`\n"
        "E803 2:19 `<inertia>` has no attribute `ixz`\n"
        "E803 2:19 `<inertia>` has no attribute `iyz`\n");
}

TEST_CASE("a negative mass is an error") {
  CHECK(reading_messages(link("<inertial><mass value=\"-2\"/><inertia ixx=\"1\" ixy=\"0\" "
                              "ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial>")) ==
        "E811 2:24 the mass `-2` is negative\n");
}

TEST_CASE("all elements of a joint are read") {
  const urdf::Robot robot = robot_of(arm_on(
      "prismatic",
      "<origin xyz=\"1 2 3\"/><axis xyz=\"0 0 1\"/><limit lower=\"-1\" upper=\"2\" effort=\"3\" "
      "velocity=\"4\"/><dynamics damping=\"5\" friction=\"6\"/><mimic joint=\"k\" offset=\"7\"/>"));
  const urdf::Joint& joint = robot.joints[0];
  CHECK(joint.type == urdf::JointType::prismatic);
  CHECK(joint.parent.text == "base");
  CHECK(joint.origin.xyz[2].text == "3");
  CHECK(joint.axis[2].text == "1");
  CHECK(joint.limit.lower->text == "-1");
  CHECK(joint.limit.upper->text == "2");
  CHECK(joint.limit.effort->text == "3");
  CHECK(joint.limit.velocity->text == "4");
  CHECK(joint.damping.text == "5");
  CHECK(joint.friction.text == "6");
  CHECK(joint.mimic->joint.text == "k");
  CHECK(joint.mimic->multiplier.text == "1");
  CHECK(joint.mimic->offset.text == "7");
}

TEST_CASE("the default axis is x, and without dynamics there is no damping") {
  const urdf::Joint joint = robot_of(arm_on("revolute", "")).joints[0];
  CHECK(joint.axis[0].text == "1");
  CHECK(joint.axis[1].is_zero());
  CHECK(joint.damping.is_zero());
  CHECK_FALSE(joint.mimic);
}

TEST_CASE("an unknown type, with a suggestion") {
  CHECK(messages_about("revolut", "") ==
        "E806 4:25 `revolut` is no type of joint | did you mean `revolute`?\n");
  CHECK(messages_about("ball", "") ==
        "E806 4:25 `ball` is no type of joint | there are revolute, continuous, prismatic, fixed, "
        "floating, planar; a `floating` joint is imported with a rotation and three lengths: "
        "remove the lengths\n");
  CHECK(messages_about("universal", "") ==
        "E806 4:25 `universal` is no type of joint | there are revolute, continuous, prismatic, "
        "fixed, floating, planar\n");
}

TEST_CASE("type, parent and child are required") {
  CHECK(reading_messages("<robot name=\"r\">\n<joint name=\"j\"><parent/></joint></robot>") ==
        "E803 2:2 `<joint>` has no attribute `type`\n"
        "E803 2:2 `<joint>` has no element `child`\n"
        "E803 2:18 `<parent>` has no attribute `link`\n");
}

TEST_CASE("an axis is not zero, and the axis of a planar joint is x, y or z") {
  CHECK(messages_about("revolute", "<axis xyz=\"0 0.0 -0\"/>") ==
        "E813 5:12 the axis has no direction\n");
  CHECK(messages_about("fixed", "<axis xyz=\"0 0 0\"/>").empty());
  CHECK(messages_about("floating", "<axis xyz=\"0 0 0\"/>").empty());
  CHECK(messages_about("planar", "<axis xyz=\"1 1 0\"/>") ==
        "E108 5:12 a planar joint is imported only with an axis along x, y or z\n");
}

TEST_CASE("impossible limits are ignored with a warning") {
  const std::string none = " | the model omits this limit\n";
  const std::string swapped = "<limit lower=\"1\" upper=\"-1\" effort=\"-2\" velocity=\"-3\"/>";
  CHECK(messages_about("revolute", swapped) == "E814 5:15 lower `1` is above upper `-1`" + none +
                                                   "E814 5:37 effort `-2` is negative" + none +
                                                   "E814 5:51 velocity `-3` is negative" + none);
  const std::string model = imported(arm_on("revolute", swapped));
  for (const char* const key : {"\nrange ", "rate_range", "limits"}) {
    CHECK_THAT(model, !Contains(key));
  }
  CHECK(messages_about("prismatic", "<limit lower=\"-Inf\" upper=\"2\" effort=\"inf\"/>") ==
        "E814 5:15 lower `-Inf` is not finite" + none + "E814 5:39 effort `inf` is not finite" +
            none);
}

TEST_CASE("an expression left by xacro is distinguished from a missing number") {
  CHECK(messages_about("revolute", "<origin rpy=\"$(optenv IMU 0 -1.57 3.14)\"/>") ==
        "E805 5:14 5 numbers, but `rpy` has 3 | " + std::string(urdf::xacro_remedy) + "\n");
}

TEST_CASE("elements that a type does not use are ignored silently or with a note") {
  CHECK(messages_about("fixed", "<limit effort=\"1\"/><dynamics damping=\"1\"/>").empty());
  CHECK(messages_about("floating", "<dynamics damping=\"1\"/>") ==
        "E822 5:20 the damping of `j`, a floating joint, is not imported | the model ignores it: "
        "add it to `[energy] D`\n");
  CHECK(messages_about("fixed", "<mimic joint=\"k\"/>") ==
        "E815 5:2 `<mimic>` in a fixed `<joint>` is not imported | the joint has no coordinate\n");
  CHECK(messages_about("revolute", "<calibration rising=\"0\"/><safety_controller k=\"1\"/>")
            .empty());
  CHECK(messages_about("revolute", "<spring stiffness=\"1\"/>") ==
        "E822 5:2 `<spring>` in `<joint>` is not imported | the model ignores it: add it to "
        "`[energy] V` or `D`, or as a `[[force]]`\n");
  CHECK(messages_about("revolute", "<sensor rate=\"1\"/>") ==
        "E815 5:2 `<sensor>` in `<joint>` is not imported\n");
}

TEST_CASE("elements of other formats that change the mechanics give warnings, also when nested") {
  const auto codes = [](const std::string& elements) {
    std::string found;
    const std::string text = reading_messages("<robot name=\"r\">\n" + elements + "</robot>");
    for (const std::string& line : split_lines(text)) found += line.substr(0, line.find(" ", 5));
    return found;
  };
  CHECK(reading_messages("<robot name=\"r\">\n<constraint type=\"revolute\"/></robot>") ==
        "E822 2:2 `<constraint>` in `<robot>` is not imported | the model ignores it: a "
        "`[[constraint]]` whose points `coincide` closes a loop\n");
  CHECK(codes("<drake:linear_spring_damper/>") == "E822 2:2");
  CHECK(codes("<gazebo><joint name=\"loop\" type=\"revolute\"/></gazebo>") == "E822 2:10");
  CHECK(codes("<gazebo reference=\"j\"><springStiffness>3</springStiffness></gazebo>") ==
        "E822 2:24");
  CHECK(codes("<ros2_control><joint name=\"j\"/></ros2_control>") == "E815 2:2");
  CHECK(codes("<gazebo><turnGravityOff>false</turnGravityOff></gazebo>") == "E815 2:2");
  CHECK(codes("<transmission><joint name=\"j\" type=\"x\"/></transmission>").empty());
  CHECK(messages_about("revolute", "<dynamics damping=\"0\" stiffness=\"2\"/>") ==
        "E822 5:23 attribute `stiffness` of `<dynamics>` is not imported | the model ignores it: "
        "add it to `[energy] V` or `D`, or as a `[[force]]`\n");
  CHECK(messages_about("revolute", "<dynamics stiffness=\"0\"/>") ==
        "E815 5:11 attribute `stiffness` of `<dynamics>` is not imported\n");
}

TEST_CASE("every type has a word, and some have one coordinate") {
  CHECK(urdf::type_word(urdf::JointType::planar) == "planar");
  CHECK(urdf::has_one_coordinate(urdf::JointType::continuous));
  CHECK_FALSE(urdf::has_one_coordinate(urdf::JointType::floating));
}

TEST_CASE("the inertia of a rotor behind a gear counts with the square of its ratio") {
  const std::string model = imported(driven("revolute", motor("j", rotor + gear)));
  CHECK_THAT(model, Contains("armature = \"rotor_j*gear_j^2\"\n"));
  CHECK_THAT(after(model, "rotor_j "), Contains("{ value = 1e-4, unit = \"kg*m^2\", assume"));
  CHECK_THAT(after(model, "gear_j  "), Contains("value = 100,  unit = \"1\""));
}

TEST_CASE("without a gear the rotor rotates with the joint, and a sliding joint needs a ratio") {
  CHECK_THAT(imported(driven("continuous", motor("j", rotor))),
             Contains("armature = \"rotor_j\"\n"));
  const std::string slides = imported(driven("prismatic", motor("j", rotor)));
  CHECK_THAT(slides, Contains("armature = \"rotor_j*gear_j^2\"\n"));
  CHECK_THAT(slides, Contains("unit = \"rad/m\""));
}

TEST_CASE("the rotor of a mimic joint adds inertia to the shared coordinate") {
  const std::string model = imported(with_arm(
      "<link name=\"f\"/><joint name=\"k\" type=\"revolute\"><parent link=\"base\"/><child "
      "link=\"f\"/><mimic joint=\"j\" multiplier=\"3\"/></joint><joint name=\"j\" "
      "type=\"revolute\"><parent link=\"base\"/><child link=\"arm\"/></joint>" +
      motor("k", rotor) + motor("j", rotor + gear)));
  CHECK_THAT(model, Contains("armature = \"rotor_k*(ratio_k)^2 + rotor_j*gear_j^2\"\n"));
}

TEST_CASE("a rotor without a joint gives a note, other transmissions are ignored") {
  CHECK(import_messages(driven("revolute", motor("j", gear))).empty());
  CHECK(import_messages(driven("revolute", motor("k", rotor))) ==
        "E815 6:65 `<drake:rotor_inertia>` in `<actuator>` is not imported | `k` is neither "
        "revolute nor prismatic\n");
  CHECK(import_messages(driven("revolute", motor("j", "<drake:rotor_inertia value=\"-1\"/>"))) ==
        "E811 6:92 the rotor inertia `-1` is negative\n");
}

}  // namespace elgen::test
