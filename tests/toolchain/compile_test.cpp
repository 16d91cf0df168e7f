// Emitted text becomes callable functions; a missing compiler and refused code are told apart.
#include <catch2/catch.hpp>
#include <filesystem>

#include "elgen/toolchain.hpp"
#include "toolchain/environment.hpp"
#include "toolchain/sample_model.hpp"
#include "toolchain/temporary_directory.hpp"

namespace {

auto compile_header(const std::string& text) {
  return elgen::compile(sample::files(text), sample::model(), sample::scene(), sample::program());
}

template <class Scalar>
elgen::Arguments<Scalar> arguments() {
  return {.parameters = {2, 3, 5}, .q = {7}, .v = {11}, .a = {13}};
}

}  // namespace

TEST_CASE("compiled functions return the fields one after another, in double and float") {
  const auto compiled = compile_header(sample::header());
  REQUIRE(compiled);
  const elgen::CompiledModel& model = **compiled;
  CHECK(model.call("inverse_dynamics", arguments<double>()) == std::vector<double>{102});
  CHECK(model.call("inverse_dynamics", arguments<float>()) == std::vector<float>{102});
  CHECK(model.call("forward_dynamics", arguments<double>()) == std::vector<double>{32, 2});
  CHECK(model.call("gravity", arguments<double>()).empty());
}

TEST_CASE("the temporary directory is gone afterwards, and its name may have spaces") {
  const auto scratch = elgen::TemporaryDirectory::create();
  REQUIRE(scratch);
  const auto spaced = scratch->path() / "with space";
  std::filesystem::create_directory(spaced);
  const ScopedVariable variable("TMPDIR", spaced.string());
  const auto compiled = compile_header(sample::header());
  REQUIRE(compiled);
  CHECK(std::filesystem::is_empty(spaced));
  CHECK((*compiled)->call("inverse_dynamics", arguments<double>()).front() == 102);
}

TEST_CASE("code the compiler refuses comes back with the compiler's words") {
  std::string text = sample::header();
  text.replace(text.find("p.m * a[0]"), 10, "p.unknown_");
  const auto compiled = compile_header(text);
  REQUIRE_FALSE(compiled);
  CHECK(compiled.diagnostics.front().code == elgen::Code::E705);
  CHECK(compiled.diagnostics.front().message.find("unknown_") != std::string::npos);
}

TEST_CASE("a warning in emitted code is refused too") {
  std::string text = sample::header();
  text.insert(text.find("return {p.m"), "int unused = 0;\n");
  CHECK_FALSE(compile_header(text));
}

TEST_CASE("without a compiler there is E704, with exit code 4") {
  const auto empty = elgen::TemporaryDirectory::create();
  REQUIRE(empty);
  const ScopedVariable compiler("CXX", "/nonexistent/compiler");
  const ScopedVariable path("PATH", empty->path().string());
  const auto compiled = compile_header(sample::header());
  REQUIRE_FALSE(compiled);
  CHECK(compiled.diagnostics.front().code == elgen::Code::E704);
  CHECK(elgen::exit_code(compiled.diagnostics) == elgen::ExitCode::inaccessible);
}

TEST_CASE("without a place to write there is E706") {
  const ScopedVariable variable("TMPDIR", "/nonexistent/elgen");
  const auto compiled = compile_header(sample::header());
  REQUIRE_FALSE(compiled);
  CHECK(compiled.diagnostics.front().code == elgen::Code::E706);
}
