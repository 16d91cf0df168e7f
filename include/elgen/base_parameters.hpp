// BaseParameters: the combinations of inertial parameters pi that measured forces can identify. The
// regressor Y of tau = Y pi + rest is stacked at many states. A column Y_j that is a linear
// combination of earlier columns Y_k is eliminated: multiples of pi_j are added to the parameters
// pi_k of these columns:
//
//     Y pi = sum over kept columns k of  Y_k (pi_k + sum_j factor_kj pi_j)
//
// The factors are the reduced row echelon form of the stacked Y, which is unique for the order of
// pi. Each parameter without a column of its own is thus regrouped towards the base of the robot
// (Khalil, Dombre, Modeling, Identification and Control of Robots, 2002, chapter 9).
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
  cln::cl_R value = 0;  ///< at the parameter values of the model
};

struct BaseParameters {
  std::vector<InertialParameter> parameters = {};
  std::vector<BaseParameter> base = {};
  std::vector<std::uint32_t> unidentifiable = {};  ///< parameters whose column of Y is 0
  std::size_t states = 0;                          ///< number of states at which Y was evaluated
  /// True: factors are rational. False: they are floats, and factors below 1e-100 of the largest
  /// are 0.
  bool is_exact = false;
};

/// The requests of the functions that find_base_parameters() needs.
[[nodiscard]] std::vector<OutputRequest> outputs_for_base_parameters(const Model& model);

/// The base parameters, from Y at random states with the geometric parameters of the model. Y is
/// computed in the finite field of 2^521 - 1 elements, in which ranks are exact. There the sine and
/// cosine of an angle are a random point of the unit circle. If a constant is neither rational nor
/// the sine of a multiple of pi/2, numbers have 160 digits instead. E603: the model has no
/// regressor. E521: the regressor has no value at any state.
[[nodiscard]] Result<BaseParameters> find_base_parameters(const AnalysisInput& input);

}  // namespace elgen
