// Formatted diagnostics: the exact text in every format, and the words that all formats share.
#include <algorithm>
#include <catch2/catch.hpp>

#include "base/diagnostic_words.hpp"
#include "elgen/diagnostic.hpp"
#include "support/text.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Span span_of(const SourcePointer& source, const std::string& part) {
  const auto begin = static_cast<std::uint32_t>(source->text.find(part));
  return {source.get(), begin, begin + static_cast<std::uint32_t>(part.size())};
}

}  // namespace

TEST_CASE("position, code, message, source line, caret and hint") {
  const SourcePointer source = make_source("m.toml", "format = 1\nT = \"1/2*mq*v\"\n");
  const Diagnostics list{
      {Code::E201, span_of(source, "mq"), "unknown name `mq`", "did you mean `m`?"}};
  CHECK(format(list) ==
        "m.toml:2:10: error[E201]: unknown name `mq`\n"
        "    2 | T = \"1/2*mq*v\"\n"
        "      |          ^~ did you mean `m`?\n");
}

TEST_CASE("the caret counts code points, and tabs and control characters are replaced") {
  const SourcePointer source = make_source("m.toml", "\tθ\x01 = πππ");
  const Diagnostics list{{Code::E307, span_of(source, "πππ"), "non-ASCII character"}};
  CHECK(format(list) ==
        "m.toml:1:7: error[E307]: non-ASCII character\n"
        "    1 |  θ? = πππ\n"
        "      |       ^~~\n");
}

TEST_CASE("a related position has its own line, and without a source it has no excerpt") {
  const SourcePointer source = make_source("m.toml", "a\nb\n");
  const Diagnostics list{{Code::E203, span_of(source, "b"), "duplicate name `b`", "",
                          span_of(source, "a"), "first declared here"},
                         {Code::E913, {}, "no command given", "see `elgen --help`"}};
  CHECK(format(list) ==
        "m.toml:2:1: error[E203]: duplicate name `b`\n"
        "    2 | b\n"
        "      | ^\n"
        "m.toml:1:1: first declared here\n"
        "elgen: error[E913]: no command given\n"
        "      see `elgen --help`\n");
}

TEST_CASE("long lines are cut around the caret") {
  const SourcePointer source =
      make_source("m.toml", std::string(5000, 'a') + "!" + std::string(5000, 'b'));
  const std::string text = format({{Code::E301, span_of(source, "!"), "unexpected `!`"}});
  CHECK(text.find("m.toml:1:5001:") == 0);
  CHECK(text.size() < 500);
  const std::size_t line = text.find(" | ") + 3;
  const std::size_t caret = text.find('^') - (text.rfind(" | ") + 3);
  CHECK(text[line + caret] == '!');
}

TEST_CASE("at most `maximum` errors are shown and the rest counted") {
  const SourcePointer source = make_source("m.toml", "x");
  const Diagnostics list(25, {Code::E201, span_of(source, "x"), "unknown name `x`"});
  const std::string text = format(list);
  CHECK(mentions(text, "elgen: 5 more errors not shown\n"));
}

TEST_CASE("at most `maximum` notes and warnings are shown") {
  const SourcePointer source = make_source("m.toml", "x");
  const Diagnostics list(60'000, {Code::E520, span_of(source, "x"), "`x`"});
  const std::string text = format(list);
  CHECK(mentions(text, "elgen: 59980 more notes not shown\n"));
  CHECK(text.size() < 10'000);
}

TEST_CASE("long text in back-ticks is cut") {
  const std::string name(100'000, 'x');
  const std::string umlauts = "ä" + std::string(198, 'x') + "äöü";
  const Diagnostics list{{Code::E201, {}, "unknown name `" + name + "` here", "not `" + name + "`"},
                         {Code::E201, {}, "`" + umlauts + "` and `b`"}};
  const std::string cut = "`" + std::string(200, 'x') + "…`";
  const std::string text = format(list);
  CHECK(mentions(text, "unknown name " + cut + " here\n      not " + cut));
  CHECK(mentions(text, "`ä" + std::string(198, 'x') + "…` and `b`"));
  CHECK(format(list, {DiagnosticFormat::json}).size() < 2000);
}

TEST_CASE("colour only on request") {
  const Diagnostics list{{Code::E511, {}, "singular at x"}};
  DiagnosticStyle color;
  color.color = true;
  CHECK_FALSE(mentions(format(list), "\x1b"));
  CHECK(mentions(format(list, color), "\x1b[1;33mwarning[E511]"));
}

TEST_CASE("every format has a word, and its row is found") {
  for (const DiagnosticFormatRow& row : diagnostic_formats()) {
    CHECK(&format_row(row.format) == &row);
    CHECK_FALSE(row.word.empty());
  }
}

TEST_CASE("machine-readable formats print all diagnostics") {
  const Diagnostics list(25, {Code::E201, {}, "unknown name `x`"});
  CHECK(std::ranges::count(format(list, {DiagnosticFormat::json}), '\n') == 25);
  CHECK(mentions(format(list, {DiagnosticFormat::github}), "elgen: 5 more errors not shown\n"));
}

TEST_CASE("JSON has code, message, hint and places") {
  const SourcePointer source = make_source("m.toml", "a\nbc\n");
  const Diagnostics list{{Code::E203, span_of(source, "bc"), "duplicate name `bc`",
                          "write another one", span_of(source, "a"), "first declared here"},
                         {Code::E913, {}, "no command given"},
                         {Code::E511, {}, "singular at \"\xff\""}};
  CHECK(format(list, {DiagnosticFormat::json}) ==
        R"({"severity":"error","code":"E203","message":"duplicate name `bc`",)"
        R"("hint":"write another one",)"
        R"("position":{"file":"m.toml","line":2,"column":1,"end_line":2,"end_column":3},)"
        R"("related":{"file":"m.toml","line":1,"column":1,"end_line":1,"end_column":2,)"
        R"("message":"first declared here"}})"
        "\n"
        R"({"severity":"error","code":"E913","message":"no command given","position":null})"
        "\n"
        R"({"severity":"warning","code":"E511","message":"singular at \"?\"","position":null})"
        "\n");
}

TEST_CASE("invisible characters are named in every format") {
  const SourcePointer source = make_source("a\u202E.toml", "xy\n");
  const Diagnostics list{{Code::E201, span_of(source, "y"), "unknown name `\u2066b`",
                          "write \uFEFFc", span_of(source, "x"), "\u2028first"}};
  CHECK(format(list) ==
        "aU+202E.toml:1:2: error[E201]: unknown name `U+2066b`\n"
        "    1 | xy\n"
        "      |  ^ write U+FEFFc\n"
        "aU+202E.toml:1:1: U+2028first\n");
  CHECK(format(list, {DiagnosticFormat::github}) ==
        "::error file=aU+202E.toml,line=1,col=2,title=E201 unknown name::unknown name `U+2066b`; "
        "write U+FEFFc\n");
  const std::string json = format(list, {DiagnosticFormat::json});
  CHECK(mentions(json, R"("message":"unknown name `U+2066b`","hint":"write U+FEFFc")"));
  CHECK(mentions(json, R"("file":"a\u202e.toml")"));
  CHECK_FALSE(mentions(json, "\u202E"));
}

TEST_CASE("a GitHub workflow command has position, title and sentence, escaped") {
  const SourcePointer source = make_source("./models/a, b.toml", "format = 1\nT = \"mq*v\"\n");
  const DiagnosticStyle github{DiagnosticFormat::github};
  CHECK(format({{Code::E201, span_of(source, "mq"), "unknown name `mq`", "did you mean `m`?"}},
               github) ==
        "::error file=models/a%2C b.toml,line=2,col=6,title=E201 unknown name::"
        "unknown name `mq`; did you mean `m`?\n");
  CHECK(format({{Code::E520, {}, "100 %\r\nnext: line, ok"}}, github) ==
        "::notice title=E520 " + std::string(code_row(Code::E520).title) +
            "::100 %25%0D%0Anext: line, ok\n");
  CHECK(text_of(WorkflowCommand{"notice", {}, "a: b, 5%", "5%: a,\nb"}) ==
        "::notice title=a%3A b%2C 5%25::5%25: a,%0Ab\n");
}

TEST_CASE("a sentence is the message followed by its hint") {
  CHECK(message_with_hint({Code::E201, {}, "unknown name `x`"}) == "unknown name `x`");
  CHECK(message_with_hint({Code::E201, {}, "unknown name `x`", "write `y`"}) ==
        "unknown name `x`; write `y`");
}

TEST_CASE("paths are printed as given, and the command line is no file") {
  const SourcePointer file = make_source("./a/b.toml", "x");
  const SourcePointer words = make_source("command line", "elgen x");
  CHECK(display_path({file.get(), 0, 1}) == "a/b.toml");
  CHECK(is_in_file({file.get(), 0, 1}));
  CHECK_FALSE(is_in_file({words.get(), 0, 1}));
  CHECK_FALSE(is_in_file({}));
  CHECK(display_path({}) == "elgen");
}
