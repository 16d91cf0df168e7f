// Points of rest in files: `{ theta = "acos(g/(R*Omega^2))", u = 0 }`, in an [[equilibrium]] of a
// model and in `about` of a scene.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "check/expressions/values.hpp"
#include "check/names/context.hpp"

namespace elgen {

/// A table of values at a point: the names that the table accepts, and the error for other names.
struct PointTable {
  ExpressionRole role = {};  ///< the place of each value
  bool takes_coordinates = true;
  bool takes_inputs = true;
  Code error_code = Code::E612;
};

/// Indices in the Model of the variables that a name denotes: "q": all q[i]; "q[2]": only q[2].
struct NamedVariables {
  std::vector<std::uint32_t> coordinates = {};
  std::vector<std::uint32_t> inputs = {};

  [[nodiscard]] bool empty() const { return coordinates.empty() && inputs.empty(); }
};

/// The variables that `name` denotes. Empty after an error: the name is unknown, or belongs to a
/// rotation.
[[nodiscard]] NamedVariables find_variables(Context& context, const PointTable& table,
                                            const std::string& name, const Span& span);

/// Reads one key of the table into the point, whose lists have the sizes of the model's lists.
/// Returns the variables that get the value.
NamedVariables read_point_value(ValueReader& values, const PointTable& table, const KeySyntax& key,
                                OperatingPoint& point);

}  // namespace elgen
