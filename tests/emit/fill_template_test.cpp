// fill_template: strict holes, no escaping, no doubled blank lines; and every template is known by
// its path.
#include "emit/text/fill_template.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "elgen/templates.hpp"

using namespace elgen;

TEST_CASE("a template without holes is its own text") {
  CHECK(fill_template("cpp/kinked.hpp.mustache", TemplateData()) ==
        embedded_template("cpp/kinked.hpp.mustache"));
}

TEST_CASE("a section that is absent leaves no second blank line") {
  TemplateData data;
  data.set("filled", section_if(false));
  const std::string text = fill_template("cpp/constant.hpp.mustache", data);
  CHECK(text.find("\n\n\n") == std::string::npos);
  CHECK(text.find("filled") == std::string::npos);
  data.set("filled", section_if(true));
  CHECK(fill_template("cpp/constant.hpp.mustache", data).find("filled") != std::string::npos);
}

TEST_CASE("text is not escaped") {
  CHECK(fill_template("cpp/kinked.hpp.mustache", TemplateData()).find("&lt;") == std::string::npos);
}

TEST_CASE("a hole without a value and a template that is not there are mistakes of elgen") {
  CHECK_THROWS_AS(fill_template("cpp/constant.hpp.mustache", TemplateData()), std::logic_error);
  CHECK_THROWS_AS(fill_template("cpp/none.mustache", TemplateData()), std::logic_error);
}

TEST_CASE("lines and optional sections") {
  CHECK(lines_data({"a", "b"}).list_value().size() == 2);
  CHECK(lines_data({"a"}).list_value()[0].get("line")->string_value() == "a");
  CHECK(section_if(false).is_empty_list());
  CHECK(section_if(true).is_non_empty_list());
}
