// Formulas: closed forms as they are read, in the model language and in LaTeX.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elgen/closed_forms.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/model.hpp"
#include "forms/present/arithmetic.hpp"
#include "model/formula.hpp"

namespace elgen {

/// A formula in the model language and in LaTeX, and how tightly each holds together.
struct Printed {
  std::string text = {};
  std::string latex = {};
  Binding binding = Binding::atom;
  Binding latex_binding = Binding::atom;
};

/// In brackets where it binds less tightly than `least`.
[[nodiscard]] Printed at_least(const Printed& formula, Binding least);
/// x y^exponent
[[nodiscard]] Printed product_with_power(const Printed& x, const Printed& y,
                                         std::uint32_t exponent);
[[nodiscard]] Printed sum(const Printed& x, const Printed& y, bool is_subtracted);

/// In its shortest form; none where there is none, or it is too long to be read.
[[nodiscard]] std::optional<Printed> printed(const Model& model, const Algebra& algebra,
                                             const std::optional<Fraction>& form);

/// Whether a form is more than numbers and pi.
[[nodiscard]] bool holds_leaves(const Algebra& algebra, const Fraction& form);

/// The powers that stand below in the monomials of a form, with positive exponents.
[[nodiscard]] Monomial divisor_powers(const Fraction& form);

/// The least product that makes a sum without divisors of a form: its monomials' negative powers
/// and its denominator.
[[nodiscard]] Value divisor_of(Algebra& algebra, const Fraction& form);

/// Forms as one column of values of a program; none where one is too long.
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

}  // namespace elgen
