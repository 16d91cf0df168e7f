// headings: what models and outputs are called, and how outputs are defined, in LaTeX.
#pragma once

#include <string>

#include "elgen/model.hpp"
#include "elgen/program.hpp"

namespace elgen {

struct Heading {
  std::string symbol = {};      ///< "M"
  std::string definition = {};  ///< "M = \frac{\partial^2 L}{\partial \dot{q}^2}"; may be empty
};

/// "mass_matrix" -> "Mass matrix"
[[nodiscard]] std::string as_title(std::string name);

/// The title of a model, else its name as one.
[[nodiscard]] std::string page_title(const Model& model);

/// LaTeX of the output table in the model's symbols, vectors in bold: where rotations turn the
/// rates are velocities of their own.
[[nodiscard]] std::string latex_of(const Model& model, std::string_view latex);

[[nodiscard]] Heading heading(const Model& model, const Function& function);

/// The symbol of one field of a struct.
[[nodiscard]] std::string field_symbol(const Model& model, OutputKind kind, const Field& field);

/// One sentence: the table's, or the model's own about its outputs.
[[nodiscard]] std::string output_doc(const Model& model, const Function& function);

}  // namespace elgen
