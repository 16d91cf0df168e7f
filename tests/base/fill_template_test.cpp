// fill_template: every hole needs a value, and values are not escaped. Templates are found by their
// paths.
#include "base/fill_template.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <stdexcept>

#include "elgen/templates.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("a template without holes yields its text without the licence comment") {
  const std::string text(embedded_template("cpp/kinked.hpp.mustache"));
  const std::string comment = "{{! SPDX-License-Identifier: 0BSD\n}}";
  REQUIRE(starts_with(text, comment));
  CHECK(fill_template("cpp/kinked.hpp.mustache", TemplateData()) == text.substr(comment.size()));
}

TEST_CASE("every template has a licence, in its output or in its first comment") {
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(ELGEN_SOURCE_DIR "/templates")) {
    if (entry.path().extension() != ".mustache") continue;
    INFO(entry.path());
    CHECK(mentions(read_text(entry.path()), " SPDX-License-Identifier: 0BSD\n"));
  }
}

TEST_CASE("values are not escaped") {
  CHECK_FALSE(mentions(fill_template("cpp/kinked.hpp.mustache", TemplateData()), "&lt;"));
}

TEST_CASE("a hole without a value or an unknown template throws logic_error") {
  CHECK_THROWS_AS(fill_template("cpp/constant.hpp.mustache", TemplateData()), std::logic_error);
  CHECK_THROWS_AS(fill_template("cpp/none.mustache", TemplateData()), std::logic_error);
}

TEST_CASE("a template includes another template of its folder without the final line end") {
  TemplateData data;
  for (const char* const name :
       {"header", "namespace", "storage", "order", "generated", "model_hash", "scene_hash",
        "body_hash", "function", "workspace", "types"}) {
    data.set(name, name);
  }
  const TemplateData none = optional_section(false);
  for (const char* const name : {"struct", "values", "part", "regular"}) data.set(name, none);
  TemplateData function;
  for (const char* const name : {"summary", "signature", "body"}) function.set(name, name);
  function.set("parts", optional_section(true));
  data.set("functions", optional_section(true, function));
  const std::string text = fill_template("cpp/eigen.hpp.mustache", data);
  CHECK(mentions(text, "/// Values that several parts of function use.\n"));
  CHECK(mentions(text, "}  // namespace detail\n\n/// summary\n"));
}

TEST_CASE("lines and optional sections") {
  CHECK(lines_section({"a", "b"}).list_value().size() == 2);
  CHECK(lines_section({"a"}).list_value()[0].get("line")->string_value() == "a");
  CHECK(optional_section(false).is_empty_list());
  CHECK(optional_section(true).is_non_empty_list());
}

TEST_CASE("an unknown template is embedded as empty text, and looking it up throws") {
  CHECK(require_template("cpp/kinked.hpp.mustache") ==
        embedded_template("cpp/kinked.hpp.mustache"));
  CHECK(embedded_template("cpp/none.mustache").empty());
  CHECK_THROWS_AS(require_template("cpp/none.mustache"), std::logic_error);
}

TEST_CASE("a template is found by name in the folder and language of another") {
  CHECK(partial_path("cpp/header.hpp.mustache", "kinked") == "cpp/kinked.hpp.mustache");
  CHECK(partial_path("c99/header.h.mustache", "function") == "c99/function.h.mustache");
}
