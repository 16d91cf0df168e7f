// BaseParameters: what of the inertial parameters pi can be told from forces. The columns of Y at
// all states together have a rank; a column that is a combination of those before it goes to them:
//
//     Y pi = sum over kept columns k of  Y_k (pi_k + sum_j factor_kj pi_j)
//
// which is the reduced row echelon form of Y at many states, unique in the order of pi. Later
// parameters are thus regrouped towards the base (Khalil, Dombre, Modeling, Identification and
// Control of Robots, 2002, chapter 9).
#pragma once

#include <cln/real.h>

#include <cstdint>
#include <string>
#include <vector>

#include "elgen/analyse.hpp"
#include "elgen/diagnostic.hpp"
#include "elgen/inertial_parameters.hpp"

namespace elgen {

/// factor times a parameter, by its number.
struct WeighedParameter {
  std::uint32_t parameter = 0;
  cln::cl_R factor = 1;
};

/// A parameter whose column is kept, and what others add to it.
struct BaseParameter {
  std::uint32_t parameter = 0;
  std::vector<WeighedParameter> others = {};
  cln::cl_R value = 0;  ///< at the values of the model
};

struct BaseParameters {
  std::vector<InertialParameter> parameters = {};
  std::vector<BaseParameter> base = {};
  std::vector<std::uint32_t> without_effect = {};  ///< their columns are 0
  std::size_t states = 0;                          ///< at which Y was evaluated
  bool is_exact = false;  ///< factors are rational; else floats, 0 below 1e-100 of the largest
};

/// The outputs that it needs.
[[nodiscard]] std::vector<OutputRequest> outputs_of_base_parameters(const Model& model);

/// At the values of the geometry, over random states. Sines and cosines are points of the circle
/// over a field of 2^521 - 1 elements, in which the rank is exact; where a constant is neither
/// rational nor the sine of a multiple of pi/2, numbers have 160 digits. E603 where the model has
/// no regressor; E521 where no state has a value.
[[nodiscard]] Result<BaseParameters> find_base_parameters(const AnalysisInput& input);

}  // namespace elgen
