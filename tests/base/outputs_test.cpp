// The output table: one row per kind in the order of the enumeration, names unique, later names
// absent.
#include "elgen/outputs.hpp"

#include <catch2/catch.hpp>
#include <set>

namespace elgen {
namespace {

TEST_CASE("rows stand in the order of the enumeration") {
  REQUIRE(output_table().size() == static_cast<std::size_t>(OutputKind::dynamics) + 1);
  for (std::size_t i = 0; i < output_table().size(); ++i) {
    CHECK(static_cast<std::size_t>(output_table()[i].kind) == i);
  }
}

TEST_CASE("names are unique and found") {
  std::set<std::string_view> names;
  for (const OutputRow& row : output_table()) {
    CHECK(names.insert(row.name).second);
    CHECK_FALSE(row.doc.empty());
  }
  REQUIRE(find_output("bias") != nullptr);
  CHECK(find_output("bias")->kind == OutputKind::bias);
  CHECK(find_output("") == nullptr);
  CHECK(find_output("_jacobian") == nullptr);
  CHECK(find_output("mass_matrx") == nullptr);
}

TEST_CASE("arguments and shapes follow the equations") {
  const OutputRow& mass = output_row(OutputKind::mass_matrix);
  CHECK(mass.takes == LeafSet());
  CHECK(mass.fields.front().columns == Extent::velocities);
  const OutputRow& inverse = output_row(OutputKind::inverse_dynamics);
  CHECK(inverse.takes == (Opcode::velocity | Opcode::acceleration));
  const OutputRow& forward = output_row(OutputKind::forward_dynamics);
  CHECK(forward.takes == (Opcode::velocity | Opcode::input));
  REQUIRE(forward.fields.size() == 2);
  CHECK(forward.fields[1].name == "relative_pivots");
  CHECK(output_row(OutputKind::input_matrix).fields.front().columns == Extent::inputs);
}

TEST_CASE("what needs a quadratic Lagrangian says so") {
  for (const OutputKind kind : {OutputKind::coriolis_matrix, OutputKind::velocity_force,
                                OutputKind::gravity, OutputKind::drift}) {
    CHECK(output_row(kind).requirement == Requirement::quadratic);
  }
  for (const OutputKind kind : {OutputKind::mass_matrix, OutputKind::bias, OutputKind::momentum,
                                OutputKind::energy_function}) {
    CHECK(output_row(kind).requirement == Requirement::nothing);
  }
}

}  // namespace
}  // namespace elgen
