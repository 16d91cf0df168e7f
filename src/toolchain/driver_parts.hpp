// What the drivers of all languages are put together from.
#pragma once

#include "toolchain/driver.hpp"

namespace elgen {

/// "  result.l[1] = values[3];" for every run-time parameter, in the order of the program's leaves.
[[nodiscard]] std::string parameter_assignments(const DriverInput& input);

/// Where the header has entry (i, j) of a result: the driver gives them row by row.
[[nodiscard]] std::string_view stored_position(const Scene& scene);

/// "  append(to, result.gravity.data(), 2, 1);" for each field; `data` gives the address of one.
[[nodiscard]] std::string appended(const DriverInput& input, const Function& function,
                                   std::string_view to, std::string_view data);

/// "const double* parameters, const double* q, …, double t, ": what a driver function declares
/// before its result, each after `attribute`.
[[nodiscard]] std::string declared_leaves(std::string_view scalar, std::string_view attribute = "");

/// The drivers of C++17, on arrays of states and in Eigen's types too, and of C99.
[[nodiscard]] std::string cpp_driver(const DriverInput& input);
[[nodiscard]] std::string eigen_driver(const DriverInput& input);
[[nodiscard]] std::string batch_driver(const DriverInput& input);
[[nodiscard]] std::string c99_driver(const DriverInput& input);

}  // namespace elgen
