// Residues: values of functions modulo a prime, at states of random residues. An angle is a residue
// with a point (cosine, sine) of the circle beside it, which is all that polynomials tell of it.
#pragma once

#include <cln/modinteger.h>

#include <optional>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "sample/points.hpp"

namespace elgen {

/// The field of 2^521 - 1 elements.
[[nodiscard]] const cln::cl_modint_ring& residue_field();

/// n/d modulo the prime.
[[nodiscard]] cln::cl_MI residue_of(const cln::cl_RA& number);

/// The one rational number with numerator and denominator below 2^250 that has the residue; none
/// where there is none.
[[nodiscard]] std::optional<cln::cl_RA> rational_of(const cln::cl_MI& residue);

struct PointOfCircle {
  cln::cl_MI cosine;
  cln::cl_MI sine;
};

/// Without a value it has none that is known.
struct Residue {
  std::optional<cln::cl_MI> value = {};
  std::optional<PointOfCircle> angle = {};
};

/// The entries of a function at a random state, parameters at their values; undefined entries where
/// a constant or a function is not of the field.
[[nodiscard]] std::vector<Residue> residues_of(const Model& model, const Program& program,
                                               const Function& function, Sampler& draw);

}  // namespace elgen
