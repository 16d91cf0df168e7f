// headings: what outputs are called and how they are defined, in LaTeX.
#pragma once

#include <string>

#include "elgen/model.hpp"
#include "elgen/program.hpp"

namespace elgen {

struct Heading {
  std::string symbol = {};      ///< "M"
  std::string definition = {};  ///< "M = \frac{\partial^2 L}{\partial \dot{q}^2}"; may be empty
};

/// LaTeX of the output table in the model's symbols: where rotations turn the rates are velocities
/// of their own.
[[nodiscard]] std::string latex_of(const Model& model, std::string_view latex);

[[nodiscard]] Heading heading(const Model& model, const Function& function);

/// The symbol of one field of a struct.
[[nodiscard]] std::string field_symbol(const Model& model, OutputKind kind, const Field& field);

/// One sentence: the table's, or the model's own about its outputs.
[[nodiscard]] std::string output_doc(const Model& model, const Function& function);

}  // namespace elgen
