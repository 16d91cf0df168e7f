// Compares the compiled header ELGEN_HEADER (namespace ELGEN_MODEL) with the independent program
// ELGEN_ORACLE, which reads the description ELGEN_DESCRIPTION of the same robot.
#include "independent/agreement.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "independent/checks.hpp"
#include ELGEN_HEADER

namespace elgen::test {

namespace {

namespace emitted = ::ELGEN_MODEL;

template <class Array>
std::vector<double> numbers(const Array& array) {
  return {array.begin(), array.end()};
}

template <std::size_t Size>
std::array<double, Size> array(const std::vector<double>& numbers) {
  std::array<double, Size> result{};
  if (numbers.size() != Size) throw std::runtime_error("wrong size of state");
  std::copy(numbers.begin(), numbers.end(), result.begin());
  return result;
}

/// M, bias and torque of the emitted functions, with the parameter values of the model file.
Dynamics emitted_dynamics(const State& state) {
  const emitted::Parameters<double> parameters;
  const auto q = array<emitted::coordinate_count>(state.q);
  const auto v = array<emitted::velocity_count>(state.v);
  const auto a = array<emitted::velocity_count>(state.a);
  return {numbers(emitted::mass_matrix(parameters, q)), numbers(emitted::bias(parameters, q, v)),
          numbers(emitted::inverse_dynamics(parameters, q, v, a))};
}

const std::filesystem::path description = ELGEN_DESCRIPTION;
constexpr bool floating = emitted::coordinate_count != emitted::velocity_count;
constexpr std::size_t joints = emitted::velocity_count - (floating ? 6 : 0);

bool is_urdf() { return description.extension() == ".urdf"; }

}  // namespace

TEST_CASE("the emitted functions agree with the independent program") {
  check_agreement(emitted_dynamics, ELGEN_ORACLE(description, floating),
                  random_states(joints, floating),
                  is_urdf() ? urdf_agreement_tolerance : agreement_tolerance);
}

TEST_CASE("the emitted functions give the reference values") {
  if (is_urdf()) return;
  const Robot robot = read_robot(description, floating);
  if (robot.reference) check_reference_values(emitted_dynamics, *robot.reference);
}

}  // namespace elgen::test
