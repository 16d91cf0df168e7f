// Loops over columns compute the derivatives of models with ten or more velocities. Vectorised and
// scalar code in C++, C99 and Eigen gives the same bits as the evaluator.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "support/limbs.hpp"
#include "support/shell.hpp"

namespace elgen::test {
namespace {

constexpr std::string_view scene_text = R"toml(format = 1
model = "limbs.toml"
name = "{0}"
[outputs]
forward_dynamics_derivatives = true
[numeric]
scalar = ["{1}"]
[emit]
{2}
)toml";

constexpr std::string_view sides = R"source(#include "limbs_cpp/limbs_cpp_eigen.hpp"
#include "limbs_c/limbs_c.h"
#include "counted.hpp"
#include <cstdio>
#include <cstring>
namespace h = limbs_cpp;
constexpr std::size_t n = h::velocity_count;
template <class T>
h::ForwardDynamicsDerivatives<T> values() {
  h::Coordinates<T> q;
  h::Velocities<T> v;
  for (std::size_t i = 0; i < n; ++i) {
    q[i] = T(static_cast<NUMBER>(0.25) * static_cast<NUMBER>(i % 5) + static_cast<NUMBER>(0.1));
    v[i] = T(static_cast<NUMBER>(0.5) - static_cast<NUMBER>(0.3) * static_cast<NUMBER>(i % 3));
  }
  return h::forward_dynamics_derivatives(h::Parameters<T>{}, q, v, {{T(2)}});
}
int main() {
  const auto packs = values<NUMBER>();
  static const limbs_c_parameters p = LIMBS_C_DEFAULT_PARAMETERS;
  Eigen::Matrix<NUMBER, n, 1> q, v;
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    q[i] = static_cast<NUMBER>(0.25) * static_cast<NUMBER>(i % 5) + static_cast<NUMBER>(0.1);
    v[i] = static_cast<NUMBER>(0.5) - static_cast<NUMBER>(0.3) * static_cast<NUMBER>(i % 3);
  }
  const NUMBER u[1] = {2};
  limbs_c_forward_dynamics_derivatives_result in_c;
  limbs_c_forward_dynamics_derivatives(&p, q.data(), v.data(), u, &in_c);
  const Eigen::Matrix<NUMBER, 1, 1> input(2);
  const h::Parameters<NUMBER> parameters{};
  const auto on_eigen = h::eigen::forward_dynamics_derivatives(parameters, q, v, input);
  if (std::memcmp(&packs.by_position, in_c.by_position, sizeof in_c.by_position) != 0 ||
      std::memcmp(&packs.by_velocity, in_c.by_velocity, sizeof in_c.by_velocity) != 0 ||
      std::memcmp(&packs.by_input, in_c.by_input, sizeof in_c.by_input) != 0)
    return std::puts("C differs"), 1;
  if (std::memcmp(on_eigen.by_position.data(), in_c.by_position, sizeof in_c.by_position) != 0)
    return std::puts("Eigen differs"), 1;
PLAIN  return 0;
}
)source";

/// `Counted` uses the library's sines, so values agree only up to rounding.
constexpr std::string_view plain = R"source(  const auto counted = values<compiled::Counted>();
  for (std::size_t i = 0; i < n * n; ++i) {
    const double error = counted.by_position[i].x - packs.by_position[i];
    if (!(error < 1e-9 && error > -1e-9)) return std::puts("plain numbers differ"), 1;
  }
)source";

void check_sides(const std::string& scalar) {
  INFO(scalar);
  const Workspace workspace;
  workspace.write("limbs.toml", limbs_text(5));
  workspace.write("c.scene.toml", fmt::format(scene_text, "c", scalar, "language = \"c99\""));
  workspace.write("cpp.scene.toml", fmt::format(scene_text, "cpp", scalar, "eigen = true"));
  const std::string_view compared = scalar == "double" ? plain : "";
  workspace.write("sides.cpp", replaced_all(replaced_all(std::string(sides), "NUMBER", scalar),
                                            "PLAIN", compared));
  const auto succeeds = [&](const std::string& command) {
    CHECK(failure_of(workspace.run(command)) == "");
  };
  succeeds("elgen generate -q -o . c.scene.toml cpp.scene.toml");
  succeeds("grep -q 'Columns::load' limbs_cpp/limbs_cpp.hpp");
  succeeds("grep -q 'limbs_c_load_columns' limbs_c/limbs_c.h");
  for (const std::string compiler : {"g++", "clang++"}) {
    succeeds(compiler + " -std=c++17 -O1 -ffp-contract=off -pedantic -Wall -Wextra -Wconversion " +
             "-Wshadow -Werror -I. -I " + ELGEN_SOURCE_DIR +
             "/tests/support -isystem /usr/include/eigen3 sides.cpp -o sides && ./sides");
  }
  if (scalar != "double") return;
  // Compares the code with the evaluator, bit by bit, and with the oracle.
  succeeds("elgen verify --build native --samples 2 c.scene.toml cpp.scene.toml");
}

}  // namespace

TEST_CASE("loops over columns give the same bits as straight-line code in every language") {
  check_sides("double");
  check_sides("float");
}

}  // namespace elgen::test
