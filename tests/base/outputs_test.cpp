// The tables of outputs, limits and scalars: one row per kind in the order of the enumeration, and
// unique names.
#include "elgen/outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <sstream>

#include "elgen/limits.hpp"
#include "elgen/scalars.hpp"

namespace elgen::test {

namespace {

/// A different size for each dimension, so that mistaken extents are noticed.
std::size_t size_of(Extent extent) {
  switch (extent) {
    case Extent::one:
    case Extent::user_columns:
      return 1;
    case Extent::coordinates:
      return 7;
    case Extent::velocities:
    case Extent::accelerations:
      return 5;
    case Extent::states:
      return 10;
    case Extent::inputs:
      return 3;
    case Extent::reaction:
      return 11;
    case Extent::cyclic:
      return 17;
    case Extent::constraints:
      return 2;
    case Extent::positions:
      return 19;
    case Extent::pivots:
      return 23;
    case Extent::inertial:
      return 29;
    case Extent::user:
    case Extent::task:
      return 13;
  }
  return 0;
}

/// The number of scalars in the C++ type `type` of the table, as emitted headers define the type.
std::size_t size_of(const std::string& type) {
  static const std::map<std::string, std::size_t> known{{"Scalar", 1},
                                                        {"Coordinates<Scalar>", 7},
                                                        {"Velocities<Scalar>", 5},
                                                        {"Forces<Scalar>", 5},
                                                        {"Accelerations<Scalar>", 5},
                                                        {"Inputs<Scalar>", 3},
                                                        {"velocity_count", 5},
                                                        {"coordinate_count", 7},
                                                        {"input_count", 3},
                                                        {"constraint_count", 2},
                                                        {"Multipliers<Scalar>", 2},
                                                        {"pivots", 23},
                                                        {"SquareMatrix<Scalar>", 25},
                                                        {"InputMatrix<Scalar>", 15}};
  const std::string array = "std::array<Scalar, ";
  if (!type.starts_with(array)) return known.at(type);
  std::size_t size = 1;
  std::istringstream factors(type.substr(array.size(), type.size() - array.size() - 1));
  for (std::string factor; factors >> factor;) {
    if (factor == "*") continue;
    size *= known.count(factor) > 0 ? known.at(factor) : std::stoul(factor);
  }
  return size;
}

}  // namespace

TEST_CASE("rows are in the order of the enumeration") {
  REQUIRE(output_table().size() == static_cast<std::size_t>(OutputKind::step_derivatives) + 1);
  for (std::size_t i = 0; i < output_table().size(); ++i) {
    CHECK(static_cast<std::size_t>(output_table()[i].kind) == i);
  }
}

TEST_CASE("names are unique, and rows are found by name") {
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

TEST_CASE("arguments and shapes agree with the equations") {
  const OutputRow& mass = output_row(OutputKind::mass_matrix);
  CHECK(mass.argument_kinds == LeafSet());
  CHECK(mass.fields.front().columns == Extent::velocities);
  const OutputRow& inverse = output_row(OutputKind::inverse_dynamics);
  CHECK(inverse.argument_kinds == (Opcode::velocity | Opcode::acceleration));
  const OutputRow& forward = output_row(OutputKind::forward_dynamics);
  CHECK(forward.argument_kinds == (Opcode::velocity | Opcode::input));
  REQUIRE(forward.fields.size() == 3);
  CHECK(forward.fields[1].name == "relative_pivots");
  CHECK(output_row(OutputKind::input_matrix).fields.front().columns == Extent::inputs);
}

TEST_CASE(
    "functions of momenta are emitted only if named, and never grouped with functions of "
    "velocities") {
  for (const OutputKind kind : {OutputKind::hamiltonian, OutputKind::velocities_of_momenta,
                                OutputKind::hamilton_equations}) {
    CHECK(is_omitted_by_full(output_row(kind)));
    CHECK(divides_by_mass(output_row(kind)));
    CHECK_FALSE(is_in_dynamics(kind, output_row(kind).argument_kinds));
  }
  CHECK(is_in_dynamics(OutputKind::user_value, Opcode::velocity));
  CHECK_FALSE(is_in_dynamics(OutputKind::user_value, Opcode::velocity | Opcode::input));
  CHECK_FALSE(is_omitted_by_full(output_row(OutputKind::momentum)));
  CHECK_FALSE(divides_by_mass(output_row(OutputKind::momentum)));
}

TEST_CASE("C++ types hold as many numbers as their fields have entries") {
  for (const OutputRow& output : output_table()) {
    for (const FieldRow& field : output.fields) {
      const std::size_t rows = size_of(field.rows);
      const std::size_t entries = rows * size_of(field.columns);
      if (entries == 1) continue;
      INFO(output.name << "." << field.name);
      CHECK(size_of(fmt::format(fmt::runtime(field.type), rows, entries, "pivots")) == entries);
    }
  }
}

TEST_CASE("outputs declare that they need a quadratic Lagrangian") {
  for (const OutputKind kind : {OutputKind::coriolis_matrix, OutputKind::velocity_force,
                                OutputKind::gravity, OutputKind::drift, OutputKind::hamiltonian}) {
    CHECK(output_row(kind).needs.has(Need::quadratic));
  }
  for (const OutputKind kind : {OutputKind::mass_matrix, OutputKind::bias, OutputKind::momentum,
                                OutputKind::position_gradient, OutputKind::energy_function}) {
    CHECK(output_row(kind).needs.members().empty());
  }
}

TEST_CASE("needs are listed in the order of the enumeration, including needs from other columns") {
  using Needs = std::vector<Need>;
  CHECK(output_row(OutputKind::total_energy).needs.members() ==
        Needs{Need::quadratic, Need::energies});
  CHECK(output_row(OutputKind::regressor_reference).needs.members() ==
        Needs{Need::quadratic, Need::affine_forces, Need::inertial});
  CHECK(output_row(OutputKind::hamiltonian).needs.members() ==
        Needs{Need::quadratic, Need::no_constraints});
  CHECK(output_row(OutputKind::step_derivatives).needs.members() ==
        Needs{Need::no_constraints, Need::smooth_forces, Need::few_velocities,
              Need::closed_functions});
  CHECK(output_row(OutputKind::user_operational).needs.members() ==
        Needs{Need::no_constraints, Need::no_cyclic_coordinates, Need::jacobian,
              Need::position_values, Need::smooth_values});
}

TEST_CASE("every option applies to some output, and `pivots` to every output with pivots") {
  for (const OptionRow& option : option_table) {
    INFO(option.key);
    CHECK(std::ranges::any_of(output_table(), [&option](const OutputRow& output) {
      return output.options.has(option.id);
    }));
  }
  for (const OutputRow& output : output_table()) {
    INFO(output.name);
    CHECK(output.options.has(OutputOption::pivots) == output.gives_pivots);
  }
}

TEST_CASE("an energy is a number in J that takes no momenta") {
  for (const OutputRow& output : output_table()) {
    INFO(output.name);
    const bool is_number = output.fields.size() == 1 && output.fields[0].rows == Extent::one;
    const bool is_in_joules = is_number && output.fields[0].unit == UnitRule::energy;
    CHECK(output.is_energy == (is_in_joules && !output.argument_kinds.has_any(Opcode::momentum)));
  }
}

TEST_CASE("user_value is the only value of an [[output]]") {
  for (const OutputRow& output : output_table()) {
    CHECK(is_user_value(output) == (output.name == "user_value"));
  }
}

TEST_CASE("the table lists every limit once") {
  std::set<std::string_view> names;
  Limits limits;
  for (const LimitRow& row : limit_table()) {
    CHECK(names.insert(row.name).second);
    CHECK_FALSE(row.doc.empty());
    limits.*row.member = 0;
  }
  // All members are 64-bit numbers, so the size of the struct reveals a limit without a row.
  CHECK(sizeof(Limits) == limit_table().size() * sizeof(std::uint64_t));
}

TEST_CASE("a row of the scalar table is found by its kind") {
  for (const ScalarRow& row : scalar_table) CHECK(name_of(row.kind) == row.name);
  CHECK(name_of(scalar_kind<float>) == "float");
  CHECK(name_of(scalar_kind<double>) == "double");
  CHECK(name_of(scalar_kind<long double>) == "long double");
}

}  // namespace elgen::test
