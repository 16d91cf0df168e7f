#include "independent/agreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace elgen::test {

namespace {

constexpr int state_count = 200;

/// Uniform random numbers, the same with every standard library, unlike the distributions of
/// <random>.
class RandomNumbers {
 public:
  [[nodiscard]] double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }

  [[nodiscard]] std::vector<double> within(double bound, std::size_t size) {
    std::vector<double> result(size);
    for (double& number : result) number = between(-bound, bound);
    return result;
  }

 private:
  std::mt19937 engine_{20240229};
};

/// Scales the four numbers to a unit quaternion.
void normalise(std::vector<double>& numbers) {
  double sum = 0.0;
  for (const double x : numbers) sum += x * x;
  for (double& x : numbers) x /= std::sqrt(sum);
}

std::vector<double> base_pose(RandomNumbers& random) {
  std::vector<double> pose = random.within(1.0, 3);
  std::vector<double> quaternion = random.within(1.0, 4);
  normalise(quaternion);
  pose.insert(pose.end(), quaternion.begin(), quaternion.end());
  return pose;
}

}  // namespace

double relative_difference(const std::vector<double>& values,
                           const std::vector<double>& reference) {
  if (values.size() != reference.size()) throw std::runtime_error("sizes differ");
  double scale = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double difference = std::abs(values[i] - reference[i]);
    if (std::isnan(difference)) return std::numeric_limits<double>::infinity();
    scale = std::max(scale, std::abs(reference[i]));
    largest = std::max(largest, difference);
  }
  return largest / scale;
}

Differences differences(const Oracle& oracle, const Oracle& reference,
                        const std::vector<State>& states) {
  Differences worst;
  const auto raise = [](double& largest, double difference) {
    largest = std::max(largest, difference);
  };
  for (const State& state : states) {
    const Dynamics ours = oracle(state);
    const Dynamics theirs = reference(state);
    raise(worst.mass_matrix, relative_difference(ours.mass_matrix, theirs.mass_matrix));
    raise(worst.bias, relative_difference(ours.bias, theirs.bias));
    raise(worst.torque, relative_difference(ours.torque, theirs.torque));
  }
  return worst;
}

std::vector<State> random_states(std::size_t joints, bool floating) {
  const double pi = std::acos(-1.0);
  RandomNumbers random;
  std::vector<State> states;
  for (int i = 0; i < state_count; ++i) {
    State state;
    if (floating) state.q = base_pose(random);
    const std::vector<double> angles = random.within(pi, joints);
    state.q.insert(state.q.end(), angles.begin(), angles.end());
    state.v = random.within(3.0, joints + (floating ? 6 : 0));
    state.a = random.within(5.0, state.v.size());
    states.push_back(std::move(state));
  }
  return states;
}

}  // namespace elgen::test
