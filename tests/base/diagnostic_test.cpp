// Diagnostics: the table of codes, order, positions and exit codes.
#include "elgen/diagnostic.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "base/ascii.hpp"
#include "base/reason.hpp"
#include "elgen/source_text.hpp"
#include "support/text.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

constexpr std::pair<Code, std::string_view> reason_ids[]{
#define ELGEN_REASON(code, id, text) {Code::code, #id},
#include "base/error_reasons.def"
#undef ELGEN_REASON
};

/// The identifiers that follow `prefix` in the sources of elgen.
std::set<std::string> words_behind(const std::string& prefix) {
  std::set<std::string> words;
  const std::string folder = std::string(ELGEN_SOURCE_DIR) + "/src";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
    const std::string text = read_text(entry.path());
    for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at)) {
      at += prefix.size();
      const auto first = text.begin() + static_cast<std::ptrdiff_t>(at);
      words.emplace(first, std::find_if_not(first, text.end(), is_word_character));
    }
  }
  return words;
}

}  // namespace

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

// Each call site of a code with reasons names a reason, so that `elgen explain` covers the site.
TEST_CASE("every reason has a call site, and every call site of its code a reason") {
  const std::set<std::string> reasons = words_behind("Reason::");
  const std::set<std::string> codes = words_behind("Code::");
  for (const auto& [code, id] : reason_ids) {
    INFO(id);
    CHECK(reasons.contains(std::string(id)));
    CHECK_FALSE(codes.contains(std::string(code_row(code).name)));
  }
  for (const CodeRow& row : code_table()) {
    for (const std::string_view text : reasons_of(row.code)) CHECK(text.back() == '.');
  }
}

TEST_CASE("only errors count as errors, and the most severe one gives the exit code") {
  const Diagnostics warnings{{Code::E511, {}, "w"}, {Code::E520, {}, "n"}};
  CHECK_FALSE(has_errors(warnings));
  CHECK(exit_code(warnings) == ExitCode::success);
  const Diagnostics mixed{{Code::E511, {}, "w"}, {Code::E201, {}, "a"}, {Code::E908, {}, "b"}};
  CHECK(has_errors(mixed));
  CHECK(exit_code(mixed) == ExitCode::limit);
}

TEST_CASE("diagnostics are sorted by position, the command line last, without duplicates") {
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

TEST_CASE("columns count code points, not bytes") {
  const SourcePointer source = make_source("a.toml", "x = 1\nθ = \"π\" # end\n");
  CHECK(line_column(*source, 0).line == 1);
  const auto hash = static_cast<std::uint32_t>(source->text.find('#'));
  CHECK(line_column(*source, hash).line == 2);
  CHECK(line_column(*source, hash).column == 9);
}

TEST_CASE("offsets at and beyond the end of the text have a position") {
  const SourcePointer source = make_source("a.toml", "ab\n");
  CHECK(line_column(*source, 3).line == 2);
  CHECK(line_column(*source, 99).line == 2);
  CHECK(line_column(*source, 99).column == 1);
}

TEST_CASE("lines exclude their line ends, LF or CRLF") {
  const SourcePointer source = make_source("a.toml", "one\r\ntwo\nthree");
  CHECK(line_text(*source, 1) == "one");
  CHECK(line_text(*source, 2) == "two");
  CHECK(line_text(*source, 3) == "three");
}

TEST_CASE("the name of a file is the last part of its path") {
  CHECK(file_name(*make_source("models/a.toml", "")) == "a.toml");
  CHECK(file_name(*make_source("a.toml", "")) == "a.toml");
}

TEST_CASE("a span covers its bytes, and is empty without a source") {
  const SourcePointer source = make_source("a.toml", "abcdef");
  CHECK(covered_text({source.get(), 2, 4}) == "cd");
  CHECK(covered_text({}).empty());
}

TEST_CASE("a byte order mark is neither a column nor part of the first line") {
  const SourcePointer source = make_source("a.toml", "\xEF\xBB\xBFx = 1\ny = 2\n");
  CHECK(line_column(*source, 3).column == 1);
  CHECK(line_column(*source, 5).column == 3);
  CHECK(line_text(*source, 1) == "x = 1");
  CHECK(line_text(*source, 2) == "y = 2");
}
