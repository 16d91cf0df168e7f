// BaseParameters: the combinations of inertial parameters pi that measured forces can identify. The
// regressor Y of tau = Y pi + rest is stacked at many states. A column Y_j that is a linear
// combination of earlier columns Y_k is eliminated: multiples of pi_j are added to the parameters
// pi_k of these columns:
//
//     Y pi = sum over kept columns k of  Y_k (pi_k + sum_j factor_kj pi_j)
//
// The factors are entries of the reduced row echelon form of the stacked Y, which is unique for the
// order of pi. Each parameter of an eliminated column is thus regrouped into parameters nearer to
// the robot's base (Khalil, Dombre, Modeling, Identification and Control of Robots, 2002, ch. 9).
#pragma once

#include <cln/real.h>

#include <cstdint>
#include <string>
#include <vector>

#include "elgen/analyse.hpp"
#include "elgen/diagnostic.hpp"
#include "elgen/inertial_parameters.hpp"

namespace elgen {

/// The product factor * pi[parameter].
struct WeightedParameter {
  std::uint32_t parameter = 0;
  cln::cl_R factor = 1;
};

/// The base parameter of a kept column: value = pi[parameter] + the sum of `regrouped_terms`.
struct BaseParameter {
  std::uint32_t parameter = 0;
  std::vector<WeightedParameter> regrouped_terms = {};
  cln::cl_R value = 0;  ///< base parameter at the parameter values of the model
};

struct BaseParameters {
  std::vector<InertialParameter> parameters = {};
  std::vector<BaseParameter> base = {};
  std::vector<std::uint32_t> unidentifiable = {};  ///< indices k of parameters with Y_k = 0
  std::size_t states = 0;                          ///< number of states at which Y was evaluated
  /// True: all factors are rational. False: all factors are floats; each row of Y is scaled to the
  /// largest entry 1, and entries below 1e-100 count as 0.
  bool is_exact = false;
};

/// The requests of the functions that find_base_parameters() needs.
[[nodiscard]] std::vector<OutputRequest> outputs_for_base_parameters(const Model& model);

/// The base parameters, from Y at random states with the geometric parameters of the model. Y is
/// computed in the finite field of 2^521 - 1 elements, in which ranks are exact. In this field, the
/// sine and cosine of an angle are a random point of the unit circle. If Y contains an irrational
/// constant, a root or a function besides sine and cosine, or if a factor is not rational, Y is
/// computed in 160 digits instead. E603: the model has no regressor. E521: the regressor has no
/// value at more than 95 % of the drawn states.
[[nodiscard]] Result<BaseParameters> find_base_parameters(const AnalysisInput& input);

}  // namespace elgen
