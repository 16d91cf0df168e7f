// The methods of step_methods.def, each composed as its textbook has it.
#pragma once

#include <vector>

#include "elgen/scene.hpp"
#include "program/steps/composition.hpp"

namespace elgen {

/// Where a step is composed, and from what.
struct StepContext {
  /// `the_calls` has what needed_for_step says of `request`. All arguments outlive it.
  StepContext(const CheckedModel& checked, const OutputRequest& request, const Program& the_calls,
              Composition& composition);

  /// t + c; of no meaning where the model does not know t.
  [[nodiscard]] std::uint32_t time_after(std::uint32_t c) const;
  /// t + c h, likewise.
  [[nodiscard]] std::uint32_t time_at(const cln::cl_RA& c) const;
  /// c h
  [[nodiscard]] std::uint32_t part(const cln::cl_RA& c) const;
  /// Calls what was computed of q and v by the number of the point.
  void name(const CallPoint& at) const;

  const Model& model;
  const Program& calls;
  Composition& compose;
  bool has_inner;                 ///< accelerations in float
  std::size_t directions;         ///< along which explicit methods take tangents; 0: none
  std::uint32_t iterations;       ///< of an implicit method
  std::vector<cln::cl_RA> parts;  ///< of h, over which a symmetric method goes in turn
  std::uint32_t h;
  CallPoint start;
  std::uint32_t half;  ///< h/2
};

/// The values of q and v after a step.
struct NextState {
  Places q = {};
  Places v = {};
  Places residual = {};              ///< of an implicit method
  std::vector<Places> columns = {};  ///< d(q, v) along each direction of q, v, u, where asked for
};

/// The columns of A and B of x(t + h) = Phi(x, u) about a state, x = (dq, v), appended to `step`,
/// which has the coordinates and rates of Phi: exact for its instructions, iterations and scalings
/// of quaternions among them. `calls` has coordinate_rates where the model has rotations. Cost:
/// about the step again for each column.
[[nodiscard]] std::vector<Places> step_columns(const Model& model, const Program& calls,
                                               const Function& step, Composition& compose);

#define ELGEN_STEP_METHOD(name, domain, order, iterations, doc, equation) \
  [[nodiscard]] NextState compose_##name(const StepContext& step);
#include "elgen/step_methods.def"
#undef ELGEN_STEP_METHOD

}  // namespace elgen
