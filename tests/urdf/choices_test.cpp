// Choices: held joints, the order of joints, and robots with a floating base.
#include "urdf/choices.hpp"

#include <catch2/catch.hpp>

#include "support/text.hpp"
#include "urdf/urdf_testing.hpp"

namespace elgen::test {

using Catch::Contains;

namespace {

ImportOptions keeping(const std::string& joints) {
  ImportOptions options;
  options.joints = {make_source("command line", joints)};
  return options;
}

ImportOptions welding(const std::vector<std::string>& welds) {
  ImportOptions options;
  for (const std::string& weld : welds) options.welds.push_back(make_source("command line", weld));
  return options;
}

std::string heavy_link(const std::string& name) {
  return "<link name=\"" + name +
         "\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" "
         "ixz=\"0\" iyz=\"0\"/></inertial></link>\n";
}

std::string joint_of(const std::string& name, const std::string& type,
                     const std::string& inside = "") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + name[0] +
         "\"/><child link=\"" + name[1] + "\"/><axis xyz=\"0 0 1\"/>" + inside + "</joint>\n";
}

/// Links a, b, c and d in a chain: ab rotates, bc slides, cd rotates twice as far as ab.
std::string crane() {
  return "<robot name=\"r\"><link name=\"a\"/>\n" + heavy_link("b") + heavy_link("c") +
         heavy_link("d") + joint_of("ab", "revolute") +
         joint_of("bc", "prismatic", "<origin rpy=\"1 0 0\"/><dynamics damping=\"1\"/>") +
         joint_of("cd", "continuous", "<mimic joint=\"ab\" multiplier=\"2\" offset=\"0.5\"/>") +
         "</robot>";
}

const std::string flying_body =
    "<inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" "
    "iyz=\"0\"/></inertial>";

}  // namespace

TEST_CASE("only the named joints move, in the given order") {
  const std::string model = imported(crane(), keeping("bc,ab"));
  CHECK_THAT(model, Contains("name  = \"bc\"\nunit  = \"m\"\nlatex = 'q_1'\n"));
  CHECK_THAT(model, Contains("name  = \"ab\"\nunit  = \"rad\"\nlatex = 'q_2'\n"));
  CHECK(model.find("name  = \"bc\"") < model.find("name  = \"ab\""));
  CHECK(model.find("\"f_bc\"") < model.find("\"tau_ab\""));
  CHECK(count(model, "[[coordinate]]") == 2);
}

TEST_CASE("other joints are held at 0, together with joints that mimic them") {
  const std::string model = imported(crane(), keeping("bc"));
  CHECK(count(model, "[[coordinate]]") == 1);
  CHECK(count(model, "[[input]]") == 1);
  CHECK_THAT(model, Contains("# ab: revolute about z, welded at 0\n[[frame]]\nname   = \"b\"\n"
                             "parent = \"world\"\n\n"));
  CHECK_THAT(model, Contains("rotate = [[\"z\", \"0.5\"]]"));
  CHECK(after(model, "#         d  ") == "cd, continuous, welded at 0.5");
}

TEST_CASE("joints are held inside their limits, with a note if 0 is outside") {
  const auto arm = [](const std::string& limits, const std::string& type = "revolute") {
    return "<robot name=\"r\"><link name=\"a\"/>" + heavy_link("b") + heavy_link("c") +
           joint_of("ab", "revolute") + joint_of("bc", type, "<limit " + limits + "/>") +
           "</robot>";
  };
  const auto held = [&](const std::string& limits, const std::string& type = "revolute") {
    return after(imported(arm(limits, type), keeping("ab")), "bc, " + type + ", welded at ");
  };
  const std::string elbow = "lower=\"0.5\" upper=\"2.2\"";
  CHECK(import_messages(arm(elbow), keeping("ab")) ==
        "E820 4:14 `bc` is held at 0.5 | its limits are 0.5 to 2.2\n");
  CHECK_THAT(imported(arm(elbow), keeping("ab")), Contains("rotate = [[\"z\", \"0.5\"]]"));
  CHECK(held(elbow) == "0.5");
  CHECK(held("lower=\"-0.3\" upper=\"-0.1\"", "prismatic") == "-0.1");
  CHECK(held("lower=\"-2\" upper=\"2\"") == "0");
  CHECK(held("lower=\"0\" upper=\"2\"") == "0");
  CHECK(held("lower=\"0.5\" upper=\"2\"", "continuous") == "0");
  CHECK(import_messages(arm("lower=\"-2\" upper=\"2\""), keeping("ab")).empty());
  CHECK(import_messages(arm(elbow), welding({"bc=0"})).empty());
}

TEST_CASE("if all joints are held, the robot floats") {
  CHECK_THAT(import_messages(crane(), welding({"bc=-0.25", "ab=0.1"})), Contains("`a` floats"));
}

TEST_CASE("a sliding joint is held by a parameter, a rotating one by an angle") {
  const std::string slid = imported(crane(), welding({"bc=-0.25"}));
  CHECK(after(slid, "at_bc ") == "= { value = -0.25, unit = \"m\" }");
  CHECK_THAT(slid, Contains("parent = \"b\"\nrotate = [[\"x\", \"1\"]]"));
  CHECK_THAT(slid, Contains("parent    = \"bc_origin\"\ntranslate = [\"0\", \"0\", \"at_bc\"]"));
  CHECK_THAT(slid, !Contains("[energy]"));
  const std::string turned = imported(crane(), welding({"ab=1.5707963"}));
  CHECK_THAT(turned, Contains("rotate = [[\"z\", \"pi/2\"]]"));
  CHECK_THAT(turned, Contains("rotate = [[\"z\", \"3.6415926\"]]"));
}

TEST_CASE("joints that move no mass are held together") {
  const std::string text = with_arm(
      "<link name=\"f\"/><joint name=\"j\" type=\"revolute\"><parent link=\"base\"/><child "
      "link=\"arm\"/></joint>\n<joint name=\"finger\" type=\"prismatic\"><parent link=\"arm\"/>"
      "<child link=\"f\"/></joint>");
  CHECK(import_messages(text) ==
        "E810 5:14 `finger` moves no mass | `f` has no `<mass>`, nor has any link that it carries; "
        "`--weld massless` fixes such joints\n");
  CHECK(import_messages(text, welding({"massless"})) ==
        "E820 5:14 `finger` is held at 0 | it moves no mass\n");
  CHECK_THAT(imported(text, welding({"massless"})),
             Contains("# finger: prismatic along x, welded at 0"));
}

TEST_CASE("the angle of a planar joint that rotates a point mass is held") {
  const auto puck = [](const std::string& place, const std::string& izz) {
    return "<robot name=\"r\"><link name=\"world\"/>\n<link name=\"puck\"><inertial><origin "
           "xyz=\"" +
           place + "\"/><mass value=\"1\"/><inertia ixx=\"0\" ixy=\"0\" ixz=\"0\" iyy=\"" + izz +
           "\" iyz=\"0\" izz=\"" + izz +
           "\"/></inertial></link>\n<joint name=\"j\" type=\"planar\"><parent " +
           "link=\"world\"/><child link=\"puck\"/><axis xyz=\"0 0 1\"/></joint></robot>";
  };
  CHECK(import_messages(puck("0 0 1", "0"), welding({"massless"})) ==
        "E820 3:14 the angle of `j` is held at 0 | it moves no inertia\n");
  const std::string held = imported(puck("0 0 1", "0"), welding({"massless"}));
  CHECK_THAT(held, Contains("# j: planar normal to z, its angle welded at 0"));
  CHECK_THAT(held, Contains("j_y"));
  CHECK_THAT(held, !Contains("j_angle"));
  CHECK_THAT(imported(puck("0 0 1", "0")), Contains("j_angle"));
  CHECK_THAT(imported(puck("0.1 0 0", "0"), welding({"massless"})), Contains("j_angle"));
  CHECK_THAT(imported(puck("0 0 0", "2"), welding({"massless"})), Contains("j_angle"));
}

TEST_CASE("point masses fixed on the axis of a planar joint add no inertia") {
  const auto puck = [](const std::string& origin, const std::string& mass,
                       const std::string& inertia) {
    return "<robot name=\"r\"><link name=\"world\"/><link name=\"puck\"/>\n<link "
           "name=\"tool\"><inertial><mass value=\"" +
           mass + "\"/><inertia ixx=\"0\" ixy=\"0\" ixz=\"0\" iyy=\"" + inertia +
           "\" iyz=\"0\" izz=\"" + inertia +
           "\"/></inertial></link>\n<joint name=\"j\" type=\"planar\"><parent "
           "link=\"world\"/><child "
           "link=\"puck\"/><axis xyz=\"0 0 1\"/></joint>\n<joint name=\"k\" type=\"fixed\"><parent "
           "link=\"puck\"/><child link=\"tool\"/><origin " +
           origin + "/></joint></robot>";
  };
  const ImportOptions massless = welding({"massless"});
  CHECK_THAT(imported(puck("xyz=\"0 0 1\"", "1", "0"), massless), !Contains("j_angle"));
  CHECK_THAT(imported(puck("xyz=\"0.1 0 1\"", "1", "0"), massless), Contains("j_angle"));
  CHECK_THAT(imported(puck("rpy=\"1 0 0\"", "1", "0"), massless), Contains("j_angle"));
  CHECK_THAT(imported(puck("xyz=\"0 0 1\"", "1", "2"), massless), Contains("j_angle"));
}

TEST_CASE("errors for joints that cannot be chosen") {
  CHECK(import_messages(crane(), keeping("ab,bd")) ==
        "E821 1:4 the robot has no joint `bd` | did you mean `bc`?\n");
  CHECK(import_messages(crane(), keeping("ab,ab")) == "E821 1:4 `ab` is named twice\n");
  CHECK(import_messages(crane(), keeping("cd")) ==
        "E821 1:1 `cd` mimics `ab` | it moves with `ab`\n");
  CHECK(import_messages(crane(), welding({"ab", "ab"})) == "E821 1:1 `ab` is welded\n");
  CHECK(import_messages(crane(), welding({"ab=x"})) == "E804 1:4 `x` is not a decimal number\n");
  CHECK(import_messages(arm_on("fixed", ""), welding({"j"})) == "E821 1:1 `j` is fixed\n");
  CHECK(import_messages(arm_on("floating", ""), welding({"j=1"})) ==
        "E821 1:3 `j` is floating, so it can be fixed only at 0\n");
}

TEST_CASE("a joint with an invalid mimic may be held") {
  const std::string text = arm_on("revolute", "<mimic joint=\"k\"/>");
  CHECK_THAT(import_messages(text), Contains("E812"));
  CHECK_THAT(import_messages(text, welding({"j"})), !Contains("E812"));
}

TEST_CASE("welded floating and planar joints are fixed") {
  for (const std::string type : {"floating", "planar"}) {
    const std::string model = imported(arm_on(type, ""), welding({"j"}));
    CHECK(after(model, "#       arm  ") == "j, " + type + ", welded at 0");
  }
}

TEST_CASE("a robot of one link is a free body") {
  const std::string text =
      "<robot name=\"r\"><link name=\"drone\">" + flying_body + "</link></robot>";
  CHECK(import_messages(text) == "E818 1:29 `drone` floats | no joint of the robot moves\n");
  const std::string model = imported(text);
  CHECK(after(model, "#   world    ") == "the world");
  CHECK(after(model, "#     drone  ") == "base, floating");
  CHECK_THAT(model, Contains("name  = \"base_x\"\nunit  = \"m\"\n"));
  CHECK_THAT(model, Contains("name  = \"base_attitude\"\nkind  = \"rotation\"\n"));
  CHECK_THAT(model,
             Contains("parent    = \"world\"\ntranslate = [\"base_x\", \"base_y\", \"base_z\"]\n"
                      "rotation  = \"base_attitude\"\n"));
  CHECK_THAT(model, Contains("[[body]]\nname    = \"drone\""));
}

TEST_CASE("a robot with only fixed joints is a free body") {
  const std::string text =
      "<robot name=\"r\"><link name=\"base\"/><link name=\"world\">" + flying_body +
      "</link>\n<joint name=\"base\" type=\"fixed\"><parent link=\"base\"/><child "
      "link=\"world\"/></joint></robot>";
  const std::string model = imported(text);
  CHECK(after(model, "#   world_2    ") == "the world");
  CHECK(after(model, "#     base     ") == "base_2, floating");
  CHECK_THAT(model, Contains("[[body]]\nname    = \"link_world\""));
}

TEST_CASE("a base floats if requested") {
  ImportOptions options;
  options.floating_base = true;
  const std::string model = imported(arm_on("revolute", ""), options);
  CHECK(model.find("base_attitude") < model.find("name = \"j\""));
  CHECK_THAT(model, Contains("name      = \"base\"\nparent    = \"world\""));
  CHECK(import_messages(arm_on("floating", ""), options) ==
        "E821 4:16 `j` floats already | omit `--floating-base`\n");
}

TEST_CASE("a robot without mass does not float") {
  CHECK(import_messages("<robot name=\"r\"><link name=\"a\"/></robot>") ==
        "E803 1:2 no link of `<robot>` has a `<mass>`\n");
}

}  // namespace elgen::test
