// header_data: sections stand where they are needed.
#include "emit/code/header_data.hpp"

#include "emit/cpp/cpp_dialect.hpp"
#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole;
using elgen::testing::Subject;

TEST_CASE("sections for pivots and kinks, one item per function") {
  const Subject subject = cart_pole();
  const EmissionInput input = emission_input(subject.model, subject.scene, subject.program);
  const TemplateData data = header_data(input, *cpp_dialect(subject.model, subject.program));
  CHECK(data.get("regular")->list_value().size() == 1);
  CHECK(data.get("kinks")->list_value().empty());
  CHECK(data.get("functions")->list_value().size() == subject.program.functions.size());
  CHECK(data.get("coordinate_count")->string_value() == "2");
  CHECK(data.get("storage")->string_value() == "row-major");
}

TEST_CASE("a section that is absent leaves no second blank line") {
  TemplateData data;
  data.set("filled", section_if(false));
  const std::string text = header_text("cpp/constant.hpp.mustache", data);
  CHECK(text.find("\n\n\n") == std::string::npos);
  CHECK(text.find("filled") == std::string::npos);
  data.set("filled", section_if(true));
  CHECK(header_text("cpp/constant.hpp.mustache", data).find("filled") != std::string::npos);
}
