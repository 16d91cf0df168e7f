// The methods of step_methods.def, each composed as in its textbook.
#pragma once

#include <vector>

#include "elgen/integrate.hpp"
#include "elgen/scene.hpp"
#include "program/steps/composition.hpp"

namespace elgen {

/// The model, the called outputs, and the values from which a step is composed.
struct StepContext {
  /// All arguments must outlive this object.
  StepContext(const CheckedModel& checked, const OutputRequest& request,
              const StepCallees& the_calls, Composition& the_composition);

  /// t + c; 0 and unused if the model does not contain t.
  [[nodiscard]] std::uint32_t time_after(std::uint32_t c) const;
  /// t + c h; 0 and unused if the model does not contain t.
  [[nodiscard]] std::uint32_t time_at_fraction(const cln::cl_RA& c) const;
  /// c h
  [[nodiscard]] std::uint32_t step_multiple(const cln::cl_RA& c) const;
  /// Names computed entries of q and v, with the number of the point.
  void name_entries(const CallPoint& at) const;

  const Model& model;
  const Program& callees;
  Composition& composition;
  bool has_float_accelerations;   ///< accelerations are computed in float
  bool has_open_accelerations;    ///< those of stage k are the leaves a_(k n), a_(k n + 1), ...
  std::size_t direction_count;    ///< number of tangents of explicit methods; 0: none
  std::uint32_t iterations;       ///< of an implicit method
  std::vector<cln::cl_RA> parts;  ///< steps of a composed symmetric method, in units of h
  std::uint32_t h;
  CallPoint start;
  std::uint32_t half_step;  ///< h/2
};

/// The values of q and v after a step.
struct NextState {
  InstructionIndices q = {};
  InstructionIndices v = {};
  InstructionIndices residual = {};  ///< of an implicit method; otherwise empty
  /// The tangents of (q, v) for each direction of q, v, u; empty if the method has no tangents.
  std::vector<InstructionIndices> columns = {};
  std::vector<CallPoint> stages = {};  ///< the points of open accelerations, in order
};

/// The columns of A, then the columns of B: dx(t + h) = A dx + B du, dx = (dq, dv) with rotation
/// vectors in dq. The derivatives of the instructions of `step` are exact, including iterations and
/// scalings of quaternions. Appends to the function of `compose`, which must begin with these
/// instructions. `calls` needs coordinate_rates for rotations. Cost: about one step per column.
[[nodiscard]] std::vector<InstructionIndices> step_jacobian_columns(const Model& model,
                                                                    const Program& calls,
                                                                    const Function& step,
                                                                    Composition& compose);

/// The same columns, if the accelerations of `step` at `stages` are open. Its instructions and the
/// parts `calls.acceleration_parts` are added to `compose`. Cost: at each stage one call of the
/// parts; per column and stage one solution with M, and products with n x n matrices: at most two
/// for rk4, one for each earlier stage for verlet.
[[nodiscard]] std::vector<InstructionIndices> stage_jacobian_columns(
    const Model& model, const StepCallees& calls, const Function& step,
    const std::vector<CallPoint>& stages, Composition& compose);

#define ELGEN_STEP_METHOD(name, domain, order, iterations, doc, equation) \
  [[nodiscard]] NextState compose_##name(const StepContext& step);
#include "elgen/step_methods.def"
#undef ELGEN_STEP_METHOD

}  // namespace elgen
