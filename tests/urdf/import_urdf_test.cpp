// import_urdf: whole robots to whole models, byte by byte, and all mistakes of a file in one run.
// ELGEN_UPDATE=1 rewrites golden/; the difference is then reviewed.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "elgen/syntax.hpp"
#include "support/shell.hpp"
#include "urdf/urdf_testing.hpp"

namespace elgen::test {

namespace {

const std::string folder = std::string(ELGEN_SOURCE_DIR) + "/tests/urdf/";

std::string imported_file(const std::string& name) {
  const std::string path = folder + "robots/" + name + ".urdf";
  const SourcePointer source = make_source(path, read_text(path));
  const Result<ImportedModel> model = import_urdf(source, {});
  INFO(format(model.diagnostics));
  REQUIRE(model);
  return model.value->text;
}

}  // namespace

TEST_CASE("robots become the models that were reviewed") {
  for (const std::string name : {"panda_like", "ur5_like", "quadruped", "humanoid", "gripper"}) {
    INFO(name);
    const std::string model = imported_file(name);
    const std::string golden = folder + "golden/" + name + ".toml";
    if (std::getenv("ELGEN_UPDATE") != nullptr) write_text(golden, model);
    CHECK(model == read_text(golden));
  }
}

TEST_CASE("an imported model is a model file, in which every number is as written") {
  const std::string model = imported_file("panda_like");
  const SourcePointer source = make_source("panda.toml", model);
  const Result<FileSyntax> syntax = parse_model(source, {});
  INFO(format(syntax.diagnostics));
  CHECK(syntax);
  CHECK(after(model, "m_panda_link1 ") ==
        "  = { value = 4.970684,  unit = \"kg\",     assume = \"positive\" }");
}

TEST_CASE("all mistakes of a file are told in one run, in its order") {
  CHECK(
      import_messages("<robot name=\"r\">\n"
                      "  <link name=\"a\" color=\"red\"/>\n"
                      "  <link name=\"a\"><inertial><mass value=\"x\"/></inertial></link>\n"
                      "  <joint name=\"j\" type=\"hinge\"><parent link=\"b\"/><child link=\"a\"/>\n"
                      "    <axis xyz=\"0 0\"/><origin xyz=\"1 2 inf\"/></joint>\n"
                      "</robot>\n") ==
      "E815 2:18 attribute `color` of `<link>` is not imported\n"
      "E807 3:15 `a` names two links\n"
      "E803 3:19 `<inertial>` has no element `inertia`\n"
      "E804 3:41 `x` is not a decimal number\n"
      "E806 4:25 `hinge` is no type of joint\n"
      "E808 4:46 the robot has no link `b`\n"
      "E804 5:39 `inf` is not finite\n");
}

TEST_CASE("a mistake does not bring about others: a joint without parent makes no second root") {
  std::string text = arm_on("revolute", "<axis xyz=\"0 x 0\"/>");
  text.replace(text.find("<parent link=\"base\"/>"), 21, "");
  CHECK(import_messages(text) ==
        "E803 4:4 `<joint>` has no element `parent`\n"
        "E804 5:14 `x` is not a decimal number\n");
}

TEST_CASE("notes and warnings do not keep a model from being made") {
  const SourcePointer source = make_source("r.urdf", arm_on("revolute", "<spring/>"));
  const Result<ImportedModel> model = import_urdf(source, {});
  CHECK(model);
  CHECK(messages(model.diagnostics) == "E815 5:2 `<spring>` in `<joint>` is not imported\n");
}

}  // namespace elgen::test
