// state_text: numbers as decimals, and a state in JSON as arguments of functions.
#pragma once

#include <cln/real.h>

#include <string>
#include <vector>

#include "elgen/leaves.hpp"
#include "elgen/model.hpp"

namespace elgen {

/// The number rounded correctly to `digits` significant digits, without trailing zeros: "9.81",
/// "2.0", "1e-300".
[[nodiscard]] std::string decimal_text(const cln::cl_R& value, int digits);

/// The same for each value, separated by ", ".
[[nodiscard]] std::string decimal_texts(const std::vector<cln::cl_R>& values, int digits);

/// The members of an object, one per kind, named like the arguments of functions:
///
///     "p": {"m": 1.0, "l": [2.0, 3.0]}, "q": [0.1], "t": 0.0
///
/// It has all parameters of the model, even those that a function does not read.
[[nodiscard]] std::string state_json(const Model& model, const LeafValues<cln::cl_R>& state,
                                     const std::vector<Opcode>& kinds, int digits);

}  // namespace elgen
