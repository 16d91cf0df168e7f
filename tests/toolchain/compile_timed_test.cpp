// Timed functions go through arrays of states.
#include <catch2/catch.hpp>

#include "elgen/timing.hpp"
#include "toolchain/sample_model.hpp"

using namespace elgen;

namespace {

Result<TimedFunctions> compiled(const std::string& text, const std::vector<ScalarKind>& scalars) {
  TimingOptions options{.limits = {.seconds = 600}};
  for (const ScalarKind scalar : scalars) options.variants.push_back({scalar, false});
  options.states = {{.parameters = {1, 1, 1}, .q = {7}, .v = {11}, .a = {13}},
                    {.parameters = {1, 1, 1}, .q = {0}, .v = {1}, .a = {0.5F}}};
  return compile_timed(sample::files(text), sample::model(), sample::scene(), sample::program(),
                       options);
}

/// Parameters are the header's own: 2, 3 and 5.
std::string header_with_values() {
  std::string text = sample::header();
  const auto replace = [&text](const std::string& written, const std::string& other) {
    text.replace(text.find(written), written.size(), other);
  };
  replace("Scalar m; std::array<Scalar, 2> l;", "Scalar m = 2; std::array<Scalar, 2> l = {3, 5};");
  replace("template <class Scalar> using Inputs",
          "template <class Scalar> using Coordinates = Vector<Scalar>;\n"
          "template <class Scalar> using Velocities = Vector<Scalar>;\n"
          "template <class Scalar> using Accelerations = Vector<Scalar>;\n"
          "template <class Scalar> using Inputs");
  return text;
}

}  // namespace

TEST_CASE("all states are computed in every scalar, with the parameters of the header") {
  const auto functions = compiled(header_with_values(),
                                  {ScalarKind::double_precision, ScalarKind::single_precision});
  INFO(format(functions.diagnostics));
  REQUIRE(functions);
  REQUIRE(functions->size() == 2);
  for (const auto& function : *functions) {
    CHECK(function->results() == std::vector<double>{0, 0});
    function->run();
    CHECK(function->results() == std::vector<double>{102, 6});
  }
}

TEST_CASE("what the compiler refuses is an error with its words") {
  const auto functions = compiled("#error no\n", {ScalarKind::double_precision});
  REQUIRE_FALSE(functions);
  CHECK(functions.diagnostics.front().code == Code::E705);
}
