// Spelling of functions in interpreted languages: a function of the library or of the module.
#include <catch2/catch.hpp>

#include "emit/source/source_dialect.hpp"

namespace elgen::test {

namespace {

const SourceSpelling& javascript = source_spelling(LanguageId::javascript);

std::string name_in(const SourceSpelling& spelling, FunctionId function, std::string_view name) {
  return std::string(function_spelling(spelling, function, name).value().name);
}

}  // namespace

TEST_CASE("functions of a library are named as in C, or by a row of the table") {
  const SourceSpelling& python = source_spelling(LanguageId::python);
  CHECK(name_in(python, FunctionId::log1p, "log1p") == "log1p");
  CHECK(name_in(python, FunctionId::abs, "abs") == "fabs");
  CHECK(name_in(javascript, FunctionId::abs, "abs") == "abs");
  CHECK(library_function_spelling(python, "abs") == "fabs");
  CHECK(library_function_spelling(python, "sqrt") == "sqrt");
}

TEST_CASE("a function that the library lacks has no name, or a name in the module") {
  SourceSpelling older = javascript;
  older.functions = " exp expm log ";
  CHECK_FALSE(function_spelling(older, FunctionId::expm1, "expm1", {}).has_value());
  const std::vector<FunctionSpelling> rows{
      {LanguageId::matlab, FunctionId::expm1, "of_matlab", FunctionProvider::library},
      {LanguageId::javascript, FunctionId::expm1, "less_one", FunctionProvider::module}};
  const auto written = function_spelling(older, FunctionId::expm1, "expm1", rows);
  REQUIRE(written);
  CHECK(written->name == "less_one");
  CHECK(written->provider == FunctionProvider::module);
  // A row takes precedence over the library, whose function of this name may differ.
  CHECK(function_spelling(javascript, FunctionId::expm1, "expm1", rows)->name == "less_one");
}

TEST_CASE("every interpreted language writes every function that C has") {
  for (const SourceSpelling& spelling : spelling_table) {
    CHECK(has_word(spelling.functions, "sqrt"));
    for (const FunctionRow& row : function_table()) {
      INFO(language_row(spelling.language).name << " " << row.name);
      const bool is_own = !row.own_name.empty();
      CHECK((is_own || function_spelling(spelling, row.id, row.name)));
    }
  }
}

}  // namespace elgen::test
