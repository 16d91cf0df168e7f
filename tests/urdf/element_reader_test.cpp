// ElementReader: what is missing, what is malformed, and what nobody asked for.
#include "urdf/element_reader.hpp"

#include <catch2/catch.hpp>

#include "urdf/urdf_testing.hpp"

namespace elgen::test {

namespace {

/// Reads `<e …>` by a function, and returns what was said.
template <class Read>
std::string said_by(const std::string& text, const Read& read) {
  const urdf::Element element = xml_of(text);
  Diagnostics found;
  const Limits limits;
  urdf::RobotReading reading{limits, found};
  urdf::ElementReader reader(element, reading);
  read(reader);
  reader.note_the_rest();
  return messages(found);
}

}  // namespace

TEST_CASE("what is required and missing is an error at the element") {
  CHECK(said_by("<e/>", [](auto& reader) { (void)reader.required_text("name"); }) ==
        "E803 1:2 `<e>` has no attribute `name`\n");
  CHECK(said_by("<e name=''/>", [](auto& reader) { (void)reader.required_text("name"); }) ==
        "E803 1:2 `<e>` has no attribute `name`\n");
  CHECK(said_by("<e/>", [](auto& reader) { (void)reader.required_number("m"); }) ==
        "E803 1:2 `<e>` has no attribute `m`\n");
  CHECK(said_by("<e/>", [](auto& reader) { reader.required_child("f", [](auto&) {}); }) ==
        "E803 1:2 `<e>` has no element `f`\n");
}

TEST_CASE("numbers are counted, and refused at their place") {
  CHECK(said_by("<e m='1 2'/>", [](auto& reader) { CHECK_FALSE(reader.number("m")); }) ==
        "E805 1:7 2 numbers, but `m` is one number\n");
  urdf::Vector vector;
  CHECK(said_by("<e v='1'/>", [&](auto& reader) { CHECK_FALSE(reader.vector("v", vector)); }) ==
        "E805 1:7 1 number, but `v` has 3\n");
  CHECK(said_by("<e v='1 a b'/>", [&](auto& reader) { CHECK_FALSE(reader.vector("v", vector)); }) ==
        "E804 1:9 `a` is not a decimal number\nE804 1:11 `b` is not a decimal number\n");
  CHECK(said_by("<e/>", [&](auto& reader) { CHECK_FALSE(reader.vector("v", vector)); }).empty());
}

TEST_CASE("what nobody took is noted, outermost alone, what is ignored is not") {
  CHECK(said_by("<e a='1' b='2' xmlns:c='d'><f/><g><h/></g><f/></e>",
                [](auto& reader) {
                  (void)reader.text("a");
                  reader.child("f", [](auto&) {});
                }) ==
        "E815 1:10 attribute `b` of `<e>` is not imported\n"
        "E815 1:33 `<g>` in `<e>` is not imported\n"
        "E815 1:44 `<f>` in `<e>` is not imported\n");
  CHECK(said_by("<e a='1'><f/><f/></e>", [](auto& reader) { reader.ignore({"a", "f"}); }).empty());
  CHECK(said_by("<e><f/><f/></e>", [](auto& reader) {
          CHECK(reader.children("f").size() == 2);
        }).empty());
}

TEST_CASE("an origin is zero where it is not given") {
  const urdf::Element element = xml_of("<e><origin rpy='0 0 1'/></e>");
  Diagnostics found;
  const Limits limits;
  urdf::RobotReading reading{limits, found};
  urdf::ElementReader reader(element, reading);
  const urdf::Pose pose = urdf::read_origin(reader);
  CHECK(pose.xyz[2].is_zero());
  CHECK(pose.rpy[2].text == "1");
  CHECK(found.empty());
}

}  // namespace elgen::test
