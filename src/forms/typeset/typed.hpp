// typed: what the author of a model wrote that closed forms do not keep: which sums stand together,
// in which order and with which signs, and in which order the parameters of a product stand.
#pragma once

#include <optional>
#include <vector>

#include "elgen/closed_forms.hpp"
#include "elgen/model.hpp"

namespace elgen {

/// A sum of the energies, forces, points or definitions: r - l0.
struct TypedSum {
  Polynomial value = {};
  std::vector<AtomId> atoms = {};    ///< of the value, ascending
  Polynomial square = {};            ///< where roots disappear from it: of sqrt(x^2 + y^2) - l
  std::vector<Fraction> terms = {};  ///< as typed, with their signs
  /// The definition whose value it is, in Model::definitions.
  std::optional<std::uint32_t> definition = {};
};

struct TypedForms {
  std::vector<TypedSum> sums = {};  ///< those of more terms first; each once
  /// The place of each parameter among the factors of a product: as typed in products of the model,
  /// else as declared, gravity behind the masses (m g l).
  std::vector<std::uint32_t> places = {};
  std::vector<bool> are_accelerations = {};  ///< of the parameters; g
};

/// Cost: one closed form per typed sum; models of more than 200 sums, which are robots, have none.
[[nodiscard]] TypedForms typed_forms(Algebra& algebra, const Model& model,
                                     const FixedParameters& fixed);

}  // namespace elgen
