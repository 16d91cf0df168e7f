// The controller of the cart and pole, built as a user would: its performance, and its gains
// compared with published gains.
#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>

#include "consumer/projects.hpp"

namespace elgen::test {

namespace {

/// The pendulum of the University of Michigan's Control Tutorials for MATLAB and Simulink
/// ("Inverted Pendulum: System Modeling"), whose phi is positive counter-clockwise from the upward
/// vertical.
constexpr const char* michigan_model = R"toml(format = 1

[model]
name = "michigan"

[[coordinate]]
name = "x"
unit = "m"

[[coordinate]]
name = "phi"
unit = "rad"

[parameters]
M = { value = 0.5,   unit = "kg" }
m = { value = 0.2,   unit = "kg" }
b = { value = 0.1,   unit = "N*s/m" }
J = { value = 0.006, unit = "kg*m^2" }
l = { value = 0.3,   unit = "m" }
g = { value = 9.8,   unit = "m/s^2" }

[[point]]
name = "cart"
at   = ["x", "0"]
mass = "M"

[[body]]
name    = "pendulum"
mass    = "m"
com     = ["x - l*sin(phi)", "l*cos(phi)"]
inertia = "J"
spin    = "dot(phi)"

[energy]
D = "1/2*b*dot(x)^2"

[gravity]
vector = ["0", "-g"]

[[input]]
name = "F"
unit = "N"
on   = "x"
)toml";

/// Prints rows of gains, and the error for a system that is not controllable. Each row has the
/// order of the publication that lists its gains.
constexpr const char* gains_program = R"source(#include <cstdio>

#include "cart_pole_balance/cart_pole_balance_eigen.hpp"
#include "lqr.hpp"
#include "michigan/michigan.hpp"

using Matrix4 = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

void print_michigan(double weight_of_x, double weight_of_phi) {
  const auto upright = michigan::linearization<double>({}, {0.0, 0.0}, {0.0, 0.0}, {0.0});
  const Eigen::Vector4d weights(weight_of_x, weight_of_phi, 0, 0);
  const Eigen::MatrixXd K =
      lqr(Eigen::Map<const Matrix4>(upright.A.data()),
          Eigen::Map<const Eigen::Vector4d>(upright.B.data()),
          weights.asDiagonal().toDenseMatrix(), Eigen::MatrixXd::Identity(1, 1));
  std::printf("%.4f %.4f %.4f %.4f\n", K(0), K(2), K(1), K(3));
}

int main() {
  namespace plant = cart_pole_balance;
  const plant::eigen::Vector<double, 1> none(0.0);
  const Eigen::Vector2d zero(0, 0);
  const auto upright = plant::eigen::linearization<double>({}, zero, zero, none);
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(1, 1);
  const Eigen::MatrixXd K = lqr(upright.A, upright.B, Eigen::Matrix4d::Identity(), one);
  std::printf("%.17g %.17g %.17g %.17g\n", K(0), K(1), K(2), K(3));
  print_michigan(1, 1);
  print_michigan(5000, 100);
  try {
    lqr(one, 0 * one, one, one);
  } catch (const std::domain_error& error) {
    std::printf("%s\n", error.what());
  }
}
)source";

}  // namespace

TEST_CASE("the example swings the pole up and balances it with published gains") {
  const Example balance("balance");
  const Outcome run = balance.run("build/balance");
  INFO(run.output << run.errors);
  CHECK(run.status == 0);
  const double seconds = number_after(run.output, "balanced: last outside 0.01 rad and 0.02 m at ");
  CHECK(seconds > 0.5);  // 20 N are too little to raise the pole at once
  CHECK(seconds <= 6.0);
  CHECK(number_after(run.output, "at most ") <= 20.0);
  CHECK(number_after(run.output, " N and ") <= 2.5);
  CHECK(is_in_readme(run.output));

  balance.write("michigan.toml", michigan_model);
  balance.write("gains.cpp", gains_program);
  balance.prepare(
      "printf '%s\\n' 'elgen_generate(TARGET michigan INPUTS michigan.toml)' "
      "'add_executable(gains gains.cpp)' "
      "'target_link_libraries(gains PRIVATE plant michigan Eigen3::Eigen)' >> CMakeLists.txt && "
      "cmake --build build --target gains");
  std::istringstream gains(balance.run("build/gains").output);
  for (const double expected : {-1.0, -30.3090602982462, -2.23141595992025, -6.68877359039808}) {
    double gain = 0;
    gains >> gain;
    CHECK(std::abs(gain - expected) <= 1e-9);
  }
  std::string rest;
  std::getline(gains >> std::ws, rest, '\0');
  CHECK(rest ==
        "-1.0000 -1.6567 18.6854 3.4594\n"
        "-70.7107 -37.8345 105.5298 20.9238\n"
        "lqr: no stable solution\n");
}

}  // namespace elgen::test
