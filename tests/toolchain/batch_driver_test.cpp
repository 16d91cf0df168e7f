// The driver of a batch: one state among others, at every place of full packs and of what is left.
#include <catch2/catch.hpp>

#include "toolchain/driver_parts.hpp"
#include "toolchain/sample_model.hpp"

using Catch::Matchers::Contains;

namespace {

elgen::Scene batch_scene() {
  elgen::Scene scene = sample::scene();
  scene.emission.batch = true;
  return scene;
}

/// Batches of the sample's functions, written out with `stride` between the numbers of a state.
elgen::EmittedFiles batch_files(const std::string& stride) {
  elgen::EmittedFiles files = sample::files(sample::header());
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
template <class T>
void forward_dynamics(const Parameters<T>& p, std::size_t count, const T* q, const T* v,
                      const T* u, T* result) {
  (void)u;
  for (std::size_t i = 0; i < count; ++i) {
    const auto values = sample::forward_dynamics<T>(p, {q[i]}, {v[i]}, {});
    result[i] = values.acceleration[0];
    result[)" + stride + R"( + i] = values.relative_pivots[0];
  }
}
}  // namespace sample::batch
)";
  return files;
}

std::vector<double> forward_dynamics(const std::string& stride) {
  const auto compiled =
      elgen::compile(batch_files(stride), sample::model(), batch_scene(), sample::program(), {});
  INFO(elgen::format(compiled.diagnostics));
  REQUIRE(compiled);
  REQUIRE(compiled->size() == 2);
  CHECK(compiled->back().types == "batch");
  CHECK(compiled->back().in_packs);
  const elgen::Arguments<double> arguments{.parameters = {2, 3, 5}, .q = {7}, .v = {11}, .a = {13}};
  return compiled->back().functions->call("forward_dynamics", arguments);
}

}  // namespace

TEST_CASE("a batch gives the numbers of one state, whatever place it has") {
  CHECK(forward_dynamics("count") == std::vector<double>{32, 2});
}

TEST_CASE("a stride that is not the count of states gives another number") {
  CHECK(forward_dynamics("(count - 1)") != std::vector<double>{32, 2});
}

TEST_CASE("functions that a batch leaves out have no driver") {
  elgen::Program program = sample::program();
  program.functions[0].fields[0].entries.assign(4097, 0);
  const std::string text = elgen::batch_driver({sample::model(), batch_scene(), program});
  CHECK_THAT(text, !Contains("elgen_driver_double_0"));
  CHECK_THAT(text, Contains("elgen_driver_double_1"));
}
