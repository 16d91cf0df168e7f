// Command-line options parsed as keys, with the span of each piece in its option.
#include <catch2/catch.hpp>

#include "parse_testing.hpp"

namespace elgen::test {
namespace {

/// One line per key, "name column: value value", then the places and messages of the diagnostics.
std::string answer(const std::vector<std::string>& texts, KeyType type) {
  std::vector<SourcePointer> options;
  for (const std::string& text : texts) options.push_back(make_source("command line", text));
  const Result<std::vector<KeySyntax>> keys = parse_options(options, type, {});
  REQUIRE(keys);
  std::string answer;
  for (const KeySyntax& key : *keys) {
    answer += key.key + " " + std::to_string(key.key_span.begin + 1) + ":";
    const bool is_list = key.value.kind == ValueKind::list;
    if (key.value.kind == ValueKind::boolean) answer += key.value.boolean ? " true" : " false";
    if (key.value.kind == ValueKind::expression) answer += " " + dump(key.value.expression);
    for (const ValueSyntax& item : key.value.items) answer += " " + item.text;
    answer += is_list ? " as a list\n" : "\n";
  }
  for (const Diagnostic& problem : keys.diagnostics) {
    answer += std::string(code_row(problem.code).name) + " " +
              std::to_string(problem.span.begin + 1) + " " + problem.message + "\n";
  }
  return answer;
}

std::vector<std::string> words_of(const std::string& text) {
  static std::vector<SourcePointer> alive;
  alive.push_back(make_source("command line", text));
  std::vector<std::string> words;
  for (const Span& word : option_words({alive.back()})) words.emplace_back(covered_text(word));
  return words;
}

}  // namespace

TEST_CASE("words are split at commas outside brackets, and surrounding blanks are removed") {
  CHECK(words_of("a, b c ,d") == std::vector<std::string>{"a", "b c", "d"});
  CHECK(words_of("a,") == std::vector<std::string>{"a", ""});
  CHECK(words_of("e=[1, 0], x=max(1, (2)),y") ==
        std::vector<std::string>{"e=[1, 0]", "x=max(1, (2))", "y"});
  CHECK(option_words({}).empty());
}

TEST_CASE("words are parsed as keys with values, and blanks in names are removed") {
  CHECK(answer({"m = 1/2 ,dot( x )=-3", "k=2"}, KeyType::expression) ==
        "m 1: (1 / 2)\ndot(x) 10: (-3)\nk 1: 2\n");
  CHECK(answer({"g, m=1"}, KeyType::boolean_or_expression) == "g 1: true\nm 4: 1\n");
}

TEST_CASE("a list is accepted if the key type permits lists") {
  CHECK(answer({"e=[1, 0],x=2"}, KeyType::expression_or_list) == "e 1: 1 0 as a list\nx 10: 2\n");
  CHECK(answer({"q=-1 .. pi/2"}, KeyType::range) == "q 1: -1 pi/2 as a list\n");
  CHECK(answer({"q=-1:pi/2"}, KeyType::range) == "q 1: -1 pi/2 as a list\n");
  CHECK(answer({"e=[1,0]"}, KeyType::expression).starts_with("E30"));
}

TEST_CASE("a word that is no key is E606, and the other words are kept") {
  CHECK(answer({"x,y=1"}, KeyType::expression) == "y 3: 1\nE606 1 `x` has no value\n");
  for (const KeyType type : {KeyType::expression, KeyType::boolean_or_expression, KeyType::range}) {
    CHECK(answer({"x="}, type) == "E606 1 `x=` has no value\n");
  }
  CHECK(answer({"x=1", "y=2,x =3"}, KeyType::expression) ==
        "x 1: 1\ny 1: 2\nE606 5 `x` is given twice\n");
  CHECK(answer({"q=1"}, KeyType::range) == "E606 3 `1` is no range\n");
}

TEST_CASE("a mistake in an expression is reported at its place") {
  CHECK(answer({"x=1, y=2*"}, KeyType::expression).starts_with("x 1: 1\nE302 "));
  CHECK(answer({"q=1.."}, KeyType::range).starts_with("E310 "));
}

}  // namespace elgen::test
