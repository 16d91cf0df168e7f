// Expansion: the motions of a scene that expands energies and forces about a point.
//
//     q0 + s (q - q0),  s v,  s a,  u0 + s (u - u0)       for what is small, the rest as it is
//
// Taylor's formula in s to some order, at s = 1, is the joint expansion in all deviations. That is
// all the oracle knows of it: no term of an expansion is ever written down.
#pragma once

#include <optional>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/oracle.hpp"
#include "oracle/evaluation.hpp"

namespace elgen::oracle {

/// Values of what is small; none for the rest.
struct ExpansionPoint {
  unsigned order = 1;
  std::vector<std::optional<cln::cl_R>> q = {};
  std::vector<std::optional<cln::cl_R>> v = {};
  std::vector<std::optional<cln::cl_R>> u = {};
};

/// The point at the parameters of a state; none where the model is exact.
[[nodiscard]] std::optional<ExpansionPoint> expansion_point(const Model& model, const State& state);

/// The motion above, with powers of s up to `order`.
[[nodiscard]] Motion towards(const ExpansionPoint& point, const Motion& motion, unsigned order);

}  // namespace elgen::oracle
