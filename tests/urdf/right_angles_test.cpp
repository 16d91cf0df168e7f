// note_right_angles: how far poses change where angles are taken for right ones.
#include <catch2/catch.hpp>

#include "urdf/urdf_testing.hpp"

namespace elgen::test {

namespace {

/// The arm's centre of mass is 0.1 m from its origin, which is 2 m from the base.
std::string bent(const std::string& rpy, const std::string& axis = "0 0 1") {
  return arm_on("revolute",
                "<origin xyz=\"0 2 0\" rpy=\"" + rpy + "\"/><axis xyz=\"" + axis + "\"/>");
}

}  // namespace

TEST_CASE("one note counts the angles and bounds the change of every pose") {
  CHECK(import_messages(bent("1.570796 0 0")) ==
        "E819 1:2 1 angle is taken for right ones: no pose changes by more than 3.3e-07 rad and "
        "3.3e-08 m | `--exact-angles` keeps their digits\n");
  CHECK(import_messages(bent("1.570796 0 3.141593", "0 1e-6 1")) ==
        "E819 1:2 3 angles are taken for right ones: no pose changes by more than 1.7e-06 rad and "
        "1.7e-07 m | `--exact-angles` keeps their digits\n");
}

TEST_CASE("where all is as in the file nothing is said") {
  CHECK(import_messages(bent("0 0.3 0")).empty());
  ImportOptions options;
  options.exact_angles = true;
  CHECK(import_messages(bent("1.570796 0 0"), options).empty());
  CHECK(after(imported(bent("1.570796 0 0"), options), "rotate    = ") ==
        "[[\"x\", \"1.570796\"], [\"z\", \"j\"]]");
}

}  // namespace elgen::test
