// The code table, order and exit codes of diagnostics.
#include "elgen/diagnostic.hpp"

#include <catch2/catch.hpp>
#include <set>

using namespace elgen;

TEST_CASE("codes are unique, ordered and explained") {
  std::string_view before;
  for (const CodeRow& row : code_table()) {
    INFO(row.name);
    CHECK(before < row.name);
    CHECK_FALSE(row.title.empty());
    CHECK(row.explanation.back() == '.');
    CHECK(find_code(row.name) == &row);
    CHECK(&code_row(row.code) == &row);
    CHECK((row.severity == Severity::error) == (row.exit_code != ExitCode::success));
    before = row.name;
  }
  CHECK(find_code("E000") == nullptr);
}

TEST_CASE("only errors count as errors, and the worst gives the exit code") {
  const Diagnostics warnings{{Code::E511, {}, "w"}, {Code::E520, {}, "n"}};
  CHECK_FALSE(has_errors(warnings));
  CHECK(exit_code(warnings) == ExitCode::success);
  const Diagnostics mixed{{Code::E511, {}, "w"}, {Code::E201, {}, "a"}, {Code::E908, {}, "b"}};
  CHECK(has_errors(mixed));
  CHECK(exit_code(mixed) == ExitCode::limit);
}

TEST_CASE("sorting goes by place, the command line last, and drops repeats") {
  const SourcePointer file = make_source("m.toml", "0123456789");
  const SourcePointer words = make_source("command line", "0123456789");
  Diagnostics list{{Code::E606, {words.get(), 0, 1}, "option"},
                   {Code::E201, {file.get(), 5, 6}, "second"},
                   {Code::E201, {file.get(), 5, 6}, "second"},
                   {Code::E301, {file.get(), 2, 3}, "first"}};
  sort_by_position(list);
  REQUIRE(list.size() == 3);
  CHECK(list[0].message == "first");
  CHECK(list[1].message == "second");
  CHECK(list[2].message == "option");
}

TEST_CASE("a result is a value, errors, or a value with warnings") {
  const Result<int> value(3);
  const Result<int> failed(Diagnostic{Code::E912, {}, "x"});
  const Result<int> both(4, {{Code::E511, {}, "w"}});
  CHECK(value);
  CHECK_FALSE(failed);
  CHECK(*both == 4);
  CHECK(both.diagnostics.size() == 1);
}
