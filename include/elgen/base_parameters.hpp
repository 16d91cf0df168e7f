// BaseParameters: the combinations of inertial parameters pi that forces determine. The columns of
// Y at all states together have a rank. A column that depends on earlier columns is added to them:
//
//     Y pi = sum over kept columns k of  Y_k (pi_k + sum_j factor_kj pi_j)
//
// This is the reduced row echelon form of Y at many states, which is unique in the order of pi.
// Later parameters are thus regrouped towards the base (Khalil, Dombre, Modeling, Identification
// and Control of Robots, 2002, chapter 9).
#pragma once

#include <cln/real.h>

#include <cstdint>
#include <string>
#include <vector>

#include "elgen/analyse.hpp"
#include "elgen/diagnostic.hpp"
#include "elgen/inertial_parameters.hpp"

namespace elgen {

/// factor pi_parameter
struct WeightedParameter {
  std::uint32_t parameter = 0;
  cln::cl_R factor = 1;
};

/// A kept column: value = pi_parameter + the sum of `others`.
struct BaseParameter {
  std::uint32_t parameter = 0;
  std::vector<WeightedParameter> others = {};
  cln::cl_R value = 0;  ///< at the parameter values of the model
};

struct BaseParameters {
  std::vector<InertialParameter> parameters = {};
  std::vector<BaseParameter> base = {};
  std::vector<std::uint32_t> without_effect = {};  ///< parameters with a zero column
  std::size_t states = 0;                          ///< at which Y was evaluated
  /// Factors are rational; otherwise floats, with 0 below 1e-100 of the largest.
  bool is_exact = false;
};

/// The requests of the functions that find_base_parameters() needs.
[[nodiscard]] std::vector<OutputRequest> outputs_of_base_parameters(const Model& model);

/// Evaluates Y at random states, with the geometry of the model. Sines and cosines are points of
/// the unit circle over the field of 2^521 - 1 elements, in which the rank is exact. If a constant
/// is neither rational nor the sine of a multiple of pi/2, numbers have 160 digits instead. E603:
/// the model has no regressor. E521: the regressor has no value at any state.
[[nodiscard]] Result<BaseParameters> find_base_parameters(const AnalysisInput& input);

}  // namespace elgen
