// page_parts: closed forms, numbers, titles and claims, in the same style for all analyses.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/analyse.hpp"
#include "elgen/analysis_pages.hpp"
#include "elgen/formula.hpp"
#include "elgen/page.hpp"
#include "forms/present/arithmetic.hpp"

namespace elgen {

/// The symbols of a model, and the formulas of closed forms over its leaves.
struct PageForms {
  PageForms(const Model& page_model, const ClosedForms& found);

  [[nodiscard]] std::optional<Formula> to_formula(const OptionalFraction& form) const {
    return readable_formula(model, forms.algebra, form);
  }

  const Model& model;
  ClosedForms forms;  ///< a copy, because computing with forms extends their algebra
  LeafValues<Formula> symbols;
};

/// A symbol whose text differs from its LaTeX: "w^2".
[[nodiscard]] Formula latex_symbol(std::string text, std::string_view latex);
/// A wide blank between two formulas of a row.
[[nodiscard]] Formula wide_blank();
[[nodiscard]] Formula six_digit_formula(const cln::cl_R& value);
[[nodiscard]] Formula six_digit_formula(double value);

/// "TITLE, p_phi = 0.6 N m s: SUBJECT", with the momenta that the scene holds.
[[nodiscard]] Formula analysis_title(const CheckedModel& checked, const std::string& subject);

/// "r in [0.3, 3]" for each coordinate whose range was searched.
[[nodiscard]] Formulas searched_ranges(const PageForms& known, const Equilibria& equilibria);

/// True if two points differ only in the sign of each angle acos(c).
[[nodiscard]] bool is_mirrored(ClosedForms& forms, const RestPoint& here, const RestPoint& next);

/// The conditions under which the points are equilibria: "exact for all values of the parameters;
/// stability at the parameters' values; theta modulo 2*pi".
[[nodiscard]] Formula scope_claim(PageForms& known, const Equilibria& equilibria);

/// The verdict on the completeness of the list: "these are all at the parameters' values (proved)".
[[nodiscard]] Formula completeness_claim(const Model& model, const Equilibria& equilibria);

[[nodiscard]] const char* name_of(SymmetryKind kind);

[[nodiscard]] inline bool is_zero_form(const OptionalFraction& form) {
  return form && form->numerator.empty();
}

/// Integrals that forces do not change, as entries of [[expect]] in the model. Integrals with
/// quaternions are omitted, because a model cannot name their components. The list is empty if a
/// scene changes the model.
[[nodiscard]] std::vector<std::string> stated_integrals(const CheckedModel& checked,
                                                        PageForms& known,
                                                        const Symmetries& symmetries);

}  // namespace elgen
