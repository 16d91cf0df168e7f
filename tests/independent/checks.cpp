#include "independent/checks.hpp"

#include <catch2/catch.hpp>

#include "independent/agreement.hpp"

namespace elgen::test {

void check_agreement(const Oracle& oracle, const Oracle& reference,
                     const std::vector<State>& states, double tolerance) {
  const Differences worst = differences(oracle, reference, states);
  INFO("M " << worst.mass_matrix << ", bias " << worst.bias << ", torque " << worst.torque);
  CHECK(worst.mass_matrix < tolerance);
  CHECK(worst.bias < tolerance);
  CHECK(worst.torque < tolerance);
}

void check_reference_values(const Oracle& oracle, const ReferenceValues& reference) {
  constexpr double printed = 1e-11;
  const Dynamics moving = oracle(reference.state);
  CHECK(relative_difference(moving.torque, reference.torque) < printed);

  const std::size_t size = reference.state.v.size();
  const std::vector<double> row(moving.mass_matrix.begin(),
                                moving.mass_matrix.begin() + static_cast<std::ptrdiff_t>(size));
  CHECK(relative_difference(row, reference.first_row_of_mass_matrix) < printed);

  const std::vector<double> rest(size, 0.0);
  CHECK(relative_difference(oracle({reference.state.q, rest, rest}).torque, reference.gravity) <
        printed);
}

}  // namespace elgen::test
