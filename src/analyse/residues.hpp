// Residues: values of functions modulo a prime, at states of random residues. An angle has a random
// residue and a random point (cosine, sine) of the circle. The two need not match, because no
// polynomial relates an angle to its cosine and sine.
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

/// The residue of the fraction `number` = n/d: n times the inverse of d, modulo the prime.
[[nodiscard]] cln::cl_MI residue_of(const cln::cl_RA& number);

/// The unique rational number with numerator and denominator below 2^250 that has this residue, if
/// it exists.
[[nodiscard]] std::optional<cln::cl_RA> reconstruct_rational(const cln::cl_MI& residue);

struct CirclePoint {
  cln::cl_MI cosine;
  cln::cl_MI sine;
};

/// A real number x modulo the prime: `value` is x, `angle` has cos(x) and sin(x). A member is none
/// if it is unknown: `value` for x = pi, and `angle` for x = 1.
struct Residue {
  std::optional<cln::cl_MI> value = {};
  std::optional<CirclePoint> angle = {};
};

/// The entries of a function at a random state, with the parameters of the model. An entry has no
/// value if it depends on an irrational constant, a root or a function other than sine and cosine.
[[nodiscard]] std::vector<Residue> sample_residues(const Model& model, const Program& program,
                                                   const Function& function, Sampler& sampler);

}  // namespace elgen
