// signature: the start of a declaration and its arguments -> the declaration, with line breaks.
//
//     [[nodiscard]] Forces<Scalar> bias(const Parameters<Scalar>& p, const Coordinates<Scalar>& q,
//                                       const Velocities<Scalar>& v) noexcept
#pragma once

#include <string>
#include <vector>

namespace elgen {

/// `start` ends before the bracket, `end` (" noexcept") follows the closing one.
[[nodiscard]] std::string signature(const std::string& start,
                                    const std::vector<std::string>& arguments,
                                    const std::string& end);

}  // namespace elgen
