// function_docs: a Function and its equations -> the lines of its documentation comment.
//
//     Mass matrix, symmetric. 2 x 2, row-major [kg, kg*m; kg*m, kg*m^2].
//
//         M = d^2 L/dv^2
//
//         [ M + m,          l*m*cos(theta) ]
//         [ l*m*cos(theta), l^2*m          ]
#pragma once

#include <string>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/page.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The data from which the documentation of a function is written.
struct FunctionDocsInput {
  const Model& model;
  const Program& program;
  const Function& function;
  const FunctionEquations& equations;
  std::string sidecar = {};  ///< file with the entries that are too long to show
  Emission emission = {};
};

/// The lines of the comment without `///`. Each line is empty or begins with a space.
[[nodiscard]] std::vector<std::string> function_docs(const FunctionDocsInput& text);

/// "Mass matrix, symmetric. 2 x 2, row-major [kg].": the documentation before the equations.
[[nodiscard]] std::string function_heading(const FunctionDocsInput& text);

/// "kg, kg*m; kg*m, kg*m^2": rows separated by ";", entries by ",". A single unit if all are equal;
/// "" if a unit is unknown or the list is too long to help.
[[nodiscard]] std::string units_text(const Model& model, OutputKind kind, const Field& field);

/// "2 x 2, row-major [kg]", "2 entries [N], of x, y": the shape and the units of a field, and
/// names_without_leaf() of its rows unless the list is too long to help.
[[nodiscard]] std::string field_summary(const FunctionDocsInput& text, const Field& field);

/// "cart mass [kg] in [0, 2]": documentation, unit and range; the name if all three are missing.
[[nodiscard]] std::string parameter_doc(const ParameterArray& array);

}  // namespace elgen
