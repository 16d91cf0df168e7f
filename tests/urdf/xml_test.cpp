// XML with places: every name and value where it stands, and what is no XML.
#include "urdf/xml.hpp"

#include <catch2/catch.hpp>

#include "urdf/urdf_testing.hpp"

namespace elgen::test {

namespace {

std::string xml_messages(const std::string& text) {
  const SourcePointer source = make_source("r.urdf", text);
  return messages(urdf::read_xml(*source).diagnostics);
}

/// Every span of the tree covers what it says.
void check_spans(const urdf::Element& element) {
  CHECK(covered_text(element.span) == element.name);
  for (const urdf::Attribute& attribute : element.attributes) {
    CHECK(covered_text(attribute.name_span) == attribute.name);
    CHECK(covered_text(attribute.span) == attribute.value);
  }
  for (const urdf::Element& child : element.children) check_spans(child);
}

}  // namespace

TEST_CASE("places are exact: several elements on a line, comments, line ends, byte order mark") {
  for (const std::string start :
       {"", "<?xml version=\"1.0\"?>\r\n", "\xEF\xBB\xBF", "\xEF\xBB\xBF<?xml version=\"1.0\"?>",
        "<!-- <robot name=\"r\"> -->\n", "\n <!DOCTYPE robot>", "  \n"}) {
    INFO(start);
    check_spans(xml_of(start +
                       "<robot name='r'>\r\n  <a x=\"1\"/><a x = \"1\"/> <!-- <a x=\"2\"/> -->"
                       "<![CDATA[ <a x=\"3\"/> ]]>\n<a\n  x=\"4\n 5\"><a x=\">\"/></a></robot>"));
  }
}

TEST_CASE("a value with entities spans what is written") {
  const urdf::Element root = xml_of("<robot name=\"a&amp;b\" x='\"'/>");
  CHECK(root.attributes[0].value == "a&b");
  CHECK(covered_text(root.attributes[0].span) == "a&amp;b");
  CHECK(covered_text(root.attributes[1].span) == "\"");
}

TEST_CASE("what is no XML is answered at its line") {
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

TEST_CASE("bytes that are no text are answered at their place") {
  CHECK(xml_messages("<robot>\n \xFF</robot>") == "E110 2:2 the file is not UTF-8 text\n");
  CHECK(xml_messages(std::string("<robot/>\n\0", 10)) == "E801 2:1 not XML: a byte is zero\n");
}

TEST_CASE("attributes of one element have an end, those of many have none") {
  std::string attributes;
  for (int i = 0; i < 1000; ++i) attributes += " a" + std::to_string(i) + "='='";
  const std::string element = "<a" + attributes + "/>";
  const std::string comment = "<!--" + std::string(2000, '=') + "-->";
  CHECK(xml_messages("<r>" + comment + element + element + "</r>").empty());
  CHECK(xml_messages("<r>" + comment + "\n<a" + attributes + " b='1'/></r>")
            .find("an element has more than 1000 attributes") != std::string::npos);
}

TEST_CASE("nesting has an end") {
  std::string text;
  for (int i = 0; i < 200; ++i) text += "<a>\n";
  CHECK(xml_messages(text).find("not XML: elements are nested more than 100 deep") !=
        std::string::npos);
}

}  // namespace elgen::test
