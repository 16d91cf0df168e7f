// The same scenes in C++, C99 and Eigen, compiled by gcc and clang without warnings. All give the
// same bits, in row-major and column-major order, and Eigen allocates no memory.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "support/shell.hpp"

namespace elgen::test {
namespace {

constexpr std::string_view scene_template = R"toml(format = 1
model  = "{0}"
name   = "{1}"
[outputs]
coriolis_matrix  = true
bias             = true
inverse_dynamics = true
kinetic_energy   = true
input_matrix     = true
forward_dynamics = true
[numeric]
scalar = ["{2}"]
[emit]
{3}
{4}
)toml";

/// Calls the C code of a model. NAME, CAPITALS and SCALAR are replaced; `to` receives all results.
constexpr std::string_view c_side = R"source(#include "NAME_c/NAME_c.h"
void c_side(const SCALAR *q, const SCALAR *v, const SCALAR *a, const SCALAR *u, SCALAR *to);
void c_side(const SCALAR *q, const SCALAR *v, const SCALAR *a, const SCALAR *u, SCALAR *to) {
  static const NAME_c_parameters p = CAPITALS_C_DEFAULT_PARAMETERS;
  const int n = CAPITALS_C_VELOCITY_COUNT;
  NAME_c_forward_dynamics_result result;
  NAME_c_coriolis_matrix(&p, q, v, to);
  NAME_c_bias(&p, q, v, to += n * n);
  NAME_c_inverse_dynamics(&p, q, v, a, to += n);
  *(to += n) = NAME_c_kinetic_energy(&p, q, v);
  NAME_c_input_matrix(&p, q, ++to);
  to += n * CAPITALS_C_INPUT_COUNT;
  NAME_c_forward_dynamics(&p, q, v, u, &result);
  for (int i = 0; i < n; ++i) {
    to[i] = result.acceleration[i];
    to[n + i] = result.relative_pivots[i];
  }
  to[2 * n] = NAME_c_digits_left(result.relative_pivots);
}
)source";

constexpr std::string_view cpp_side = R"source(#define EIGEN_RUNTIME_NO_MALLOC
#include "NAME_rows/NAME_rows_eigen.hpp"
#include "NAME_columns/NAME_columns_eigen.hpp"
#include <cstdio>
#include <cstring>
#include <vector>
extern "C" void c_side(const SCALAR*, const SCALAR*, const SCALAR*, const SCALAR*,
                       SCALAR*);
namespace {
constexpr int m = NAME_rows::coordinate_count, n = NAME_rows::velocity_count;
constexpr int k = NAME_rows::input_count;
using V = Eigen::Matrix<SCALAR, n, 1>;
struct State {
  Eigen::Matrix<SCALAR, m, 1> q;
  V v, a;
  Eigen::Matrix<SCALAR, k, 1> u;
};
template <class Values>
void add(std::vector<SCALAR>& to, const Values& values) {
  for (const SCALAR& x : values) to.push_back(x);
}
template <class Q, class Vector>
std::array<SCALAR, std::tuple_size<Q>::value> flat(const Vector& x) {
  Q r{};
  for (std::size_t i = 0; i < r.size(); ++i) r[i] = x[static_cast<Eigen::Index>(i)];
  return r;
}
std::vector<SCALAR> plain(const State& s) {
  namespace h = NAME_rows;
  const h::Parameters<SCALAR> p{};
  const auto q = flat<h::Coordinates<SCALAR>>(s.q);
  const auto v = flat<h::Velocities<SCALAR>>(s.v), a = flat<h::Velocities<SCALAR>>(s.a);
  const auto u = flat<h::Inputs<SCALAR>>(s.u);
  std::vector<SCALAR> to;
  add(to, h::coriolis_matrix(p, q, v));
  add(to, h::bias(p, q, v));
  add(to, h::inverse_dynamics(p, q, v, a));
  to.push_back(h::kinetic_energy(p, q, v));
  add(to, h::input_matrix(p, q));
  const auto result = h::forward_dynamics(p, q, v, u);
  add(to, result.acceleration);
  add(to, result.relative_pivots);
  to.push_back(h::digits_left(result.relative_pivots));
  return to;
}
#define ON_EIGEN(h)                                                     \
  Eigen::internal::set_is_malloc_allowed(false);                        \
  const h::Parameters<SCALAR> p{};                                      \
  const auto C = h::eigen::coriolis_matrix(p, s.q, s.v);                \
  const V bias = h::eigen::bias(p, s.q, s.v);                           \
  const V tau = h::eigen::inverse_dynamics(p, s.q, s.v, s.a + 0 * s.v); \
  const SCALAR energy = h::eigen::kinetic_energy(p, s.q, s.v);          \
  const Eigen::Matrix<SCALAR, n, k> B = h::eigen::input_matrix(p, s.q); \
  const auto result = h::eigen::forward_dynamics(p, s.q, s.v, s.u);     \
  const SCALAR digits = h::eigen::digits_left(result.relative_pivots);  \
  Eigen::internal::set_is_malloc_allowed(true);                         \
  std::vector<SCALAR> to;                                               \
  for (int i = 0; i < n; ++i)                                           \
    for (int j = 0; j < n; ++j) to.push_back(C(i, j));                  \
  add(to, bias);                                                        \
  add(to, tau);                                                         \
  to.push_back(energy);                                                 \
  for (int i = 0; i < n; ++i)                                           \
    for (int j = 0; j < k; ++j) to.push_back(B(i, j));                  \
  add(to, result.acceleration);                                         \
  add(to, result.relative_pivots);                                      \
  to.push_back(digits);                                                 \
  return to;
std::vector<SCALAR> by_rows(const State& s) {
  ON_EIGEN(NAME_rows)
}
std::vector<SCALAR> by_columns(const State& s) {
  ON_EIGEN(NAME_columns)
}
bool same(const std::vector<SCALAR>& x, const std::vector<SCALAR>& y) {
  return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(SCALAR)) == 0;
}
}  // namespace
int main() {
  for (int sample = 0; sample < 50; ++sample) {
    const State s{decltype(State::q)::Random(), V::Random(), V::Random(),
                  decltype(State::u)::Random()};
    const std::vector<SCALAR> expected = plain(s);
    std::vector<SCALAR> in_c(expected.size());
    c_side(s.q.data(), s.v.data(), s.a.data(), s.u.data(), in_c.data());
    if (!same(expected, in_c)) return std::puts("C differs"), 1;
    if (!same(expected, by_rows(s))) return std::puts("Eigen differs"), 1;
    if (!same(expected, by_columns(s))) return std::puts("column-major differs"), 1;
  }
  return 0;
}
)source";

std::string side(std::string_view text, const std::string& model, const std::string& scalar) {
  std::string capitals = model;
  for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  const std::string named = replaced_all(std::string(text), "NAME", model);
  return replaced_all(replaced_all(named, "CAPITALS", capitals), "SCALAR", scalar);
}

void write_scenes(const Workspace& workspace, const std::string& model, const std::string& scalar,
                  const std::string& more) {
  const auto write = [&](const std::string& name, const std::string& emit) {
    workspace.write(name + ".scene.toml",
                    fmt::format(scene_template, model_path(model), name, scalar, emit, more));
  };
  write("c", "language = \"c99\"");
  write("rows", "eigen = true");
  write("columns", "eigen = true\nstorage = \"column-major\"");
  workspace.write("side.c", side(c_side, model, scalar));
  workspace.write("side.cpp", side(cpp_side, model, scalar));
}

const std::string warnings =
    " -O1 -ffp-contract=off -pedantic -Wall -Wextra -Wdouble-promotion -Wconversion -Wshadow "
    "-Wfloat-equal -Werror -I. ";

void compare(const std::string& model, const std::string& scalar, const std::string& more = "") {
  INFO(model << " in " << scalar);
  const Workspace workspace;
  write_scenes(workspace, model, scalar, more);
  const auto succeeds = [&](const std::string& command) {
    CHECK(failure_of(workspace.run(command)) == "");
  };
  succeeds("elgen generate -q -o . c.scene.toml rows.scene.toml columns.scene.toml");
  for (const auto& [c, cpp] : {std::pair("gcc", "g++"), std::pair("clang", "clang++")}) {
    succeeds(std::string(c) + " -std=c99" + warnings + "-c side.c -o c.o");
    succeeds(std::string(cpp) + " -std=c++17" + warnings +
             "-isystem /usr/include/eigen3 side.cpp c.o -o sides && ./sides");
    succeeds(std::string(cpp) + " -std=c++17" + warnings + "-fsyntax-only -include " + model +
             "_c/" + model + "_c.h -x c++ /dev/null");
  }
}

}  // namespace

TEST_CASE("C++, C99 and Eigen give the same bits") {
  for (const char* model : {"cart_pole", "two_link_arm", "quadrotor"}) {
    for (const char* scalar : {"double", "float"}) compare(model, scalar);
  }
  compare("chain", "double", "[sizes]\nn = 20\n");  // long enough to be split into parts
}

}  // namespace elgen::test
