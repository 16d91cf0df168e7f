// page_data: what is empty is absent, every text is written in the words of its language.
#include "render/page_data.hpp"

#include <catch2/catch.hpp>

#include "render/small_sheet.hpp"

using namespace elgen;
using namespace elgen::testing;

namespace {

std::string starred(const std::string& text) { return "*" + text; }
std::string left_of(const Display& display) { return display.left; }

constexpr PageWords words{unchanged, starred, starred, left_of};

}  // namespace

TEST_CASE("sections of what is empty are absent") {
  const TemplateData data = page_data(small_sheet(), words);
  CHECK(data.get("description")->list_value().at(0).get("line")->string_value() ==
        "100 % of x < y");
  for (const char* const name : {"reference", "notes", "coordinates", "inputs"}) {
    CHECK(data.get(name)->is_empty_list());
  }
}

TEST_CASE("prose, names, formulas and equations have words of their own") {
  const TemplateData data = page_data(small_sheet(), words);
  CHECK(data.get("equation_of_motion")->string_value() == "*M \\ddot{q} = 0");
  const TemplateData row =
      data.get("parameters")->list_value().at(0).get("rows")->list_value().at(0);
  CHECK(row.get("symbol")->string_value() == "*m_{1}");
  CHECK(row.get("name")->string_value() == "*m1");
  CHECK(row.get("unit")->string_value() == "kg");
  const TemplateData output = data.get("outputs")->list_value().at(0);
  CHECK(output.get("title")->string_value() == "Gravity");
  CHECK(output.get("function")->list_value().front().get("line")->string_value() == "*gravity");
  CHECK(output.get("definition")->is_empty_list());
  CHECK(output.get("equations")->list_value().at(0).get("line")->string_value() == "g");
}
