// Which compiler is taken, and how strictly it is called.
#include "toolchain/compiler.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "toolchain/environment.hpp"
#include "toolchain/temporary_directory.hpp"

using elgen::compiler_candidates;

namespace {

elgen::ProcessResult compile_text(const std::string& text) {
  const auto directory = elgen::TemporaryDirectory::create();
  REQUIRE(directory);
  const auto source = directory->path() / "a b.cpp";
  std::ofstream(source) << text;
  return elgen::compile_shared({"c++"}, source, directory->path() / "a b.so");
}

}  // namespace

TEST_CASE("$CXX comes first, as one path and then as words") {
  const ScopedVariable variable("CXX", "ccache g++");
  const auto candidates = compiler_candidates();
  REQUIRE(candidates.size() == 5);
  CHECK(candidates[0] == elgen::CompilerCommand{"ccache g++"});
  CHECK(candidates[1] == elgen::CompilerCommand{"ccache", "g++"});
  CHECK(candidates[4] == elgen::CompilerCommand{"clang++"});
}

TEST_CASE("an empty $CXX is none") {
  const ScopedVariable variable("CXX", "");
  CHECK(compiler_candidates().front() == elgen::CompilerCommand{"c++"});
}

TEST_CASE("a $CXX that does not run is passed over, and without any there is no compiler") {
  const auto scratch = elgen::TemporaryDirectory::create();
  REQUIRE(scratch);
  const ScopedVariable variable("CXX", "/nonexistent/compiler");
  CHECK(elgen::find_compiler(scratch->path()) == elgen::CompilerCommand{"c++"});
  const ScopedVariable path("PATH", scratch->path().string());
  CHECK_FALSE(elgen::find_compiler(scratch->path()));
}

TEST_CASE("clean code compiles, from paths with spaces") {
  const auto result = compile_text("extern \"C\" int f();\nextern \"C\" int f() { return 1; }\n");
  CHECK(result.started);
  INFO(result.output);
  CHECK(result.status == 0);
}

TEST_CASE("each promised warning is an error") {
  const std::string declaration = "int f(double x); ";
  for (const char* body :
       {"int f(double x) { return x; }",                                 // -Wconversion
        "int f(double x) { return x == 0.5 ? 1 : 2; }",                  // -Wfloat-equal
        "int f(double x) { { int x = 1; return x; } }",                  // -Wshadow
        "int f(double) { float y = 1; return y * 2.0 > 1.0 ? 1 : 0; }",  // -Wdouble-promotion

        "int f(double) { long long a[0]; return 1; }"}) {  // -Wpedantic
    CAPTURE(body);
    CHECK(compile_text(declaration + body).status != 0);
  }
}
