// symbols: names and units of a model -> symbols in formulas, and units on pages.
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

/// Adds dots to the base of a symbol, below its primes and scripts.
[[nodiscard]] Glyphs add_dots(Glyphs symbol, std::string_view dots);

/// Converts an expression operand by operand: multiply(1/2, add(a, negate(b))) becomes 1/2*(a - b).
/// `name` returns the formulas of leaves, pi, definitions, components of points and frames, and
/// rates.
[[nodiscard]] Formula formula_of(const Model& model, ExpressionId expression,
                                 const std::function<Formula(ExpressionId)>& name);

/// "mass_matrix" -> "Mass matrix"
[[nodiscard]] std::string as_title(std::string name);
/// The title of a model; without one, its name as a title.
[[nodiscard]] std::string page_title(const Model& model);

/// The symbols of one model, from its `latex` keys or its names. They are distinct: if `m1` is
/// m_{1}, `m_1` becomes m_{1}'.
class ModelSymbols {
 public:
  explicit ModelSymbols(const Model& model) : ModelSymbols(model, leaf_names(model)) {}
  /// `names`: of a program of the model, which may also name momenta.
  ModelSymbols(const Model& model, const LeafNames& names);

  /// The symbols of leaves.
  [[nodiscard]] const LeafValues<Formula>& leaves() const { return leaves_; }
  /// The symbols of parameters as declared; "l_{i}" for an array.
  [[nodiscard]] const std::vector<Formula>& arrays() const { return arrays_; }
  /// Makes a symbol distinct from all symbols so far by adding primes.
  [[nodiscard]] Glyphs distinct(Glyphs symbol);

 private:
  void add_open_values(const Model& model);

  /// Finds the number of primes that makes the symbols distinct, and reserves the results.
  std::size_t count_primes(const std::vector<Glyphs>& symbols);

  std::set<std::string> taken_ = {};
  std::vector<Formula> arrays_ = {};
  LeafValues<Formula> leaves_ = {};
};

/// The symbol of a name; "l[2]" uses the key of `l`. If the key is empty or draws nothing, the
/// symbol follows from the name.
[[nodiscard]] Glyphs symbol_of_name(std::string_view name, const std::string& key = {});

/// A formula of a table in the symbols of a model. In text, v is always v. In LaTeX without
/// rotations, <v> and <a> become rates of q, and <N> is omitted, since dq/dt = v.
[[nodiscard]] Formula latex_formula(const Model& model, std::string_view latex);
/// The glyphs of this formula.
[[nodiscard]] Glyphs typed_glyphs(const Model& model, std::string_view latex);
/// The symbol of the derivative of `function` by x: "dL/d(dot(q))".
[[nodiscard]] Formula partial_derivative(std::string_view function, const Formula& x);
/// Replaces every vector of this name by glyphs.
[[nodiscard]] Glyphs replaced(Glyphs glyphs, std::string_view vector, const Glyphs& by);

/// A unit as printed on pages: kg*m^2/s^2 becomes kg m²/s². `times` separates factors;
/// `exponent_text` formats an exponent "2", "-1" or "1/2".
[[nodiscard]] std::string unit_text(std::string unit, std::string_view times,
                                    std::string (*exponent_text)(const std::string& exponent));

}  // namespace elgen
