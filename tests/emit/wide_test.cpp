// Compiles functions in a wider scalar, and steps with accelerations in float. Double-double is
// compared with 64 digits, for both compilers and several optimisation levels, with and without
// contraction of products and sums.
// Flags that would break double-double are refused.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "elgen/evaluate.hpp"
#include "emit/text/emission_input.hpp"
#include "fixture.hpp"
#include "numbers/exact_number.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

const std::string wide_programs = std::string(ELGEN_SOURCE_DIR) + "/tests/emit/compiled/";

/// A folder with the headers of tests/emit/compiled/functions.scene.toml.
struct Wide : Workspace {
  Wide() { prepare("elgen generate -q -o . " + wide_programs + "functions.scene.toml"); }

  [[nodiscard]] Outcome compiled(const std::string& compiler, const std::string& flags) const {
    return run(compiler +
               " -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow "
               "-Wfloat-equal -Wdouble-promotion -Werror " +
               flags + " -I. -I" + ELGEN_SOURCE_DIR + "/include " + wide_programs +
               "wide.cpp -o program");
  }
};

struct Parts {
  double high = 0;
  double low = 0;
};

Real exact(const Parts& x) { return Real(exact_value(x.high)) + Real(exact_value(x.low)); }

/// A call: the number of the function in wide.cpp, and its arguments.
struct Call {
  std::size_t function = 0;
  Parts x = {};
  Parts y = {};
};

class Arguments {
 public:
  /// A random argument of any magnitude up to 1e5, near a multiple of pi/2, or near 1.
  Parts next() {
    const double kind = uniform();
    double high = std::exp2(57 * uniform() - 40);
    if (kind < 0.2) high = std::round(1000 * uniform()) * 1.5707963267948966;
    if (kind > 0.8) high = 1 + std::exp2(-50 * uniform()) * (uniform() - 0.5);
    if (kind > 0.9 && kind < 0.92) high = 1e-150;
    return with_rest(uniform() < 0.5 ? -high : high);
  }

  Parts with_rest(double high) {
    return {high, uniform() < 0.3 ? 0 : std::abs(high) * 0x1p-54 * (uniform() - 0.5)};
  }

  Parts inside(FunctionDomain domain, Parts x) {
    using enum FunctionDomain;
    if (domain == up_to_one && std::abs(x.high) >= 1) x = with_rest(1 / (x.high * 1.125));
    if (domain == above_zero && x.high < 0) x = {-x.high, -x.low};
    if (domain == above_minus_one && x.high <= -1) x = with_rest(-1 / (x.high * -1.125));
    return x;
  }

 private:
  double uniform() { return static_cast<double>(draw_() >> 11) * 0x1p-53; }

  std::mt19937_64 draw_{7};
};

constexpr std::size_t operations = 5;

std::vector<Call> calls() {
  Arguments arguments;
  std::vector<Call> result;
  for (std::size_t f = 0; f < function_table().size() + operations; ++f) {
    const bool is_operation = f >= function_table().size();
    const bool is_root = f + 1 == function_table().size() + operations;
    const FunctionDomain domain = is_root        ? FunctionDomain::above_zero
                                  : is_operation ? FunctionDomain::all
                                                 : function_table()[f].domain;
    for (std::size_t i = 0; i < 200; ++i) {
      Call call{f, arguments.inside(domain, arguments.next()), arguments.next()};
      const bool is_series = !is_operation && function_table()[f].id == FunctionId::stumpff;
      const auto order = static_cast<double>(1 + i / 2 % 8);
      if (is_series) call.y = {i % 2 == 0 ? order : -order, 0};
      result.push_back(call);
    }
  }
  return result;
}

Real value_of(std::size_t function, const Real& x, const Real& y) {
  const std::size_t functions = function_table().size();
  if (function < functions) return interpreter::call(function_table()[function].id, x, y);
  if (function == functions) return x + y;
  if (function == functions + 1) return x - y;
  if (function == functions + 2) return x * y;
  return function == functions + 3 ? x / y : sqrt(x);
}

/// max(|f|, |x f'|), with f' by a difference quotient.
Real error_scale(const Call& call, const Real& value) {
  static const Real part(cln::expt(cln::cl_RA(10), -20));
  const Real x = exact(call.x);
  const Real slope =
      abs((value_of(call.function, x * (Real(1) - part), exact(call.y)) - value) / part);
  return slope > abs(value) ? slope : abs(value);
}

/// Parses the values that wide.cpp prints.
std::vector<Parts> values_in(const std::string& output) {
  std::vector<Parts> values;
  std::istringstream lines(output);
  std::string high;
  std::string low;
  while (lines >> high >> low) {
    values.push_back({std::strtod(high.c_str(), nullptr), std::strtod(low.c_str(), nullptr)});
  }
  return values;
}

std::string name_of_call(std::size_t function) {
  const std::size_t functions = function_table().size();
  if (function < functions) return std::string(function_table()[function].name);
  return std::array<const char*, operations>{"+", "-", "*", "/", "sqrt"}[function - functions];
}

/// One line for each call whose error exceeds 1e-29 max(|f|, |x f'|) plus 2^-1070.
std::string inaccurate_calls(const std::vector<Call>& all, const std::vector<Parts>& values) {
  static const Real tolerance(cln::expt(cln::cl_RA(10), -29));
  static const Real denormal(exact_value(0x1p-1070));
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Real truth = value_of(all[i].function, exact(all[i].x), exact(all[i].y));
    const bool is_finite = std::isfinite(values[i].high);
    const bool is_far = !truth.is_defined() || abs(truth) > Real(exact_value(0x1p1000));
    if (is_far ? true
               : is_finite && abs(exact(values[i]) - truth) <=
                                  tolerance * error_scale(all[i], truth) + denormal) {
      continue;
    }
    text += name_of_call(all[i].function) + " of " + std::to_string(all[i].x.high) + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("double-double has 29 digits with every compiler and optimisation") {
  const std::string compiler = GENERATE("g++", "clang++");
  const std::string flags = GENERATE("-O0", "-O2", "-O3 -march=native");
  const std::string joining = GENERATE("", " -ffp-contract=fast", " -ffp-contract=off");
  const Wide wide;
  REQUIRE(failure_of(wide.compiled(compiler, flags + joining)) == "");
  const std::vector<Call> all = calls();
  std::ostringstream lines;
  lines << std::hexfloat;
  for (const Call& call : all) {
    lines << call.function << " " << call.x.high << " " << call.x.low << " " << call.y.high << " "
          << call.y.low << "\n";
  }
  wide.write("arguments", lines.str());
  const Outcome run = wide.run("./program < arguments");
  CHECK(run.status == 0);  // checks pairs of sines and rounded products
  const std::vector<Parts> values = values_in(run.output);
  REQUIRE(values.size() == all.size());
  CHECK(inaccurate_calls(all, values).empty());
}

TEST_CASE("fast-math and its parts are refused by double-double, without an override") {
  const Wide wide;
  const std::string flags =
      GENERATE("-ffast-math", "-Ofast", "-funsafe-math-optimizations",
               "-fassociative-math -fno-signed-zeros -fno-trapping-math", "-freciprocal-math");
  const auto is_refused = [&](const std::string& compiler) {
    const Outcome built = wide.compiled(compiler, flags + " -DELGEN_ALLOW_FAST_MATH -fsyntax-only");
    INFO(compiler << " " << flags << "\n" << built.errors);
    CHECK((built.status != 0) == mentions(built.errors, "fast-math breaks the splitting of sums"));
    return built.status != 0;
  };
  CHECK(is_refused("g++"));
  // clang has no macro for parts of fast-math, but a pragma protects the split sums.
  CHECK(is_refused("clang++") == (flags == "-ffast-math" || flags == "-Ofast"));
}

TEST_CASE("parts of fast-math that clang does not report change no digit of double-double") {
  const Wide wide;
  const std::string flags = "-O3 -march=native -funsafe-math-optimizations -ffp-contract=fast";
  REQUIRE(wide.compiled("clang++", flags).status == 0);
  wide.write("arguments", "21 0x1p+0 0x1p-60 -0x1p+0 0x1p-100\n");
  const std::vector<Parts> values = values_in(wide.run("./program < arguments").output);
  REQUIRE(values.size() == 1);
  CHECK(values.front().high == 0x1p-60 + 0x1p-100);
}

TEST_CASE("excess precision is refused by double-double") {
  const Wide wide;
  const auto is_refused = [&](const std::string& method) {
    const Outcome built = wide.compiled(GENERATE("g++", "clang++"),
                                        "-U__FLT_EVAL_METHOD__ -D__FLT_EVAL_METHOD__=" + method +
                                            " -Wno-builtin-macro-redefined -fsyntax-only");
    CHECK((built.status != 0) ==
          mentions(built.errors, "excess precision breaks the splitting of sums"));
    return built.status != 0;
  };
  for (const char* const method : {"-1", "1", "2"}) CHECK(is_refused(method));
  for (const char* const method : {"0", "16"}) CHECK_FALSE(is_refused(method));
}

TEST_CASE("arguments are widened and results rounded, in the scalar of the scene") {
  Subject subject = cart_pole();
  const auto text = [&subject](InnerScalar inner) {
    subject.scene.numerics.inner = inner;
    return wide_header(
        emission_input(subject.model, subject.scene, subject.program, {subject.program}));
  };
  const std::string in_long_double = text(InnerScalar::long_double);
  CHECK(mentions(in_long_double, "using Inner = long double;\n"));
  CHECK_FALSE(mentions(in_long_double, "DoubleDouble"));
  const std::string wide = text(InnerScalar::double_double);
  CHECK(mentions(wide, "using Inner = detail::DoubleDouble;\n"));
  CHECK(mentions(wide, "  const auto values = cart_pole::forward_dynamics<Inner>("));
  CHECK(mentions(wide,
                 "  return {detail::rounded(values.acceleration),\n"
                 "          detail::rounded(values.relative_pivots)};\n"));
}

TEST_CASE("a step computes accelerations in float and everything else in double") {
  const Workspace workspace;
  workspace.write("mixed.scene.toml", "format = 1\nmodel = \"" + std::string(ELGEN_SOURCE_DIR) +
                                          "/models/kepler_cartesian.toml\"\nname = \"mixed\"\n" +
                                          R"toml([outputs]
step = { method = "rk4" }
[numeric]
inner = "float"
)toml");
  workspace.prepare("elgen generate -q -o . mixed.scene.toml");
  const std::string header =
      workspace.read("kepler_cartesian_mixed/kepler_cartesian_mixed_wide.hpp");
  CHECK(mentions(header,
                 "template <class Scalar = double, class Inner = float>\n"
                 "[[nodiscard]] ELGEN_FUNCTION Step<Scalar> step(const Parameters<double>& p,"));
  CHECK(mentions(header, "static_cast<Inner>(q[0])"));
  CHECK(mentions(header, "static_cast<Scalar>("));
  workspace.write("main.cpp", R"(#include <algorithm>
#include <cmath>
#include <cstdio>
#include "kepler_cartesian_mixed/kepler_cartesian_mixed_wide.hpp"
namespace kepler = kepler_cartesian_mixed;
template <class Scalar, class Step>
std::array<Scalar, 3> end(const Step& step) {
  const kepler::Parameters<Scalar> p{};
  kepler::Coordinates<Scalar> q{1, 0, 0};
  kepler::Velocities<Scalar> v{0, 1, Scalar(0.6)};
  for (int i = 0; i < 12800; ++i) {
    const auto next = step(p, q, v, Scalar(0.005));
    q = next.coordinates;
    v = next.rates;
  }
  return q;
}
int main() {
  const auto generic = [](const auto& p, const auto& q, const auto& v, auto h) {
    return kepler::step(p, q, v, {}, h);
  };
  const auto mixed = [](const auto& p, const auto& q, const auto& v, auto h) {
    return kepler::wide::step(p, q, v, {}, h);
  };
  const auto exact = end<double>(generic);
  const auto in_float = end<float>(generic);
  const auto own = end<double>(mixed);
  double of_float = 0;
  double of_own = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    of_float = std::max(of_float, std::abs(static_cast<double>(in_float[i]) - exact[i]));
    of_own = std::max(of_own, std::abs(own[i] - exact[i]));
  }
  std::printf("%g %g\n", of_float, of_own);
  // 1.9e-4 and 5e-7, as sums happen to be rounded.
  return of_own > 0 && of_own < 1e-5 && of_float > 10 * of_own ? 0 : 1;
}
)");
  for (const char* const compiler : {"g++", "clang++"}) {
    REQUIRE(failure_of(workspace.run(
                std::string(compiler) +
                " -std=c++17 -O2 -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow "
                "-Wfloat-equal -Wdouble-promotion -Werror -I. main.cpp -o program")) == "");
    CHECK(failure_of(workspace.run("./program")) == "");
  }
  CHECK(workspace.run("elgen verify --samples 64 mixed.scene.toml").status == 0);
  // simulate derives the outputs of a run instead of the outputs of the scene.
  CHECK(workspace.run("elgen simulate -q --time 1 mixed.scene.toml").status == 0);
}

TEST_CASE("a step in packs computes accelerations in float and keeps the state in double") {
  const Workspace workspace;
  workspace.write("mixed.scene.toml", "format = 1\nmodel = \"" + std::string(ELGEN_SOURCE_DIR) +
                                          "/models/double_pendulum.toml\"\nname = \"mixed\"\n" +
                                          R"toml([outputs]
step = { method = "rk4" }
[numeric]
inner = "float"
[emit]
batch = true
)toml");
  workspace.prepare("elgen generate -q -o . mixed.scene.toml");
  workspace.write("main.cpp", R"(#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>
#include "double_pendulum_mixed/double_pendulum_mixed_batch.hpp"
namespace pendulum = double_pendulum_mixed;
constexpr std::size_t count = 37;  // no multiple of a pack
int main() {
  const pendulum::Parameters<double> p{};
  std::vector<double> state(4 * count), moved(4 * count);
  for (std::size_t k = 0; k < state.size(); ++k) {
    state[k] = 2 * std::sin(static_cast<double>(k + 1));
  }
  const double* const q = state.data();
  const double* const v = q + 2 * count;
  double farthest = 0;
  for (const double length : {0.0, 0.01}) {
    const std::vector<double> h(count, length);
    pendulum::batch::wide::step(p, count, q, v, q, h.data(), moved.data());
    if (!(length > 0) && moved != state) return 1;
    for (std::size_t i = 0; i < count; ++i) {
      const auto one = pendulum::wide::step(p, pendulum::Coordinates<double>{q[i], q[count + i]},
                                            pendulum::Velocities<double>{v[i], v[count + i]}, {},
                                            length);
      for (std::size_t k = 0; k < 2; ++k) {
        farthest = std::max(farthest, std::abs(one.coordinates[k] - moved[k * count + i]));
        farthest = std::max(farthest, std::abs(one.rates[k] - moved[(2 + k) * count + i]));
      }
    }
  }
  std::printf("%g\n", farthest);
  return farthest < 1e-5 ? 0 : 2;  // h times the error of accelerations of up to 100 in float
}
)");
  const std::string machine = GENERATE("", "-march=native ", "-march=x86-64-v3 ");
  for (const char* const compiler : {"g++", "clang++"}) {
    REQUIRE(failure_of(workspace.run(
                std::string(compiler) + " -std=c++17 -O2 " + machine +
                "-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow "
                "-Wfloat-equal -Wdouble-promotion -Werror -I. main.cpp -o program")) == "");
    CHECK(failure_of(workspace.run("./program")) == "");
  }
}

TEST_CASE("verify compares steps in packs with accelerations in float") {
  const auto [model, outputs] = GENERATE(
      std::pair{ELGEN_SOURCE_DIR "/models/simple_pendulum.toml", "step = \"verlet\"\n"},
      std::pair{ELGEN_SOURCE_DIR "/models/four_bar.toml", "step = \"rk4\"\nprojected = true\n"},
      std::pair{"curve.toml", "step = \"rk4\"\nprojected = true\n"});
  const Workspace workspace;
  // The projection calls atan2 of a pack and a parameter.
  workspace.write("curve.toml",
                  "format = 1\n[model]\nname = \"curve\"\n[[coordinate]]\nname = \"x\"\n"
                  "[[coordinate]]\nname = \"y\"\n[parameters]\n"
                  "l = { value = 2, assume = \"positive\" }\n[energy]\n"
                  "T = \"dot(x)^2 + dot(y)^2\"\nV = \"x^2 + y\"\n[[constraint]]\n"
                  "name = \"arc\"\nequation = \"y = atan2(x, l)\"\n");
  workspace.write("mixed.scene.toml", "format = 1\nmodel = \"" + std::string(model) +
                                          "\"\nname = \"mixed\"\n[outputs]\n" + outputs +
                                          "[numeric]\ninner = \"float\"\n[emit]\nbatch = true\n");
  const Outcome run = workspace.run("elgen verify --samples 8 mixed.scene.toml");
  CHECK(failure_of(run) == "");
  CHECK(run.status == 0);
}

TEST_CASE("names of the header in a wider scalar are E701") {
  Subject subject = cart_pole();
  CHECK(wide_check_names(subject.model, subject.scene, subject.program).empty());
  subject.program.functions[0].name = "wide";
  subject.program.functions[4].name = "inner";
  CHECK(wide_check_names(subject.model, subject.scene, subject.program).size() == 2);
}
