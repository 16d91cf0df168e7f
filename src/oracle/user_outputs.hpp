// Values of [[output]]s at one state: entries, Jacobians, derivatives, operational-space dynamics.
#pragma once

#include <vector>

#include "elgen/oracle.hpp"

namespace elgen::oracle {

using Values = std::vector<cln::cl_R>;

/// A request for an output of a model at a state.
struct OutputQuery {
  const Model& model;
  const OutputRequest& output;
  const State& state;

  [[nodiscard]] const UserOutput& of_user() const { return model.outputs[output.user]; }
  [[nodiscard]] bool is_twist() const { return of_user().frame.has_value(); }
  [[nodiscard]] const std::vector<ExpressionId>& differentiated() const {
    return is_twist() ? of_user().twist : of_user().values;
  }
};

/// w.x, or w.X y of a matrix.
[[nodiscard]] cln::cl_R contracted_entries(const Values& values, const Contraction& by);

/// The values y of the output.
[[nodiscard]] Values values_of_user(const OutputQuery& of);

/// dy/dq along N; for a frame the derivative of its twist by v.
[[nodiscard]] Values jacobian_of_user(const OutputQuery& of);

/// d2y/dt2 at a = 0; for a frame d/dt of its twist at a = 0.
[[nodiscard]] Values bias_of_user(const OutputQuery& of);

/// dy/dq along N, dy/dv, dy/da, dy/du, one after another.
[[nodiscard]] Values all_derivatives_of_user(const OutputQuery& of);
[[nodiscard]] cln::cl_R contracted_derivatives(const OutputQuery& of, const Contraction& by);

/// Operational-space dynamics: Lambda = (J M^-1 J^T)^-1, M^-1 J^T Lambda, Lambda (J M^-1 bias -
/// bias of y), and the relative pivots of J M^-1 J^T.
[[nodiscard]] Values operational_of_user(const OutputQuery& of);
[[nodiscard]] cln::cl_R contracted_operational(const OutputQuery& of, const Contraction& by);

}  // namespace elgen::oracle
