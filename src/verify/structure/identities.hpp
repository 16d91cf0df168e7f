// The tables of identities between the functions of a program, and helpers of their balances.
#pragma once

#include <string_view>
#include <vector>

#include "program/evaluate/exact_values.hpp"

namespace elgen {

struct Identity {
  std::string_view check;
  std::string_view formula;
  std::vector<OutputKind> functions;    ///< required of the program; the first is the row's subject
  Balance (*balance)(ExactValues& at);  ///< left side minus right side
  std::string_view constrained_formula = {};  ///< with constraints; empty: the same
};

[[nodiscard]] const std::vector<Identity>& identities();

/// The identity between an [[output]] y and one of its derivatives. For a frame, y is a pose, and
/// its twist replaces dy/dt; then quaternions must have norm 1.
struct OutputIdentity {
  OutputKind derivative;
  std::string_view check;
  std::string_view formula;
  std::string_view formula_of_frame;
  Balance (*balance)(ExactValues& at, std::uint32_t user);
};

[[nodiscard]] const std::vector<OutputIdentity>& output_identities();

/// Terms of a balance: factor times the sum of `per_entry` consecutive values, entry by entry.
struct BalanceTerms {
  std::vector<Real> values = {};
  int factor = 1;
  std::size_t per_entry = 1;
};

/// The sum of all terms; the first element determines the number of entries.
[[nodiscard]] Balance balance_of(const std::vector<BalanceTerms>& all);

/// A unit displacement along velocity i.
[[nodiscard]] Arguments<Real> unit_position(const ExactValues& at, std::size_t i);

}  // namespace elgen
