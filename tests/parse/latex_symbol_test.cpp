// find_latex_mistake: symbols of books, and what would give orders to LaTeX or a browser.
#include "parse/latex_symbol.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

namespace {

std::string message(std::string_view text) {
  const std::optional<LatexMistake> found = find_latex_mistake(text);
  return found ? std::string(text.substr(found->begin, found->end - found->begin)) + ": " +
                     found->message
               : "";
}

}  // namespace

TEST_CASE("symbols of books have no mistake") {
  for (const char* const symbol : {"m_2", "\\theta", "J_{2zz}", "\\dot{\\varphi}_{\\mathrm{max}}",
                                   "\\ell_0", "x'", "\\hat{\\boldsymbol{e}}_1", "q^{(2)}", "μ",
                                   "\\tilde x", "k_\\text{left arm}", "a\\,b", "\\mathrm{A\\&B}"}) {
    INFO(symbol);
    CHECK(message(symbol).empty());
  }
}

TEST_CASE("a symbol is not empty, its braces match, its commands and characters are listed") {
  CHECK(message("") == ": the symbol is empty");
  CHECK(message(" \n") == " \n: the symbol is empty");
  CHECK(message("\\input{/etc/passwd}") == "\\input: `\\input` is no command of symbols");
  CHECK(message("x\\write18{ls}") == "\\write: `\\write` is no command of symbols");
  CHECK(message("\\csname a\\endcsname") == "\\csname: `\\csname` is no command of symbols");
  CHECK(message("x\\end{document}") == "\\end: `\\end` is no command of symbols");
  CHECK(message("x\\") == "\\: `\\` is no command of symbols");
  CHECK(message("x$y") == "$: `$` does not stand in symbols");
  CHECK(message("<script>") == "<: `<` does not stand in symbols");
  CHECK(message("x%") == "%: `%` does not stand in symbols");
  CHECK(message("^^5cinput") == "^^: `^^` is no way to write a character");
  CHECK(message("x_{1") == "{: `{` is not closed");
  CHECK(message("x}_1{") == "}: `}` closes nothing");
}
