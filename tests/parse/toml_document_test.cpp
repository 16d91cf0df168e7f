// TOML trees: file order, the exact span of every key and value, and malformed files.
#include "parse/toml_document.hpp"

#include <rapidcheck.h>

#include <catch2/catch.hpp>

#include "parse_testing.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// Keys and values as written in the file, depth first.
std::string source_tokens(const TomlValue& value) {
  std::string result;
  for (const TomlEntry& entry : value.entries) {
    result += std::string(covered_text(entry.key_span)) + ":";
    result += std::string(covered_text(entry.value.span)) + ";" + source_tokens(entry.value);
  }
  for (const TomlValue& item : value.items) {
    result += std::string(covered_text(item.span)) + ";" + source_tokens(item);
  }
  return result;
}

std::string source_tokens(const std::string& text) {
  const SourcePointer source = make_source("test", text);
  const auto root = read_toml(*source);
  REQUIRE(root);
  return source_tokens(*root);
}

/// The message of the error, or "" if the file is read.
std::string toml_message(const std::string& text) {
  const SourcePointer source = make_source("test", text);
  const auto root = read_toml(*source);
  return root ? "" : root.diagnostics.at(0).message;
}

}  // namespace

TEST_CASE("entries come in file order", "[parse]") {
  CHECK(source_tokens("z = 1\na = 2\nm = 3\n") == "z:1;a:2;m:3;");
}

TEST_CASE("the spans of values and keys cover their source text", "[parse]") {
  CHECK(source_tokens("a = [ 1, \"two\",\n  +1_0.5 ]") ==
        "a:[ 1, \"two\",\n  +1_0.5 ];1;\"two\";+1_0.5;");
  CHECK(source_tokens("\"a b\" = { c = true, d.e = 'x' }") ==
        "\"a b\":{ c = true, d.e = 'x' };c:true;d:d;e:'x';");
  CHECK(source_tokens("d = \"\u03C0\" # c\r\ne = 1979-05-27\r\n") == "d:\"\u03C0\";e:1979-05-27;");
  CHECK(source_tokens("\xEF\xBB\xBF"
                      "a = 1\nb = 2") == "a:1;b:2;");
}

TEST_CASE("the span of a table is its header", "[parse]") {
  CHECK(source_tokens("[p.m]\nv = 1\n[p]\nq = 2\n") == "p:[p];m:[p.m];v:1;q:2;");
  const SourcePointer source = make_source("test", "[[c]]\na = 1\n\n  [[c]]\na = 2\n");
  const auto root = read_toml(*source);
  REQUIRE(root);
  const TomlValue& array = root->entries.at(0).value;
  CHECK(covered_text(array.items.at(0).span) == "[[c]]");
  CHECK(array.items.at(1).span.begin == 15);
}

TEST_CASE("numbers are distinguished from values that only resemble numbers", "[parse]") {
  const SourcePointer source = make_source(
      "test", "a = -1_0.5e+3\nb = +0\nc = 0x1E\nd = inf\ne = -nan\nf = 1979-05-27\ng = 0b1\n");
  const auto root = read_toml(*source);
  REQUIRE(root);
  for (std::size_t i = 0; i < 7; ++i) {
    CHECK(root->entries.at(i).value.kind == (i < 2 ? TomlKind::number : TomlKind::other));
  }
}

TEST_CASE("random files give a tree or one error inside the file", "[parse]") {
  CHECK(rc::check("random files", [] {
    const auto pieces = rc::gen::element<std::string>(
        "a", "=", "1", "\"", "'", "\"\"\"", "[", "]", "[[", "]]", "{", "}", ",", ".", "\n", "\r\n",
        " ", "#", "\\", "\\u00e9", "\u03C0", "1e999", "inf", std::string(1, '\0'));
    std::string text;
    for (const auto& piece : *rc::gen::container<std::vector<std::string>>(pieces)) text += piece;
    const SourcePointer source = make_source("test", text);
    const auto root = read_toml(*source);
    RC_ASSERT(root || root.diagnostics.size() == 1);
    for (const Diagnostic& d : root.diagnostics) RC_ASSERT(d.span.end <= text.size());
  }));
}

TEST_CASE("malformed TOML is reported once, at its place", "[parse]") {
  struct Row {
    std::string input;
    std::string place;
    std::string message;
    std::string hint;
  };
  const std::string quotes = "texts and expressions are written in quotes";
  const std::string three = "a string over several lines has three quotes at each end";
  const std::string merge =
      "keep one version, and remove the lines `<<<<<<<`, `=======`, `>>>>>>>`";
  const auto row = GENERATE_COPY(values<Row>({
      {"a = 1\nb = \"x\nc = 3", "E101 2:7", "string is not closed", three},
      {"a = \"x", "E101 1:7", "string is not closed", three},
      {"a = 1/2", "E101 1:6", "expected digit, saw `/`", quotes},
      {"a = pi", "E101 1:5", "could not determine value type", quotes},
      {"a = 1\na = 2", "E101 2:1", "cannot redefine existing integer `a`", "rename one of them"},
      {"[a]\n[a]", "E101 2:1", "cannot redefine existing table `a`", "join the two tables"},
      {"[point]\n\n[point]", "E107 1:1", "`[point]` is the wrong kind of table",
       "write `[[point]]`"},
      {"[[point]]\n[point]", "E107 2:1", "`[point]` is the wrong kind of table",
       "write `[[point]]`"},
      {"a = 0,5", "E306 1:5", "`0,5` has a decimal comma", "write `0.5`"},
      {"a = { b = -10,25, c = 1 }", "E306 1:11", "`-10,25` has a decimal comma", "write `-10.25`"},
      {"a = { b = 1,5 }", "E306 1:11", "`1,5` has a decimal comma", "write `1.5`"},
      {"a = [1,2 3]", "E101 1:10", "expected comma or closing `]`, saw `3`", ""},
      {"a = 1\n<<<<<<< HEAD\na = 2", "E101 2:1", "a merge is not finished", merge},
      {"a = \"\n>>>>>>> main\n", "E101 2:1", "a merge is not finished", merge},
      {"a = \"\\dot{x}\"", "E101 1:7", "unknown escape sequence `\\d`",
       "a backslash is written twice; expressions have none: `dot(x)`, `theta`"},
      {"a = 1e400", "E109 1:5", "`1e400` is wider than TOML's numbers",
       "write it as a string, in quotes"},
      {"a = [-1e999, 2]", "E109 1:6", "`-1e999` is wider than TOML's numbers",
       "write it as a string, in quotes"},
      {"a = 12345678901234567890", "E109 1:5",
       "`12345678901234567890` is wider than TOML's numbers", "write it as a string, in quotes"},
  }));
  INFO(row.input);
  const SourcePointer source = make_source("test", row.input);
  const auto result = parse_model(source, {});
  CHECK(places(result.diagnostics) == row.place);
  CHECK(result.diagnostics.at(0).message == row.message);
  CHECK(result.diagnostics.at(0).hint == row.hint);
}

TEST_CASE("a number with too many digits for toml++ is rejected", "[parse]") {
  const std::string digits(200, '7');
  CHECK(model_answer("a = " + digits) == "E109 1:5");
  CHECK(model_answer("a = [-0." + digits + "]") == "E109 1:6");
}

TEST_CASE("a key may have 100 parts, which toml++ can still free, but no more", "[parse]") {
  constexpr std::size_t most = 100;
  const std::string endless = "key of more than 100 parts";
  CHECK(toml_message(repeated("a.", most - 1) + "a = 1").empty());
  CHECK(toml_message(repeated("a.", most) + "a = 1") == endless);
  CHECK(model_answer(repeated("a.", 400'000) + "a = 1") == "E101 1:200");
  // Parts in quotes and parts between spaces count too.
  CHECK(toml_message("[" + repeated("a . ", 200) + "a]") == endless);
  CHECK(toml_message("x = {" + repeated("\"=,\\\"\".", 200) + "a = 1}") == endless);
  CHECK(toml_message(repeated("'\"'.", 200) + "a = 1") == endless);
  // Points outside keys do not count.
  CHECK(toml_message("# " + repeated(".", 1000)).empty());
  CHECK(toml_message("a = [" + repeated("1.5, ", 1000) + "]").empty());
  CHECK(toml_message(repeated("[[a.b]]\n", 1000)).empty());
  CHECK(toml_message("doc = \"" + repeated("A sentence. ", 1000)) == "string is not closed");
}
