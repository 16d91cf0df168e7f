// Screening code: sound formulas have small figures, those that lose digits large ones.
#include <array>
#include <catch2/catch.hpp>
#include <limits>

#include "elgen/toolchain.hpp"
#include "toolchain/sample_model.hpp"

namespace {

using Figures = std::array<double, 6>;

/// Compiled once: a force that cancels, an acceleration that is sound where it does not overflow,
/// and pivots that are an input.
const elgen::ScreeningCode& code() {
  static const auto compiled = [] {
    std::string text = "#pragma once\n#include <cmath>\n" + sample::header();
    const auto replace = [&text](const std::string& written, const std::string& other) {
      text.replace(text.find(written), written.size(), other);
    };
    replace("return {p.m * a[0] + p.l[0] * q[0] + p.l[1] * v[0]};",
            "(void)v; (void)a; using std::cos; return {p.m - p.m * cos(q[0])};");
    replace("{p.l[0] * q[0] + v[0]}", "{q[0] / (q[0] * q[0] / v[0])}");
    elgen::Program program = sample::program();
    program.functions[0].instructions.push_back(
        {elgen::Opcode::call, elgen::FunctionId::cos, 0, 1});
    auto result = elgen::compile_screening(sample::files(text), sample::model(), sample::scene(),
                                           program, {.seconds = 600});
    INFO(elgen::format(result.diagnostics));
    REQUIRE(result);
    return std::move(*result);
  }();
  return *compiled;
}

template <class Scalar>
Figures figures(const elgen::Arguments<Scalar>& state) {
  Figures result{};
  code().judge(state, result.data());
  return result;
}

template <class Scalar>
elgen::Arguments<Scalar> at(Scalar q, Scalar v = 11) {
  return {.parameters = {Scalar(2), Scalar(0.3), Scalar(5)}, .q = {q}, .v = {v}, .a = {Scalar(13)}};
}

}  // namespace

TEST_CASE("what rounds within its bounds has figures of a few, in double and float") {
  for (const Figures& found : {figures(at(0.1)), figures(at(0.1F))}) {
    for (std::size_t i = 2; i < found.size(); ++i) {
      CHECK(found[i] >= 0);
      CHECK(found[i] < 4);
    }
  }
}

TEST_CASE("a formula that loses digits is within its own bound, and far from what it could keep") {
  const Figures found = figures(at(1e-6));
  CHECK(found[0] < 4);
  CHECK(found[1] > 1e3);
  CHECK(figures(at(1.0))[1] < 16);
  // An input that is known to a tenth of a turn excuses it.
  CHECK(figures(at(1e15))[1] < 1);
}

TEST_CASE("where nothing can be said the figures are -1, where a value is missing the largest") {
  CHECK(figures(at(1e200))[2] == -1);
  CHECK(figures(at(1.0, std::numeric_limits<double>::quiet_NaN()))[2] == -1);
  // q^2 vanishes in float.
  CHECK(figures(at(1e-30F))[2] == std::numeric_limits<double>::max());
  CHECK(figures(at(1e-30F))[4] == 0);
}
