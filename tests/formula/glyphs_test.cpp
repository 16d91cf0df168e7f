// Glyphs: parsed from LaTeX and printed again, measured, broken into lines, translated to MathML,
// split into prose and formulas.
#include "formula/glyphs.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "elgen/functions.hpp"
#include "elgen/outputs.hpp"
#include "support/text.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

using Texts = std::vector<std::string>;

Texts lines_of(const std::string& text, double widest) {
  Texts lines;
  for (const Glyphs& line : break_lines(read_latex(text), widest)) lines.push_back(to_latex(line));
  return lines;
}

/// The pieces of a text; prose in quotes, formulas without.
Texts pieces_in(const std::string& text) {
  Texts all;
  for (const auto& [is_prose, prose, formula] : split_at_prose(read_latex(text))) {
    all.push_back(is_prose ? "'" + prose + "'" : to_latex(formula));
  }
  return all;
}

/// `text` with bold LaTeX in place of each `<q>`, the notation of the tables for bold letters.
std::string with_bold(std::string text) {
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;) {
    const std::size_t end = text.find('>', at);
    const std::string name = text.substr(at + 1, end - at - 1);
    const bool is_greek = !greek_letter(name).empty();
    text.replace(at, end + 1 - at,
                 is_greek ? "\\boldsymbol{\\" + name + "}" : "\\mathbf{" + name + "}");
  }
  return text;
}

/// The LaTeX texts in the tables of outputs, leaves and functions.
Texts latex_of_tables() {
  Texts all;
  for (const OutputRow& row : output_table()) {
    for (const Notation& notation :
         {row.symbol, row.equation, row.rotation_equation, row.constrained_equation}) {
      all.emplace_back(notation.latex);
    }
    for (const FieldRow& field : row.fields) all.emplace_back(field.latex);
  }
  for (const LeafRow& row : leaf_table()) {
    all.emplace_back(row.latex);
    all.emplace_back(row.own_latex);
  }
  for (const FunctionRow& row : function_table()) all.emplace_back(row.latex);
  return all;
}

}  // namespace

TEST_CASE("the LaTeX of tables is printed unchanged") {
  const Texts all = latex_of_tables();
  CHECK(all.size() > 100);
  for (const std::string& text : all) CHECK(to_latex(read_latex(text)) == with_bold(text));
}

TEST_CASE("LaTeX is printed unchanged, with scripts in braces") {
  for (const char* const text :
       {"{\\delta} q", "\\left[ x \\right]_{\\mathrm{locked}}", "\\left. {} + x \\right)^{-1/2}",
        "{x^{2}}^{3}", "\\ddot{\\mathrm{elbow}}_{2}'", "a \\text{, so } b, \\quad c",
        "\\operatorname{tr} A", "\\unknown x", "1.5 \\cdot 10^{-7}", "|x| \\le \\pm 2"}) {
    CHECK(to_latex(read_latex(text)) == text);
  }
  const std::vector<std::pair<std::string, std::string>> rows{
      {"q_1^2", "q_{1}^{2}"},        {"\\frac1x", "\\frac{1}{x}"}, {"<tau>", "\\boldsymbol{\\tau}"},
      {"\\dot q", "\\dot{q}"},       {"{\\alpha}x", "{\\alpha}x"}, {"\\bm{q}", "\\mathbf{q}"},
      {"\u03b8 + 1", "\\theta + 1"}, {"x^\\prime", "x^{'}"}};
  for (const auto& [typed, printed] : rows) CHECK(to_latex(read_latex(typed)) == printed);
}

TEST_CASE("a formula is parsed into its parts") {
  const Glyphs tree = read_latex("\\frac{a}{b} - \\sin^{2} x");
  REQUIRE(tree.parts.size() == 4);
  CHECK(tree.parts[0].kind == GlyphKind::fraction);
  CHECK(tree.parts[1].kind == GlyphKind::sign);
  CHECK(tree.parts[2].kind == GlyphKind::scripts);
  CHECK(tree.parts[2].parts.at(0).kind == GlyphKind::function);
  CHECK(tree.parts[3].kind == GlyphKind::letter);
}

TEST_CASE("the width counts the printed glyphs, not the commands") {
  CHECK(width(read_latex("\\theta")) < 2);
  CHECK(width(read_latex("\\frac{abc}{d}")) < width(read_latex("abc + d")));
  CHECK(width(read_latex("")) == 0);
}

TEST_CASE("unknown names are commands, and brackets need not match") {
  CHECK(read_latex("\\unknown").parts.at(0) == Glyphs{GlyphKind::command, "unknown"});
  CHECK(read_latex("(a").parts.size() == 2);
}

TEST_CASE("a backslash before a non-ASCII letter keeps the letter whole") {
  const Glyphs tree = read_latex("\\é + \\😀");
  REQUIRE(tree.parts.size() == 3);
  CHECK(tree.parts[0].text == "é");
  CHECK(tree.parts[2].text == "😀");
}

TEST_CASE("unclosed groups and missing arguments are accepted") {
  CHECK(read_latex("\\frac{a").parts.at(0).parts.size() == 2);
  CHECK(read_latex("\\mathrm").parts.at(0).text.empty());
  CHECK(read_latex("a_{\\sqrt").parts.size() == 1);
}

TEST_CASE("deep nesting takes linear time and no stack") {
  for (const std::string piece : {"\\frac ", "{", "\\sqrt", "x^"}) {
    std::string deep;
    for (int i = 0; i < 100'000; ++i) deep += piece;
    CHECK(width(read_latex(deep)) < 1000);
  }
}

TEST_CASE("a short formula is one line") { CHECK(lines_of("a + b - c", 40) == Texts{"a + b - c"}); }

TEST_CASE("a long formula is broken before signs at the outermost level") {
  const auto lines = lines_of("aaaaaaaa + bbbbbbbb (c + d) - eeeeeeee", 16);
  REQUIRE(lines.size() > 1);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    CHECK((lines[i][0] == '+' || lines[i][0] == '-'));
  }
}

TEST_CASE("tall brackets are closed and reopened at a break") {
  const auto lines = lines_of("\\left( aaaaaaaaaaaa + bbbbbbbbbbbb \\right) c", 14);
  REQUIRE(lines.size() == 2);
  CHECK(mentions(lines[0], "\\right."));
  CHECK(lines[1].find("\\left.") == 0);
}

TEST_CASE("LaTeX becomes MathML") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"m l^{2}", "<mi>m</mi><msup><mi>l</mi><mn>2</mn></msup>"},
      {"\\frac{1}{2} x", "<mfrac><mn>1</mn><mn>2</mn></mfrac><mi>x</mi>"},
      {"\\sqrt{x}", "<msqrt><mi>x</mi></msqrt>"},
      {"a - b", "<mi>a</mi><mo>−</mo><mi>b</mi>"},
      {"\\theta", "<mi>θ</mi>"},
      {"\u03b8_{1}", "<msub><mi>\u03b8</mi><mn>1</mn></msub>"},
      {"q_{1}", "<msub><mi>q</mi><mn>1</mn></msub>"},
      {"\\mathbf{q}", "<mi>𝐪</mi>"},
      {"\\mathbf{bias}", "<mi>𝐛𝐢𝐚𝐬</mi>"},
      {"\\boldsymbol{\\tau}", "<mi>𝛕</mi>"},
  };
  for (const auto& [latex, expected] : rows) {
    INFO(latex);
    CHECK(to_mathml(read_latex(latex)) == expected);
  }
}

TEST_CASE("a sum has a sign outside brackets or in front") {
  for (const char* sum : {"a + b", "a - b", "-a", "\\frac{a + b}{c} \\mp d"})
    CHECK(is_sum_or_signed(read_latex(sum)));
  for (const char* product : {"a", "a (b + c)", "\\frac{a + b}{c}", "\\left( a - b \\right) c"}) {
    CHECK_FALSE(is_sum_or_signed(read_latex(product)));
  }
}

TEST_CASE("prose and formulas alternate") {
  CHECK(pieces_in("x = 1") == Texts{"x = 1"});
  CHECK(pieces_in("L \\text{ lacks } x \\text{, so } p_{x} \\text{ stays}") ==
        Texts{"L", "' lacks '", "x", "', so '", "p_{x}", "' stays'"});
  CHECK(pieces_in("a, \\text{turns } b") == Texts{"a", "', '", "'turns '", "b"});
  CHECK(pieces_in("\\frac{a}{\\text{b}}") == Texts{"\\frac{a}{\\text{b}}"});
  CHECK(pieces_in("\\left( \\text{b} \\right)") == Texts{"\\left( \\text{b} \\right)"});
  CHECK(pieces_in("").empty());
}

TEST_CASE("bold letters become plain, and words upright") {
  const auto bare = [](const char* text) { return to_latex(remove_bold(read_latex(text))); };
  CHECK(bare("\\dot{\\mathbf{q}}_{\\boldsymbol{\\tau}}") == "\\dot{q}_{\\tau}");
  CHECK(bare("\\mathbf{bias}") == "\\mathrm{bias}");
}

TEST_CASE("Greek letters are found by their command") {
  CHECK(greek_letter("theta") == "θ");
  CHECK(greek_letter("cart").empty());
}
