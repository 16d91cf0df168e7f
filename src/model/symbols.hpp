// symbols: names and units of a model -> symbols of formulas, and units as pages print them.
//
//     theta   theta1       l[2]    x_cart              mass            Ixx_arm
//     \theta  \theta_{1}   l_{2}   x_{\mathrm{cart}}   \mathrm{mass}   I_{xx, \mathrm{arm}}
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/formula.hpp"
#include "elgen/leaf_names.hpp"
#include "elgen/model.hpp"
#include "formula/glyphs.hpp"

namespace elgen {

/// The glyphs of one symbol: a base, with scripts on its last piece.
[[nodiscard]] Glyphs accented(Glyphs symbol, std::string_view dots);

/// An expression of a model, operand by operand: multiply(1/2, add(a, negate(b))) is 1/2*(a - b).
/// `name` gives what has a name: leaves, pi, definitions, components of points and frames, rates.
[[nodiscard]] Formula formula_of(const Model& model, ExpressionId expression,
                                 const std::function<Formula(ExpressionId)>& name);

/// "mass_matrix" -> "Mass matrix"
[[nodiscard]] std::string as_title(std::string name);
/// The title of a model, else its name as one.
[[nodiscard]] std::string page_title(const Model& model);

/// The symbols of one model, by its `latex` keys where there are some, else by name. No two are
/// alike: of `m1` and `m_1` the second is m_{1}'.
class ModelSymbols {
 public:
  explicit ModelSymbols(const Model& model) : ModelSymbols(model, leaf_names(model)) {}
  /// The names are those of a program of the model: it has names for momenta, too.
  ModelSymbols(const Model& model, const LeafNames& names);

  /// Leaves as symbols of formulas.
  [[nodiscard]] const LeafValues<Formula>& leaves() const { return leaves_; }
  /// Symbols of parameters as they are declared: "l_{i}" for an array.
  [[nodiscard]] const std::vector<Formula>& arrays() const { return arrays_; }
  /// A symbol for something else in formulas, unlike all others so far.
  [[nodiscard]] Glyphs distinct(Glyphs symbol);

 private:
  void add_open_values(const Model& model);

  /// Primes until none of the symbols is taken, and takes them.
  std::size_t primes_for(const std::vector<Glyphs>& symbols);

  std::set<std::string> taken_ = {};
  std::vector<Formula> arrays_ = {};
  LeafValues<Formula> leaves_ = {};
};

/// The symbol of a name; of "l[2]" with the key of `l`. Without a key, and with one that draws
/// nothing: as the name suggests.
[[nodiscard]] Glyphs symbol_of_name(std::string_view name, const std::string& key = {});

/// A formula of a table in the symbols of a model: as text v is v; in LaTeX <v> and <a> are rates
/// of q where nothing turns, and <N> is the factor of dq/dt = N v, if it is not 1.
[[nodiscard]] Formula typed_formula(const Model& model, std::string_view latex);
/// The glyphs of the same.
[[nodiscard]] Glyphs typed_glyphs(const Model& model, std::string_view latex);
/// dL/dx of a function L by a symbol x: "dL/d(dot(q))".
[[nodiscard]] Formula partial_derivative(std::string_view function, const Formula& x);
/// Every vector of this name replaced.
[[nodiscard]] Glyphs replaced(Glyphs glyphs, std::string_view vector, const Glyphs& by);

/// kg*m^2/s^2 as pages print it: kg m²/s². `times` stands between factors; `exponent_text` writes
/// an exponent: "2", "-1", "1/2".
[[nodiscard]] std::string unit_text(std::string unit, std::string_view times,
                                    std::string (*exponent_text)(const std::string& exponent));

}  // namespace elgen
