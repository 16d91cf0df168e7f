// cpp_types: the types of fields.
#include "emit/cpp/cpp_types.hpp"

#include "fixture.hpp"

using namespace elgen;

TEST_CASE("types of fields") {
  const Field vector{"", 2, 1, {0, 0}};
  const Field one{"", 1, 1, {0}};
  CHECK(field_type(OutputKind::coriolis_matrix, {"", 2, 2, {}}) == "SquareMatrix<Scalar>");
  CHECK(field_type(OutputKind::bias, vector) == "Forces<Scalar>");
  CHECK(field_type(OutputKind::bias, one) == "Forces<Scalar>");  // of one coordinate
  CHECK(field_type(OutputKind::total_energy, one) == "Scalar");
  CHECK(field_type(OutputKind::user_value, vector) == "std::array<Scalar, 2>");
  CHECK(field_type(OutputKind::user_value, one) == "Scalar");
  CHECK(field_type(OutputKind::user_jacobian, {"", 3, 2, {}}) ==
        "std::array<Scalar, 3 * velocity_count>");
}
