// Emitted text is compiled to callable functions. A missing compiler and refused code give
// different errors.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "elgen/toolchain.hpp"
#include "toolchain/environment.hpp"
#include "toolchain/sample_model.hpp"
#include "toolchain/workshop.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

auto compile_header(const std::string& text) {
  return elgen::compile(sample::files(text), sample::model(), sample::scene(), sample::program(),
                        {});
}

/// While this object exists, a script that changes the call replaces the compiler.
class CompilerWrapper {
 public:
  /// `words`: shell commands that run before the compiler is called with "$@".
  explicit CompilerWrapper(const std::string& words)
      : scratch_(TemporaryDirectory::create()), variable_("CXX", script(words)) {}

 private:
  [[nodiscard]] std::string script(const std::string& words) const {
    const auto path = scratch_->path() / "compiler";
    std::ofstream(path) << "#!/bin/sh\n" << words << "\nexec c++ \"$@\"\n";
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return path.string();
  }

  std::optional<TemporaryDirectory> scratch_;
  ScopedVariable variable_;
};

const std::vector<BuildFlags> builds_to_verify{BuildFlags::as_written, BuildFlags::native,
                                               BuildFlags::user_flags};

elgen::Scene eigen_scene() {
  elgen::Scene scene = sample::scene();
  scene.emission.has_eigen_header = true;
  return scene;
}

/// The files of the sample with an Eigen header, whose inverse dynamics subtracts l[1] v = 5 v.
elgen::EmittedFiles eigen_files() {
  elgen::EmittedFiles files = sample::files(sample::header());
  files.files["sample/sample_eigen.hpp"] = R"(#pragma once
#include <Eigen/Core>
#include "sample.hpp"
namespace sample::eigen {
template <class Scalar> using Vector = Eigen::Matrix<Scalar, 1, 1>;
template <class Scalar> struct Forward { Vector<Scalar> acceleration, relative_pivots; };
template <class Scalar>
Vector<Scalar> inverse_dynamics(const Parameters<Scalar>& p, const Vector<Scalar>& q,
                                const Vector<Scalar>& v, const Vector<Scalar>& a) noexcept {
  return Vector<Scalar>(p.m * a(0) + p.l[0] * q(0) - p.l[1] * v(0));
}
template <class Scalar>
Forward<Scalar> forward_dynamics(const Parameters<Scalar>& p, const Vector<Scalar>& q,
                                 const Vector<Scalar>& v,
                                 const Eigen::Matrix<Scalar, 0, 1>&) noexcept {
  return {Vector<Scalar>(p.l[0] * q(0) + v(0)), Vector<Scalar>(p.m)};
}
}  // namespace sample::eigen
)";
  return files;
}

template <class Scalar>
elgen::Arguments<Scalar> arguments() {
  return {.parameters = {2, 3, 5}, .q = {7}, .v = {11}, .a = {13}};
}

}  // namespace

TEST_CASE("compiled functions return their fields in order, in double and float") {
  const auto compiled = compile_header(sample::header());
  REQUIRE(compiled);
  REQUIRE(compiled->size() == 1);
  const elgen::CompiledModel& model = *compiled->front().functions;
  CHECK(model.call("inverse_dynamics", arguments<double>()) == std::vector<double>{102});
  CHECK(model.call("inverse_dynamics", arguments<float>()) == std::vector<float>{102});
  CHECK(model.call("forward_dynamics", arguments<double>()) == std::vector<double>{32, 2});
  CHECK(model.call("gravity", arguments<double>()).empty());
}

TEST_CASE("a compiled function can be called directly on arrays") {
  const auto compiled = compile_header(sample::header());
  REQUIRE(compiled);
  const elgen::CompiledModel& model = *compiled->front().functions;
  const auto given = arguments<double>();
  double result[2] = {0, 0};
  const auto function = model.find("forward_dynamics");
  REQUIRE(function != nullptr);
  function(given.parameters.data(), given.f.data(), given.q.data(), given.v.data(), nullptr,
           nullptr, nullptr, nullptr, given.u.data(), given.t, given.h, given.E, result);
  CHECK(result[0] == 32);
  CHECK(result[1] == 2);
  CHECK(model.find("gravity") == nullptr);
}

TEST_CASE("the temporary directory is removed afterwards, and its name may contain spaces") {
  const auto scratch = elgen::TemporaryDirectory::create();
  REQUIRE(scratch);
  const auto spaced = scratch->path() / "with space";
  std::filesystem::create_directory(spaced);
  const ScopedVariable variable("TMPDIR", spaced.string());
  const auto compiled = compile_header(sample::header());
  REQUIRE(compiled);
  CHECK(std::filesystem::is_empty(spaced));
  CHECK(compiled->front().functions->call("inverse_dynamics", arguments<double>()).front() == 102);
}

TEST_CASE("refused code returns the compiler's message") {
  const auto compiled = compile_header(replaced(sample::header(), "p.m * a[0]", "p.unknown_"));
  REQUIRE_FALSE(compiled);
  CHECK(compiled.diagnostics.front().code == elgen::Code::E705);
  CHECK(mentions(compiled.diagnostics.front().message, "unknown_"));
}

TEST_CASE("a warning in emitted code is an error") {
  std::string text = sample::header();
  text.insert(text.find("return {p.m"), "int unused = 0;\n");
  CHECK_FALSE(compile_header(text));
}

TEST_CASE("the Eigen header is compiled and run beside the C++ header, in two builds") {
  const auto compiled = elgen::compile(eigen_files(), sample::model(), eigen_scene(),
                                       sample::program(), {.builds = builds_to_verify});
  INFO(elgen::format(compiled.diagnostics));
  REQUIRE(compiled);
  REQUIRE(compiled->size() == 5);  // the build with users' flags has only the C++ header
  for (const std::size_t i : {1U, 3U}) {
    const elgen::CompiledHeader& other = (*compiled)[i];
    CHECK(other.types == "Eigen");
    CHECK(other.build == (i == 1 ? BuildFlags::as_written : BuildFlags::native));
    // The Eigen header's own function, which subtracts 5 * 11.
    CHECK(other.functions->call("inverse_dynamics", arguments<double>()) ==
          std::vector<double>{-8});
    CHECK(other.functions->call("forward_dynamics", arguments<float>()) ==
          std::vector<float>{32, 2});
  }
  CHECK(compiled->back().types.empty());
  CHECK(compiled->back().build == BuildFlags::user_flags);
}

TEST_CASE("if Eigen is not installed, its header has no functions and the other header has them") {
  const CompilerWrapper without(
      "for word do\n  shift\n  test \"$word\" = /usr/include/eigen3 && word=/nonexistent\n"
      "  set -- \"$@\" \"$word\"\ndone");
  const auto compiled =
      elgen::compile(eigen_files(), sample::model(), eigen_scene(), sample::program(), {});
  INFO(elgen::format(compiled.diagnostics));
  REQUIRE(compiled);
  REQUIRE(compiled->size() == 2);
  CHECK(compiled->front().functions->call("inverse_dynamics", arguments<double>()) ==
        std::vector<double>{102});
  CHECK(compiled->back().functions == nullptr);
  CHECK(compiled->back().failure_reason == "<Eigen/Core> is not installed");
}

TEST_CASE("a build with flags that the compiler refuses has no functions") {
  const CompilerWrapper without("case \"$*\" in *-march=native*) exit 1 ;; esac");
  const auto compiled =
      elgen::compile(sample::files(sample::header()), sample::model(), sample::scene(),
                     sample::program(), {.builds = builds_to_verify});
  INFO(elgen::format(compiled.diagnostics));
  REQUIRE(compiled);
  REQUIRE(compiled->size() == 3);
  CHECK(compiled->front().functions != nullptr);
  for (const std::size_t i : {1U, 2U}) {
    CHECK((*compiled)[i].functions == nullptr);
    CHECK((*compiled)[i].failure_reason == "the compiler does not take -O3 -march=native");
  }
}

TEST_CASE("a C header is compiled as C99") {
  elgen::EmittedFiles files;
  files.files["sample/sample.h"] = R"(#pragma once
typedef struct sample_parameters { double m; double l[2]; } sample_parameters;
)" + sample::c_functions("double");
  elgen::Scene scene = sample::scene();
  scene.emission.language = elgen::LanguageId::c99;
  scene.numerics.scalars = {elgen::ScalarKind::double_precision};
  const auto compiled = elgen::compile(files, sample::model(), scene, sample::program(), {});
  INFO(elgen::format(compiled.diagnostics));
  REQUIRE(compiled);  // `restrict` is no keyword of C++
  const elgen::CompiledModel& model = *compiled->front().functions;
  CHECK(model.call("inverse_dynamics", arguments<double>()) == std::vector<double>{102});
  CHECK(model.call("forward_dynamics", arguments<double>()) == std::vector<double>{32, 2});
}

TEST_CASE(
    "a compiler that always fails or writes no file is not reported as an error of the emitted "
    "code") {
  const auto scratch = elgen::TemporaryDirectory::create();
  REQUIRE(scratch);
  const auto code_with = [&](const std::string& body) {
    const auto script = scratch->path() / "compiler";
    std::ofstream(script) << "#!/bin/sh\ntest \"$1\" = --version && exit 0\n" << body << "\n";
    std::filesystem::permissions(script, std::filesystem::perms::owner_all);
    const ScopedVariable compiler("CXX", script.string());
    const auto compiled = compile_header(sample::header());
    REQUIRE_FALSE(compiled);
    CHECK(elgen::exit_code(compiled.diagnostics) == elgen::ExitCode::inaccessible);
    return compiled.diagnostics.front();
  };
  CHECK(code_with("kill -SEGV $$").code == elgen::Code::E709);
  CHECK(code_with("exit 4").code == elgen::Code::E709);
  CHECK(code_with("exit 0").code == elgen::Code::E709);
  CHECK(
      code_with("echo 'g++: fatal error: Killed signal terminated program cc1plus'; exit 1").code ==
      elgen::Code::E709);
  const elgen::Diagnostic words = code_with("printf 'a\\033[31mb\\n'; yes | head -n 9999; exit 1");
  CHECK(words.code == elgen::Code::E709);
  CHECK(mentions(words.message, "exits 1:\nab\ny\n"));
  CHECK(words.message.size() < 5000);
}

TEST_CASE("code refused only with fast-math is not reported as an error of the emitted code") {
  const auto code_with = [](const std::string& command) {
    const ScopedVariable compiler("CXX", command);
    const auto compiled = compile_header("#error \"fast-math\"\n");
    REQUIRE_FALSE(compiled);
    return compiled.diagnostics.front().code;
  };
  CHECK(code_with("g++") == elgen::Code::E705);
  CHECK(code_with("g++ -ffast-math") == elgen::Code::E709);
  CHECK(code_with("clang++ -ffast-math") == elgen::Code::E709);
  CHECK(code_with("g++ -funsafe-math-optimizations") == elgen::Code::E709);
}
