// symbols: the symbols in formulas that the names of a model get, and the units on pages.
//
//     theta   theta1       l[2]    x_cart              mass            Ixx_arm                Jm
//     \theta  \theta_{1}   l_{2}   x_{\mathrm{cart}}   \mathrm{mass}   I_{xx, \mathrm{arm}}   J_{m}
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

/// Adds dots over the base of a symbol; primes, subscripts and superscripts are not dotted.
[[nodiscard]] Glyphs add_dots(Glyphs symbol, std::string_view dots);

/// Converts an expression node by node: multiply(1/2, add(a, negate(b))) becomes 1/2*(a - b).
/// `name` returns the formula of a node that has a symbol: a leaf, pi, a definition, a component of
/// a point or frame, a rate.
[[nodiscard]] Formula formula_of(const Model& model, ExpressionId expression,
                                 const std::function<Formula(ExpressionId)>& name);

/// "mass_matrix" -> "Mass matrix"
[[nodiscard]] std::string title_from_name(std::string name);
/// The title of a model; if the model has no title, title_from_name() of the model's name.
[[nodiscard]] std::string page_title(const Model& model);

/// The symbols of a model, from its `latex` keys or else from its names. All symbols are distinct:
/// if the symbol of `m1` is m_{1}, the symbol of `m_1` is m_{1}'.
class ModelSymbols {
 public:
  explicit ModelSymbols(const Model& model) : ModelSymbols(model, leaf_names(model)) {}
  /// `names`: the leaf names of a program of the model, which may include momenta.
  ModelSymbols(const Model& model, const LeafNames& names);

  /// The symbols of all leaves.
  [[nodiscard]] const LeafValues<Formula>& leaf_symbols() const { return leaves_; }
  /// The symbol of each declared parameter; "l_{i}" for an array.
  [[nodiscard]] const std::vector<Formula>& parameter_symbols() const { return arrays_; }
  /// The symbol with as many primes as make it distinct from all earlier symbols.
  [[nodiscard]] Glyphs make_distinct(Glyphs symbol);

 private:
  void add_open_values(const Model& model);

  /// Returns the number of primes that makes all `symbols` distinct from all earlier symbols, and
  /// reserves the primed symbols.
  std::size_t reserve_primes(const std::vector<Glyphs>& symbols);

  std::set<std::string> used_texts_ = {};
  std::vector<Formula> arrays_ = {};
  LeafValues<Formula> leaves_ = {};
};

/// The symbol of a name, from its `latex` key; the key of "l[2]" is the key of `l`. If the key is
/// empty or draws nothing, the symbol follows from the name. `splits_pairs`: `Jm` is J_{m}.
[[nodiscard]] Glyphs symbol_of_name(std::string_view name, const std::string& key = {},
                                    bool splits_pairs = true);
/// symbol_of_name() for a name of the model. `Jm` is the word Jm, not J_{m}, if the model also has
/// the name `J_m`.
[[nodiscard]] Glyphs symbol_in_model(const Model& model, std::string_view name,
                                     const std::string& key = {});

/// A LaTeX formula of the output table (see Notation) for a model. If the model has no rotations,
/// <v> and <a> become dq/dt and d^2q/dt^2, and <N> is omitted, because dq/dt = v. The plain text of
/// the formula always has `v`.
[[nodiscard]] Formula latex_formula(const Model& model, std::string_view latex);
/// The glyphs of latex_formula().
[[nodiscard]] Glyphs latex_glyphs(const Model& model, std::string_view latex);
/// The symbol of the derivative of `function` with respect to x: "dL/d(dot(q))".
[[nodiscard]] Formula partial_derivative(std::string_view function, const Formula& x);
/// Replaces every vector `<vector>` in `glyphs` by the glyphs `by`.
[[nodiscard]] Glyphs replace_vector(Glyphs glyphs, std::string_view vector, const Glyphs& by);

/// A formula in Unicode on one line, as on screens: "θ̇₁", "π/2".
[[nodiscard]] std::string unicode_text(const Formula& formula);
[[nodiscard]] std::string unicode_text(const Glyphs& glyphs);

/// A unit in Unicode: "kg m²/s²" from "kg*m^2/s^2"; "" from "1".
[[nodiscard]] std::string unicode_unit(const std::string& unit);

/// A unit as pages print it: kg*m^2/s^2 becomes kg m²/s². `times` separates factors;
/// `exponent_text` formats an exponent "2", "-1" or "1/2".
[[nodiscard]] std::string format_unit(std::string unit, std::string_view times,
                                      std::string (*exponent_text)(const std::string& exponent));

}  // namespace elgen
