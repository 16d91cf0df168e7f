// Formulas: closed forms as they are read, in the model language and in LaTeX.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "elgen/closed_forms.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/model.hpp"

namespace elgen {

struct Printed {
  std::string text = {};
  std::string latex = {};
};

/// Each in its shortest form; none where it is too long to be read.
[[nodiscard]] std::vector<std::optional<Printed>> formulas(const Model& model,
                                                           const Algebra& algebra,
                                                           const std::vector<Fraction>& forms);

/// Those as one column of values of a program; none where one is too long.
struct FormProgram {
  Program program = {};
  [[nodiscard]] const Function& function() const { return program.functions[0]; }
};
[[nodiscard]] std::optional<FormProgram> form_program(const LeafNames& leaves,
                                                      const Algebra& algebra,
                                                      const std::vector<Fraction>& forms);

/// Its number in 64 digits; undefined where it has none, or is too long.
[[nodiscard]] Real value_of(const Algebra& algebra, const Fraction& form,
                            const Arguments<Real>& at);

/// Whether numbers of 64 digits differ by less than 1e-40: closed forms may be equal then.
[[nodiscard]] bool is_near(const Real& x, const Real& y);

}  // namespace elgen
