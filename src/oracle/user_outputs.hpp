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

  [[nodiscard]] const UserOutput& user_output() const { return model.outputs[output.user]; }
  [[nodiscard]] bool is_twist() const { return user_output().frame.has_value(); }
  [[nodiscard]] const std::vector<ExpressionId>& differentiated_values() const {
    return is_twist() ? user_output().twist : user_output().values;
  }
};

/// The values y of the output.
[[nodiscard]] Values user_output_values(const OutputQuery& query);

/// dy/dq along N; for a frame, d(twist)/dv.
[[nodiscard]] Values user_output_jacobian(const OutputQuery& query);

/// d2y/dt2 at a = 0; for a frame d/dt of its twist at a = 0.
[[nodiscard]] Values user_output_bias(const OutputQuery& query);

/// dy/dq along N, dy/dv, dy/da, dy/du, one after another.
[[nodiscard]] Values user_output_derivatives(const OutputQuery& query);

/// Operational-space dynamics: Lambda = (J M^-1 J^T)^-1, M^-1 J^T Lambda, Lambda (J M^-1 bias -
/// bias of y), and the relative pivots of J M^-1 J^T.
[[nodiscard]] Values user_operational_dynamics(const OutputQuery& query);

}  // namespace elgen::oracle
