// find_latex_mistake: one pass; a command is a backslash and letters, or one other character.
#include "parse/latex_symbol.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "elgen/wording.hpp"

namespace elgen {
namespace {

constexpr std::array commands{std::to_array<std::string_view>(
    {// letters
     "Delta", "Gamma", "Lambda", "Omega", "Phi", "Pi", "Psi", "Sigma", "Theta", "Upsilon", "Xi",
     "aleph", "alpha", "beta", "chi", "delta", "digamma", "ell", "epsilon", "eta", "gamma", "hbar",
     "imath", "iota", "jmath", "kappa", "lambda", "mu", "nabla", "nu", "omega", "partial", "phi",
     "pi", "psi", "rho", "sigma", "tau", "theta", "upsilon", "varepsilon", "varkappa", "varphi",
     "varpi", "varrho", "varsigma", "vartheta", "wp", "xi", "zeta",
     // accents
     "acute", "bar", "breve", "check", "ddot", "dot", "grave", "hat", "mathring", "overline",
     "overrightarrow", "tilde", "underline", "vec", "widehat", "widetilde",
     // fonts
     "bm", "boldsymbol", "mathbb", "mathbf", "mathcal", "mathfrak", "mathit", "mathrm", "mathscr",
     "mathsf", "mathtt", "operatorname", "text", "textbf", "textit", "textrm",
     // signs
     "ast", "bullet", "cdot", "circ", "dagger", "ddagger", "diamond", "infty", "max", "min", "odot",
     "oplus", "otimes", "parallel", "perp", "pm", "prime", "star", "times", "top",
     // blanks
     "enspace", "quad", "thinspace"})};

/// What a backslash and one character may be: blanks, and characters that are markup without it.
constexpr std::string_view escapes = ",:;! _{}&%#";
constexpr std::string_view marks = "_^{}'.,:;+-*/=()[]|! \t";

bool is_plain(std::string_view text, std::size_t at, const CodePoint& point) {
  return point.bytes > 1 || is_letter(text[at]) || is_digit(text[at]) ||
         marks.find(text[at]) != std::string_view::npos;
}

std::size_t end_of_command(std::string_view text, std::size_t backslash) {
  std::size_t end = backslash + 1;
  while (end < text.size() && is_letter(text[end])) ++end;
  return std::min(std::max(end, backslash + 2), text.size());
}

bool is_allowed(std::string_view command) {
  return std::ranges::find(commands, command) != commands.end() ||
         (command.size() == 1 && escapes.find(command) != std::string_view::npos);
}

std::optional<LatexMistake> mistake(std::string_view text, std::size_t begin, std::size_t end,
                                    std::string_view what) {
  return LatexMistake{begin, end,
                      fmt::format("{} {}", in_backticks(text.substr(begin, end - begin)), what)};
}

}  // namespace

std::optional<LatexMistake> find_latex_mistake(std::string_view text) {
  if (text.find_first_not_of(" \t\n\r") == std::string_view::npos) {
    return LatexMistake{0, text.size(), "the symbol is empty"};
  }
  std::vector<std::size_t> open;
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint point = code_point_at(text, at);
    std::size_t end = at + std::max<std::size_t>(1, point.bytes);
    if (text[at] == '\\') {
      end = end_of_command(text, at);
      if (!is_allowed(text.substr(at + 1, end - at - 1))) {
        return mistake(text, at, end, "is no command of symbols");
      }
    } else if (!is_plain(text, at, point)) {
      return mistake(text, at, end, "does not stand in symbols");
    } else if (text.substr(at, 2) == "^^") {
      return mistake(text, at, at + 2, "is no way to write a character");
    } else if (text[at] == '{') {
      open.push_back(at);
    } else if (text[at] == '}') {
      if (open.empty()) return mistake(text, at, end, "closes nothing");
      open.pop_back();
    }
    at = end;
  }
  if (open.empty()) return std::nullopt;
  return mistake(text, open.back(), open.back() + 1, "is not closed");
}

}  // namespace elgen
