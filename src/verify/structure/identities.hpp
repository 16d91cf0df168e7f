// The tables of identities between the functions of a program, and what their balances share.
#pragma once

#include <string_view>
#include <vector>

#include "program/evaluate/exact_values.hpp"

namespace elgen {

struct Identity {
  std::string_view check;
  std::string_view formula;
  std::vector<OutputKind>
      functions;  ///< which the program must have; the first is the row's subject
  Balance (*balance)(ExactValues& at);        ///< the left side less the right side
  std::string_view constrained_formula = {};  ///< with constraints, where it is another
};

[[nodiscard]] const std::vector<Identity>& identities();

/// The identity between an [[output]] y and a derivative of it. Of a frame y is a pose, and its
/// twist stands for dy/dt: quaternions must be of norm 1 then.
struct OutputIdentity {
  OutputKind derivative;
  std::string_view check;
  std::string_view formula;
  std::string_view formula_of_frame;
  Balance (*balance)(ExactValues& at, std::uint32_t user);
};

[[nodiscard]] const std::vector<OutputIdentity>& output_identities();

/// Terms of a balance: factor times so many values in each entry, one entry after another.
struct BalanceTerms {
  std::vector<Real> values = {};
  int factor = 1;
  std::size_t per_entry = 1;
};

/// The sum of all terms; the first of them say how many entries there are.
[[nodiscard]] Balance balance_of(const std::vector<BalanceTerms>& all);

/// A unit displacement along velocity i.
[[nodiscard]] Arguments<Real> unit_position(const ExactValues& at, std::size_t i);

}  // namespace elgen
