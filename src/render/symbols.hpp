// symbols: names and units of a model -> symbols of formulas, and units as pages print them.
//
//     theta   theta1       l[2]    x_cart              mass            Ixx_arm
//     \theta  \theta_{1}   l_{2}   x_{\mathrm{cart}}   \mathrm{mass}   I_{xx, \mathrm{arm}}
#pragma once

#include <set>
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

/// The symbols of one model, by its `latex` keys where there are some, else by name. No two are
/// alike: of `m1` and `m_1` the second is m_{1}'.
class ModelSymbols {
 public:
  explicit ModelSymbols(const Model& model);

  [[nodiscard]] const LeafValues<std::string>& leaves() const { return leaves_; }
  [[nodiscard]] const std::vector<SymbolText>& coordinates() const { return coordinates_; }
  /// Symbols of parameters as they are declared: "l_{i}" for an array.
  [[nodiscard]] const std::vector<SymbolText>& arrays() const { return arrays_; }
  /// A symbol for something else in formulas, unlike all others so far.
  [[nodiscard]] SymbolText distinct(SymbolText symbol);

 private:
  void add_open_values(const Model& model);

  /// Primes until none of the symbols is taken, and takes them.
  std::string primes_for(const std::vector<SymbolText>& symbols);

  std::set<std::string> taken_ = {};
  std::vector<SymbolText> coordinates_ = {};
  std::vector<SymbolText> arrays_ = {};
  LeafValues<std::string> leaves_ = {};
};

/// The symbol of a name; of "l[2]" with the key of `l`. Without a key, and with one that draws
/// nothing: as the name suggests.
[[nodiscard]] SymbolText latex_symbol(std::string_view name, const std::string& key = {});

/// The character of a Greek letter's command ("theta"); empty for other words.
[[nodiscard]] std::string_view greek_letter(std::string_view command);

/// The command of a Greek letter; empty for other characters.
[[nodiscard]] std::string_view greek_command(std::string_view letter);

/// kg*m^2/s^2 as pages print it: kg m²/s². `times` stands between factors; `exponent_text` writes
/// an exponent: "2", "-1", "1/2".
[[nodiscard]] std::string unit_text(std::string unit, std::string_view times,
                                    std::string (*exponent_text)(const std::string& exponent));

}  // namespace elgen
