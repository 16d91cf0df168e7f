// Diagnostics of singular matrices: the error depends on the kind of output, and on the row without
// a pivot if the row is known.
#include "inspect/singular_mass.hpp"

#include <catch2/catch.hpp>

namespace elgen::test {
namespace {

/// The message about a singular matrix of `kind`; empty for M, because another message reports M.
std::string message_of(OutputKind kind, const std::optional<std::size_t>& row) {
  LeafNames names;
  names.multipliers = {"loop", "rod"};
  const OutputRequest request{.kind = kind, .name = "x"};
  const auto fault = singular_system_error(request, row, names);
  return fault ? std::string(code_row(fault->code).name) + " " + fault->message : "";
}

}  // namespace

TEST_CASE("a row of A without a pivot is a redundant constraint, unless the output has its own A") {
  const std::string of_rod =
      "E537 `x` has no value: the constraint `rod` follows from earlier constraints, whatever the "
      "state is";
  CHECK(message_of(OutputKind::forward_dynamics, 1) == of_rod);
  CHECK(message_of(OutputKind::constrained_inverse_dynamics, 1) == of_rod);
  CHECK(message_of(OutputKind::completed, 1) ==
        "E603 `x` has no value: the independent velocities do not determine the others");
  CHECK(message_of(OutputKind::user_operational, 1) ==
        "E603 `x` has no value: row 2 of the Jacobian follows from earlier rows, whatever the "
        "state is");
}

TEST_CASE("a singular matrix without a known row is M, unless the output is solved for inputs") {
  CHECK(message_of(OutputKind::forward_dynamics, {}).empty());
  CHECK(message_of(OutputKind::user_operational, {}).empty());
  CHECK(message_of(OutputKind::constrained_inverse_dynamics, {}) ==
        "E603 `x` has no value: under the constraints some input moves nothing, or only what other "
        "inputs move");
}

}  // namespace elgen::test
