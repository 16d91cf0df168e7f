// symbols: names of a model -> symbols of formulas.
//
//     theta   theta1       l[2]    x_cart              mass
//     \theta  \theta_{1}   l_{2}   x_{\mathrm{cart}}   \mathrm{mass}
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "elgen/leaves.hpp"
#include "elgen/model.hpp"

namespace elgen {

/// Dots of rates stand over the base alone.
struct SymbolText {
  std::string base = {};
  std::string scripts = {};

  [[nodiscard]] std::string text() const { return base + scripts; }
};

/// The leaves of a model in LaTeX, by its `latex` keys where there are some, else by name.
[[nodiscard]] LeafValues<std::string> latex_leaves(const Model& model);

/// The symbol of a name; of "l[2]" with the key of `l`. An empty key: as the name suggests.
[[nodiscard]] SymbolText latex_symbol(std::string_view name, const std::string& key = {});

/// The character of a Greek letter's command ("theta"); empty for other words.
[[nodiscard]] std::string_view greek_letter(std::string_view command);

/// The command of a Greek letter; empty for other characters.
[[nodiscard]] std::string_view greek_command(std::string_view letter);

}  // namespace elgen
