// Scalars of emitted headers: correct numbers in every documented kind, and a message for types
// with too few digits.
#include <catch2/catch.hpp>

#include "support/installed.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

const std::string programs = std::string(ELGEN_SOURCE_DIR) + "/tests/emit/compiled/";

/// A command that succeeds if the include path of `Swing::compiled` has the header of Ceres.
const std::string has_ceres =
    "echo '#include <ceres/jet.h>' | g++ -std=c++17 -isystem /usr/include/eigen3 -E -x c++ -";

/// A folder with the header of tests/emit/compiled/swing.scene.toml.
struct Swing : Workspace {
  Swing() { prepare("elgen generate -q -o . " + programs + "swing.scene.toml"); }

  [[nodiscard]] Outcome compiled(const std::string& command) const {
    return run(command + " -std=c++17 -isystem /usr/include/eigen3 -I.");
  }
};

}  // namespace

TEST_CASE("correct numbers in every kind of scalar") {
  const std::string compiler = GENERATE("g++", "clang++");
  const Swing swing;
  REQUIRE(failure_of(swing.compiled(
              compiler +
              " -O2 -ffp-contract=off -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror " +
              "-Wno-psabi -Wno-ignored-attributes " + programs +
              "scalars.cpp -o scalars -lquadmath")) == "");
  for (const std::string type :
       {"float", "double", "long_double", "float128", "cpp_bin_float", "complex", "dual", "strict",
        "jet", "fvar", "interval", "autodiff", "simd"}) {
    if (type == "jet" && !is_installed("ceres", has_ceres)) continue;
    CHECK(failure_of(swing.run("./scalars " + type)) == "");
  }
}

TEST_CASE("expression nodes, which allow no branches, have the values of double") {
  const std::string compiler = GENERATE("g++", "clang++");
  const Workspace workspace;
  workspace.prepare("elgen generate -q -o . " ELGEN_SOURCE_DIR "/models/cart_pole.toml");
  REQUIRE(failure_of(workspace.run(
              compiler + " -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -I. " +
              programs + "symbols.cpp -o symbols")) == "");
  CHECK(failure_of(workspace.run("./symbols")) == "");
}

TEST_CASE("nested scalars get the constants of their innermost type") {
  const std::string compiler = GENERATE("g++", "clang++");
  const Swing swing;
  const auto expect_compiled = [&](const std::string& includes, const std::string& scalar) {
    swing.write("nested.cpp", includes + "#include \"swing_fixed/swing_fixed.hpp\"\n" +
                                  "auto a() { return swing_fixed::forward_dynamics<" + scalar +
                                  ">({}, {}, {}, {}); }\n");
    CHECK(failure_of(swing.compiled(compiler + " -fsyntax-only nested.cpp")) == "");
  };
  expect_compiled("#include <boost/math/differentiation/autodiff.hpp>\n",
                  "boost::math::differentiation::autodiff_fvar<double, 1, 2>");
  if (!is_installed("ceres", has_ceres)) return;
  expect_compiled("#include <ceres/jet.h>\n", "ceres::Jet<ceres::Jet<double, 1>, 3>");
}

TEST_CASE("half precision, fixed point and integers are refused") {
  const std::string compiler = GENERATE("g++", "clang++");
  const Swing swing;
  const auto errors_with = [&](const std::string& scalar) {
    const Outcome built = swing.compiled(compiler + " -fsyntax-only '-DSCALAR=" + scalar + "' " +
                                         programs + "refused_scalar.cpp");
    return built.status == 0 ? std::string() : built.errors;
  };
  for (const char* const scalar :
       {"int", "unsigned long", "Eigen::half", "Eigen::bfloat16", "std::complex<Eigen::half>",
        "Fixed", "FixedPair", "Described"}) {
    INFO(scalar);
    CHECK(mentions(errors_with(scalar),
                   "half precision, fixed point and integers have too few digits"));
  }
  // clang++ 14 has no _Float16 on x86.
  if (compiler == "g++") {
    CHECK(mentions(errors_with("_Float16"), "half precision, fixed point and integers"));
  }
  CHECK(errors_with("double").empty());
}
