// A timed function computes its values at every state of an array. A timed step continues from its
// last result.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "elgen/toolchain.hpp"
#include "toolchain/sample_model.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::vector<elgen::Arguments<double>> timed_states() {
  const elgen::Arguments<double> first{.parameters = {1, 1, 1}, .q = {7}, .v = {11}, .a = {13}};
  const elgen::Arguments<double> second{.parameters = {1, 1, 1}, .q = {0}, .v = {1}, .a = {0.5}};
  return {first, second};
}

Result<TimedFunctions> compiled(const std::string& text, const std::vector<ScalarKind>& scalars) {
  TimingOptions options{.limits = {.seconds = 600}};
  for (const ScalarKind scalar : scalars) options.variants.push_back({scalar, false});
  options.states = timed_states();
  return compile_timed_functions(sample::files(text), sample::model(), sample::scene(),
                                 sample::program(), options);
}

/// The header of the sample with the parameter values 2, 3 and 5.
std::string header_with_values() {
  std::string text = sample::header();
  const auto replace = [&text](const std::string& written, const std::string& other) {
    text = replaced(text, written, other);
  };
  replace("Scalar m; std::array<Scalar, 2> l;", "Scalar m = 2; std::array<Scalar, 2> l = {3, 5};");
  replace("template <class Scalar> using Inputs",
          "template <class Scalar> using Coordinates = Vector<Scalar>;\n"
          "template <class Scalar> using Velocities = Vector<Scalar>;\n"
          "template <class Scalar> using Accelerations = Vector<Scalar>;\n"
          "template <class Scalar> using Inputs");
  return text;
}

/// Two timed functions of the sample's batch: all states in packs, and one call per state.
Result<TimedFunctions> compiled_batch() {
  TimingOptions options{.limits = {.seconds = 600}};
  options.variants = {{ScalarKind::double_precision, true, false},
                      {ScalarKind::double_precision, true, true}};
  options.states = timed_states();
  EmittedFiles files = sample::files(header_with_values());
  files.files["sample/sample_batch.hpp"] = R"(#pragma once
#include "sample.hpp"
namespace sample::batch {
template <class T>
void inverse_dynamics(const Parameters<T>& p, std::size_t count, const T* q, const T* v,
                      const T* a, T* result) {
  for (std::size_t i = 0; i < count; ++i) {
    result[i] = sample::inverse_dynamics<T>(p, {q[i]}, {v[i]}, {a[i]})[0];
  }
}
}  // namespace sample::batch
)";
  Scene scene = sample::scene();
  scene.emission.has_batch_header = true;
  return compile_timed_functions(files, sample::model(), scene, sample::program(), options);
}

}  // namespace

TEST_CASE("all states are computed in every scalar with the header's parameters") {
  const auto functions =
      compiled(header_with_values(), {ScalarKind::double_precision, ScalarKind::single_precision});
  INFO(format(functions.diagnostics));
  REQUIRE(functions);
  REQUIRE(functions->size() == 2);
  for (const auto& function : *functions) {
    function->run();
    CHECK(function->values_at(timed_states()) == std::vector<double>{102, 6});
    const std::vector<elgen::Arguments<double>> last{timed_states().back()};
    CHECK(function->values_at(last) == std::vector<double>{6});
  }
}

TEST_CASE("one call per state gives the results of packs of all states") {
  const auto functions = compiled_batch();
  INFO(format(functions.diagnostics));
  REQUIRE(functions);
  REQUIRE(functions->size() == 2);
  for (const auto& function : *functions) {
    function->run();
    CHECK(function->values_at(timed_states()) == std::vector<double>{102, 6});
  }
}

TEST_CASE("if the scene varies parameters, each state has its own parameters") {
  Scene scene = sample::scene();
  scene.numerics.varied_parameters[0] = Interval{1, 2};
  const TimingOptions options{
      .variants = {TimedVariant{}}, .states = timed_states(), .limits = {.seconds = 600}};
  const auto functions = compile_timed_functions(
      sample::files(header_with_values()), sample::model(), scene, sample::program(), options);
  INFO(format(functions.diagnostics));
  REQUIRE(functions);
  std::vector<elgen::Arguments<double>> states = timed_states();
  states.back().parameters = {2, 1, 3};
  CHECK(functions->front()->values_at(states) == std::vector<double>{31, 4});
}

TEST_CASE("code that the compiler refuses is an error with the compiler's message") {
  const auto functions = compiled("#error no\n", {ScalarKind::double_precision});
  REQUIRE_FALSE(functions);
  CHECK(functions.diagnostics.front().code == Code::E705);
}

TEST_CASE("a step continues from its last result, for one state or several together") {
  EmittedFiles files = sample::files(header_with_values() + R"(
namespace sample {
template <class Scalar> struct Next { Vector<Scalar> coordinates, rates; };
template <class Scalar>
Next<Scalar> advance(const Parameters<Scalar>& p, const Vector<Scalar>& q, const Vector<Scalar>& v,
                     const Inputs<Scalar>&, Scalar h) {
  return {{q[0] + h * v[0]}, {v[0] + h * p.m}};
}
template <class Scalar>
Next<Scalar> halved(const Parameters<Scalar>&, const Vector<Scalar>& q, const Vector<Scalar>& v) {
  return {{q[0] / 2}, v};
}
}  // namespace sample
)");
  files.files["sample/sample_batch.hpp"] = R"(#pragma once
#include "sample.hpp"
namespace sample::batch {
template <class T>
void advance(const Parameters<T>& p, std::size_t count, const T* q, const T* v, const T*,
             const T* h, T* result) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto next = sample::advance<T>(p, {q[i]}, {v[i]}, {}, h[i]);
    result[i] = next.coordinates[0];
    result[count + i] = next.rates[0];
  }
}
template <class T>
void halved(const Parameters<T>&, std::size_t count, const T* q, const T* v, T* result) {
  for (std::size_t i = 0; i < count; ++i) {
    result[i] = q[i] / 2;
    result[count + i] = v[i];
  }
}
}  // namespace sample::batch
)";
  Scene scene = sample::scene();
  scene.emission.has_batch_header = true;
  Program program{sample::program().leaves};
  program.functions.push_back({.kind = OutputKind::step,
                               .name = "advance",
                               .fields = {{"coordinates", 1, 1, {0}}, {"rates", 1, 1, {0}}}});
  const Result<StepLoops> loops =
      compile_step_loops(files, sample::model(), scene, program, {.seconds = 600});
  INFO(elgen::format(loops.diagnostics));
  REQUIRE(loops);
  CHECK(loops->entries == 2);
  std::vector<double> one{1, 10};
  std::vector<double> spare(4);
  loops->one_state_loop(1, 3, 0, 0.5, nullptr, one.data(), spare.data());
  CHECK(one == std::vector<double>{17.5, 13});
  std::vector<double> two{1, 3, 10, 20};
  loops->pack_loop(2, 3, 0, 0.5, nullptr, two.data(), spare.data());
  CHECK(two == std::vector<double>{17.5, 34.5, 13, 23});
  // The projection is called after every step.
  program.functions.insert(
      program.functions.begin(),
      {.kind = OutputKind::projected, .name = "halved", .fields = program.functions[0].fields});
  const Result<StepLoops> projected =
      compile_step_loops(files, sample::model(), scene, program, {.seconds = 600});
  INFO(elgen::format(projected.diagnostics));
  REQUIRE(projected);
  one = {1, 10};
  projected->one_state_loop(1, 3, 0, 0.5, nullptr, one.data(), spare.data());
  CHECK(one == std::vector<double>{5.125, 13});
  two = {1, 3, 10, 20};
  projected->pack_loop(2, 3, 0, 0.5, nullptr, two.data(), spare.data());
  CHECK(two == std::vector<double>{5.125, 9.75, 13, 23});
}
