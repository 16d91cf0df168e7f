// Accepted values of each type, and E104, E109, E205 and exceeded limits at the span of the value.
// Most cases are one key in line 5 of a valid model.
#include "parse/value_reader.hpp"

#include <catch2/catch.hpp>

#include "parse_testing.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// A model with one more key in its coordinate, in line 5.
std::string coordinate_with(std::string_view line) {
  return "format = 1\nmodel.name = \"m\"\n[[coordinate]]\nname = \"x\"\n" + std::string(line) +
         "\n";
}

/// The dump of the key in `line`, or the places of the errors.
std::string key_answer(std::string_view line) {
  const std::string all = model_answer(coordinate_with(line));
  const std::size_t begin = all.find("  name = x\n  ");
  if (begin == std::string::npos) return all;
  return all.substr(begin + 13, all.size() - begin - 14);
}

}  // namespace

TEST_CASE("expressions are strings or bare decimals", "[parse]") {
  CHECK(key_answer("armature = 1_000.50") == "armature = 1000.5");
  CHECK(key_answer("armature = -0.1") == "armature = -0.1");
  CHECK(key_answer("armature = +1e-3") == "armature = 0.001");
  CHECK(key_answer("armature = \"1e-400\"") == "armature = 1e-400");
  CHECK(key_answer("armature = 0.30000000000000000000001") ==
        "armature = 0.30000000000000000000001");
  CHECK(key_answer("armature = true") == "E104 5:12");
  CHECK(key_answer("armature = [1]") == "E104 5:12");
  CHECK(key_answer("armature = \"\"") == "E310 5:13");
}

TEST_CASE("malformed decimals are rejected everywhere", "[parse]") {
  CHECK(key_answer("armature = 0x10") == "E109 5:12");
  CHECK(key_answer("armature = inf") == "E109 5:12");
  CHECK(key_answer("armature = -nan") == "E109 5:12");
  CHECK(key_answer("armature = 1979-05-27") == "E109 5:12");
  CHECK(key_answer("range = [0, 0b11]") == "E109 5:13");
  CHECK(key_answer("doc = inf") == "E109 5:7");
}

TEST_CASE("bare numbers obey the limits of literals", "[parse]") {
  Limits limits;
  limits.literal_digits = 100;
  const std::string number = "armature = 0." + std::string(100, '1');
  CHECK_FALSE(mentions(model_answer(coordinate_with(number), limits), "E9"));
  CHECK(model_answer(coordinate_with(number + "1"), limits) == "E903 5:12");
  CHECK(key_answer("armature = \"1e401\"") == "E904 5:13");
}

TEST_CASE("names have at most one index", "[parse]") {
  const auto named = [](const std::string& name) {
    return model_answer("format = 1\nmodel.name = \"m\"\n[[coordinate]]\nname = " + name + "\n");
  };
  CHECK(mentions(named("\"q[i+1]\""), "name = q[(i + 1)]"));
  CHECK(named("\"2q\"") == "E205 4:9");
  CHECK(named("\"a b\"") == "E205 4:9");
  CHECK(named("\" a\"") == "E205 4:9");
  CHECK(named("\"(a)\"") == "E205 4:9");
  CHECK(named("\"\"") == "E205 4:9");
  CHECK(named("\"a-b\"") == "E205 4:9");
  CHECK(named("\"\u03B8\"") == "E307 4:9");
  CHECK(named("\"q[i\"") == "E304 4:12");
  CHECK(named("1") == "E104 4:8");
}

TEST_CASE("lists contain expressions, ranges contain two", "[parse]") {
  CHECK(key_answer("range = [\"-pi\", 3]") == "range = [(-pi), 3]");
  CHECK(key_answer("range = [1]") == "E104 5:9");
  CHECK(key_answer("range = 1") == "E104 5:9");
  CHECK(key_answer("range = [\"(\", \"2x\"]") == "E302 5:12\nE303 5:17");
}

TEST_CASE("texts, booleans and tables are accepted in all forms", "[parse]") {
  CHECK(key_answer("doc = 'a \"b\" \\'") == "doc = \"a \\\"b\\\" \\\\\"");
  CHECK(key_answer("doc = 3") == "E104 5:7");
  CHECK(key_answer("wrap = true") == "wrap = true");
  CHECK(key_answer("wrap = \"yes\"") == "E104 5:8");
  CHECK(key_answer("start = {rate = 1, value = \"a\"}") == "start = {rate = 1, value = a}");
  CHECK(key_answer("start = 1") == "start = {value = 1}");
}

TEST_CASE("a wrong type is reported with the type found and the type expected", "[parse]") {
  const auto message = [](std::string_view line) {
    return first_error(coordinate_with(line)).message;
  };
  CHECK(message("doc = 3") == "number `3` where a string is expected");
  CHECK(message("range = \"x\"") == "string `x` where a list of 2 expressions is expected");
  CHECK(message("armature = {}") == "table where an expression (a number or a string) is expected");
  CHECK(message("armature = 0x1F") == "`0x1F` is not a decimal number");
}

TEST_CASE("integers are bare whole numbers", "[parse]") {
  const auto size = [](const std::string& value) {
    return model_answer(
        "format = 1\nmodel.name = \"m\"\n[[coordinate]]\nname = \"x\"\n[sizes]\nn = " + value);
  };
  CHECK(mentions(size("5"), "n = 5"));
  CHECK(size("5.5") == "E104 6:5");
  CHECK(size("\"5\"") == "E104 6:5");
}

namespace {

/// The dump of `rotate`, which is in line 8 of the file, or the first error.
std::string turns_answer(const std::string& turns) {
  const std::string text =
      "format = 1\nmodel.name = \"m\"\n[[coordinate]]\nname = \"q\"\n[[frame]]\nname = \"f\"\n"
      "parent = \"world\"\nrotate = " +
      turns + "\n";
  const std::string all = model_answer(text);
  const std::size_t begin = all.find("rotate = ");
  if (begin != std::string::npos) return all.substr(begin + 9, all.size() - begin - 10);
  return all + " " + first_error(text).message;
}

}  // namespace

TEST_CASE("rotations are pairs of an axis and an angle", "[parse]") {
  CHECK(turns_answer("[[\"x\", \"q\"], [[\"1\",\"2\",0], \"a\"]]") ==
        "[[\"x\", q], [[1, 2, 0], a]]");
  CHECK(turns_answer("[[\"z\", 0.5]]") == "[[\"z\", 0.5]]");
  CHECK(turns_answer("[]") == "[]");
}

TEST_CASE("malformed rotations are reported with the expected shape", "[parse]") {
  CHECK(turns_answer("\"x\"") == "E104 8:10 string `x` where a list of [axis, angle] is expected");
  CHECK(turns_answer("[\"x\"]") == "E104 8:11 string `x` where [axis, angle] is expected");
  CHECK(turns_answer("[[\"x\"]]") == "E104 8:11 list where [axis, angle] is expected");
  CHECK(turns_answer("[[\"x\", \"q\", \"z\"]]") ==
        "E104 8:11 list where [axis, angle] is expected");
  CHECK(turns_answer("[[1, \"q\"]]") == "E104 8:12 number `1` where a string is expected");
  CHECK(turns_answer("[[[\"1\", \"2\"], \"q\"]]") ==
        "E104 8:12 list where a list of 3 expressions is expected");
  CHECK(turns_answer("[[\"x\", [\"q\"]]]") ==
        "E104 8:17 list where an expression (a number or a string) is expected");
  CHECK(turns_answer("[[\"x\", \"q+\"]]") ==
        "E302 8:20 expression ends where an operand is expected");
}

namespace {

/// The wrong part of `symbol` and the message of E114, as "PART: MESSAGE"; "" if there is no E114.
std::string symbol_mistake(const std::string& symbol) {
  const std::string text = coordinate_with("latex = '''" + symbol + "'''");
  if (!mentions(model_answer(text), "E114")) return "";
  const Diagnostic error = first_error(text);
  return text.substr(error.span.begin, error.span.end - error.span.begin) + ": " + error.message;
}

}  // namespace

TEST_CASE("symbols from books are accepted", "[parse]") {
  for (const char* const symbol : {"m_2", "\\theta", "J_{2zz}", "\\dot{\\varphi}_{\\mathrm{max}}",
                                   "\\ell_0", "x'", "\\hat{\\boldsymbol{e}}_1", "q^{(2)}", "μ",
                                   "\\tilde x", "k_\\text{left arm}", "a\\,b", "\\mathrm{A\\&B}"}) {
    INFO(symbol);
    CHECK(mentions(model_answer(coordinate_with("latex = '''" + std::string(symbol) + "'''")),
                   "latex = "));
  }
}

TEST_CASE(
    "a symbol must be non-empty, with matching braces and only listed commands and characters",
    "[parse]") {
  CHECK(symbol_mistake("") == ": the symbol is empty");
  CHECK(symbol_mistake(" \n") == " \n: the symbol is empty");
  CHECK(symbol_mistake("\\input{/etc/passwd}") ==
        "\\input: `\\input` is no command that a symbol may contain");
  CHECK(symbol_mistake("x\\write18{ls}") ==
        "\\write: `\\write` is no command that a symbol may contain");
  CHECK(symbol_mistake("\\csname a\\endcsname") ==
        "\\csname: `\\csname` is no command that a symbol may contain");
  CHECK(symbol_mistake("x\\end{document}") ==
        "\\end: `\\end` is no command that a symbol may contain");
  CHECK(symbol_mistake("x\\") == "\\: `\\` is no command that a symbol may contain");
  CHECK(symbol_mistake("x$y") == "$: `$` is not allowed in a symbol");
  CHECK(symbol_mistake("<script>") == "<: `<` is not allowed in a symbol");
  CHECK(symbol_mistake("x%") == "%: `%` is not allowed in a symbol");
  CHECK(symbol_mistake("^^5cinput") == "^^: `^^` is not allowed in a symbol");
  CHECK(symbol_mistake("x_{1") == "{: `{` is not closed");
  CHECK(symbol_mistake("x}_1{") == "}: `}` closes nothing");
}
