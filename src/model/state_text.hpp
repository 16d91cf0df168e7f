// state_text: numbers as decimals, and a state as JSON arguments of functions.
#pragma once

#include <cln/real.h>

#include <string>
#include <vector>

#include "elgen/leaves.hpp"
#include "elgen/model.hpp"

namespace elgen {

/// The number correctly rounded to `digits` significant digits, without trailing zeros: "9.81",
/// "2.0", "1e-300".
[[nodiscard]] std::string rounded_decimal_text(const cln::cl_R& value, int digits);

/// rounded_decimal_text() of each value, separated by ", ".
[[nodiscard]] std::string rounded_decimal_texts(const std::vector<cln::cl_R>& values, int digits);

/// The members of a JSON object, one per kind, named like the arguments of functions:
///
///     "p": {"m": 1.0, "l": [2.0, 3.0]}, "q": [0.1], "t": 0.0
///
/// All parameters of the model are included, although a function may not use all of them.
[[nodiscard]] std::string state_json(const Model& model, const LeafValues<cln::cl_R>& state,
                                     const std::vector<Opcode>& kinds, int digits);

}  // namespace elgen
