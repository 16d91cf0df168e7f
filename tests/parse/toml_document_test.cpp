// TOML trees: file order, and the exact place of every key and value.
#include "parse/toml_document.hpp"

#include <rapidcheck.h>

#include <catch2/catch.hpp>

using namespace elgen;

namespace {

/// Keys and values as the file spells them, depth first.
std::string spelled(const TomlValue& value) {
  std::string result;
  for (const TomlEntry& entry : value.entries) {
    result += std::string(covered_text(entry.key_span)) + ":";
    result += std::string(covered_text(entry.value.span)) + ";" + spelled(entry.value);
  }
  for (const TomlValue& item : value.items) {
    result += std::string(covered_text(item.span)) + ";" + spelled(item);
  }
  return result;
}

std::string spelled(const std::string& text) {
  const SourcePointer source = make_source("test", text);
  const auto root = read_toml(*source);
  REQUIRE(root);
  return spelled(*root);
}

}  // namespace

TEST_CASE("entries come in file order", "[parse]") {
  CHECK(spelled("z = 1\na = 2\nm = 3\n") == "z:1;a:2;m:3;");
}

TEST_CASE("values and keys stand where they stand", "[parse]") {
  CHECK(spelled("a = [ 1, \"two\",\n  +1_0.5 ]") ==
        "a:[ 1, \"two\",\n  +1_0.5 ];1;\"two\";+1_0.5;");
  CHECK(spelled("\"a b\" = { c = true, d.e = 'x' }") ==
        "\"a b\":{ c = true, d.e = 'x' };c:true;d:d;e:'x';");
  CHECK(spelled("d = \"\u03C0\" # c\r\ne = 1979-05-27\r\n") == "d:\"\u03C0\";e:1979-05-27;");
  CHECK(spelled("\xEF\xBB\xBF"
                "a = 1\nb = 2") == "a:1;b:2;");
}

TEST_CASE("tables stand at their headers", "[parse]") {
  CHECK(spelled("[p.m]\nv = 1\n[p]\nq = 2\n") == "p:[p];m:[p.m];v:1;q:2;");
  const SourcePointer source = make_source("test", "[[c]]\na = 1\n\n  [[c]]\na = 2\n");
  const auto root = read_toml(*source);
  REQUIRE(root);
  const TomlValue& array = root->entries.at(0).value;
  CHECK(covered_text(array.items.at(0).span) == "[[c]]");
  CHECK(array.items.at(1).span.begin == 15);
}

TEST_CASE("numbers are told from what only looks like one", "[parse]") {
  const SourcePointer source =
      make_source("test", "a = 1_0.5\nb = 0x1E\nc = inf\nd = -nan\ne = 1979-05-27\nf = 0b1\n");
  const auto root = read_toml(*source);
  REQUIRE(root);
  CHECK(root->entries.at(0).value.kind == TomlKind::number);
  for (std::size_t i = 1; i < 6; ++i) CHECK(root->entries.at(i).value.kind == TomlKind::other);
}

TEST_CASE("random files are answered with a tree or one error inside them", "[parse]") {
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
