// find_latex_mistake: what a symbol of formulas may not hold, because documents and pages run it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace elgen {

/// A place in the text, in bytes, and what is wrong there.
struct LatexMistake {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string message = {};
};

/// The first mistake of a symbol: it is empty, has a character or command that is not listed, or
/// braces that do not match. Commands are letters, accents and fonts; none opens a file, defines
/// another one, or ends what stands around the symbol.
[[nodiscard]] std::optional<LatexMistake> find_latex_mistake(std::string_view text);

}  // namespace elgen
