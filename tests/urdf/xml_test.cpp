// XML: elements and attributes with their positions, and the functions that read them.
#include "urdf/xml.hpp"

#include <catch2/catch.hpp>

#include "support/text.hpp"
#include "urdf/element_reader.hpp"
#include "urdf/urdf_testing.hpp"

namespace elgen::test {

namespace {

std::string xml_messages(const std::string& text) {
  const SourcePointer source = make_source("r.urdf", text);
  return messages(urdf::read_xml(*source).diagnostics);
}

/// Checks that every span of the tree covers its text.
void check_spans(const urdf::Element& element) {
  CHECK(covered_text(element.span) == element.name);
  for (const urdf::Attribute& attribute : element.attributes) {
    CHECK(covered_text(attribute.name_span) == attribute.name);
    CHECK(covered_text(attribute.span) == attribute.value);
  }
  for (const urdf::Element& child : element.children) check_spans(child);
}

/// Reads `<e …>` with a function and returns the messages.
template <class Read>
std::string reader_messages(const std::string& text, const Read& read) {
  const urdf::Element element = xml_of(text);
  Diagnostics found;
  const Limits limits;
  urdf::RobotReadState reading{limits, found};
  urdf::ElementReader reader(element, reading);
  read(reader);
  reader.report_unread();
  return messages(found);
}

}  // namespace

TEST_CASE("positions are exact: several elements per line, comments, line ends, byte order mark") {
  for (const std::string start :
       {"", "<?xml version=\"1.0\"?>\r\n", "\xEF\xBB\xBF", "\xEF\xBB\xBF<?xml version=\"1.0\"?>",
        "<!-- <robot name=\"r\"> -->\n", "\n <!DOCTYPE robot>", "  \n"}) {
    INFO(start);
    check_spans(xml_of(start +
                       "<robot name='r'>\r\n  <a x=\"1\"/><a x = \"1\"/> <!-- <a x=\"2\"/> -->"
                       "<![CDATA[ <a x=\"3\"/> ]]>\n<a\n  x=\"4\n 5\"><a x=\">\"/></a></robot>"));
  }
}

TEST_CASE("a value with entities spans the written text") {
  const urdf::Element root = xml_of("<robot name=\"a&amp;b\" x='\"'/>");
  CHECK(root.attributes[0].value == "a&b");
  CHECK(covered_text(root.attributes[0].span) == "a&amp;b");
  CHECK(covered_text(root.attributes[1].span) == "\"");
}

TEST_CASE("invalid XML is reported at its line") {
  CHECK(xml_messages("") == "E801 1:1 not XML: the file has no element\n");
  CHECK(xml_messages("<!-- nothing -->") == "E801 1:1 not XML: the file has no element\n");
  CHECK(xml_messages("<robot>\n  <link>\n</robot>") ==
        "E801 2:3 not XML: an element is not closed by its own name\n");
  CHECK(xml_messages("<robot>\n  <link name=base/>\n</robot>") ==
        "E801 2:3 not XML: an attribute is not written `name=\"value\"`\n");
  CHECK(xml_messages("<robot/>\n <robot/>") ==
        "E801 2:2 not XML: something follows or precedes the root element\n");
  CHECK(xml_messages("format = 1\n<robot/>") ==
        "E801 1:1 not XML: something follows or precedes the root element\n");
  CHECK(xml_messages("<robot>\n<!-- </robot>") == "E801 2:1 not XML: a comment has no end\n");
}

TEST_CASE("bytes that are not UTF-8 are reported at their position") {
  CHECK(xml_messages("<robot>\n \xFF</robot>") == "E110 2:2 the file is not UTF-8 text\n");
  CHECK(xml_messages(std::string("<robot/>\n\0", 10)) == "E801 2:1 not XML: a byte is zero\n");
}

TEST_CASE("the attributes of one element are limited, the attributes of a file are not") {
  std::string attributes;
  for (int i = 0; i < 1000; ++i) attributes += " a" + std::to_string(i) + "='='";
  const std::string element = "<a" + attributes + "/>";
  const std::string comment = "<!--" + std::string(2000, '=') + "-->";
  CHECK(xml_messages("<r>" + comment + element + element + "</r>").empty());
  CHECK(mentions(xml_messages("<r>" + comment + "\n<a" + attributes + " b='1'/></r>"),
                 "an element has more than 1000 attributes"));
}

TEST_CASE("nesting is limited") {
  std::string text;
  for (int i = 0; i < 200; ++i) text += "<a>\n";
  CHECK(mentions(xml_messages(text), "not XML: elements are nested more than 100 deep"));
}

TEST_CASE("a missing required attribute or element is an error at the element") {
  CHECK(reader_messages("<e/>", [](auto& reader) { (void)reader.require_text("name"); }) ==
        "E803 1:2 `<e>` has no attribute `name`\n");
  CHECK(reader_messages("<e name=''/>", [](auto& reader) { (void)reader.require_text("name"); }) ==
        "E803 1:2 `<e>` has no attribute `name`\n");
  CHECK(reader_messages("<e/>", [](auto& reader) { (void)reader.require_number("m"); }) ==
        "E803 1:2 `<e>` has no attribute `m`\n");
  CHECK(reader_messages("<e/>", [](auto& reader) { reader.require_child("f", [](auto&) {}); }) ==
        "E803 1:2 `<e>` has no element `f`\n");
}

TEST_CASE("numbers are counted, and refused at their position") {
  CHECK(reader_messages("<e m='1 2'/>", [](auto& reader) {
          CHECK_FALSE(reader.read_number("m"));
        }) == "E805 1:7 2 numbers, but `m` is one number\n");
  urdf::Vector vector;
  CHECK(reader_messages("<e v='1'/>", [&](auto& reader) {
          CHECK_FALSE(reader.read_vector("v", vector));
        }) == "E805 1:7 1 number, but `v` has 3\n");
  CHECK(reader_messages("<e v='1 a b'/>", [&](auto& reader) {
          CHECK_FALSE(reader.read_vector("v", vector));
        }) == "E804 1:9 `a` is not a decimal number\nE804 1:11 `b` is not a decimal number\n");
  CHECK(reader_messages("<e/>", [&](auto& reader) {
          CHECK_FALSE(reader.read_vector("v", vector));
        }).empty());
}

TEST_CASE("the outermost unread element gives a note, ignored ones give none") {
  CHECK(reader_messages("<e a='1' b='2' xmlns:c='d'><f/><g><h/></g><f/></e>",
                        [](auto& reader) {
                          (void)reader.read_text("a");
                          reader.read_child("f", [](auto&) {});
                        }) ==
        "E815 1:10 attribute `b` of `<e>` is not imported\n"
        "E815 1:33 `<g>` in `<e>` is not imported\n"
        "E815 1:44 `<f>` in `<e>` is not imported\n");
  CHECK(reader_messages("<e a='1'><f/><f/></e>", [](auto& reader) {
          reader.ignore({"a", "f"});
        }).empty());
  CHECK(reader_messages("<e><f/><f/></e>", [](auto& reader) {
          CHECK(reader.take_children("f").size() == 2);
        }).empty());
}

TEST_CASE("an origin defaults to zero") {
  const urdf::Element element = xml_of("<e><origin rpy='0 0 1'/></e>");
  Diagnostics found;
  const Limits limits;
  urdf::RobotReadState reading{limits, found};
  urdf::ElementReader reader(element, reading);
  const urdf::Pose pose = urdf::read_origin(reader);
  CHECK(pose.xyz[2].is_zero());
  CHECK(pose.rpy[2].text == "1");
  CHECK(found.empty());
}

}  // namespace elgen::test
