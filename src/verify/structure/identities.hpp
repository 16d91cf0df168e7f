// The tables of identities between the functions of a program, and helpers for their balances.
#pragma once

#include <string_view>
#include <vector>

#include "program/evaluate/exact_values.hpp"

namespace elgen {

struct Identity {
  std::string_view check;
  std::string_view formula;
  std::vector<OutputKind> functions;          ///< needed in the program; the row names the first
  ResidualSums (*balance)(ExactValues& at);   ///< left side minus right side
  std::string_view constrained_formula = {};  ///< the formula with constraints; empty: `formula`
};

[[nodiscard]] const std::vector<Identity>& identities();

/// The identity between an [[output]] y and one of its derivatives. For a frame, y is a pose, and
/// its twist takes the place of dy/dt; this needs quaternions of norm 1.
struct OutputIdentity {
  OutputKind derivative;
  std::string_view check;
  std::string_view formula;
  std::string_view formula_of_frame;
  ResidualSums (*balance)(ExactValues& at, std::uint32_t user);
};

[[nodiscard]] const std::vector<OutputIdentity>& output_identities();

/// Terms of a balance. Entry i of the balance has the terms factor * values[n i], ..., factor *
/// values[n i + n - 1], n = `terms_per_entry`.
struct BalanceTerms {
  std::vector<Real> values = {};
  int factor = 1;
  std::size_t terms_per_entry = 1;
};

/// The balance of all terms; the first element determines the number of entries.
[[nodiscard]] ResidualSums balance_of(const std::vector<BalanceTerms>& all);

/// The direction along q in which v_i = 1 and all other velocities are 0.
[[nodiscard]] Arguments<Real> unit_displacement(const ExactValues& at, std::size_t i);

}  // namespace elgen
