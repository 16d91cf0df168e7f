// state_text: numbers in decimal digits, and a state in JSON as functions take it.
#pragma once

#include <cln/real.h>

#include <string>
#include <vector>

#include "elgen/leaves.hpp"
#include "elgen/model.hpp"

namespace elgen {

/// Correctly rounded to so many significant digits, without trailing zeros: "9.81", "2.0",
/// "1e-300".
[[nodiscard]] std::string decimal_text(const cln::cl_R& value, int digits);

/// The same of each, separated by ", ".
[[nodiscard]] std::string decimal_texts(const std::vector<cln::cl_R>& values, int digits);

/// The members of an object, one for each kind, under the symbol that functions give it:
///
///     "p": {"m": 1.0, "l": [2.0, 3.0]}, "q": [0.1], "t": 0.0
///
/// All parameters of the model are there, whichever a function reads.
[[nodiscard]] std::string state_json(const Model& model, const LeafValues<cln::cl_R>& state,
                                     const std::vector<Opcode>& kinds, int digits);

}  // namespace elgen
