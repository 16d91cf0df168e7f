// The choice of the compiler, the strictness of its flags, and the description of the machine.

#include <catch2/catch.hpp>
#include <fstream>

#include "elgen/toolchain.hpp"
#include "support/text.hpp"
#include "toolchain/environment.hpp"
#include "toolchain/workshop.hpp"

using elgen::compiler_candidates;
using elgen::test::mentions;

namespace {

elgen::ProcessResult compile_text(const std::string& text,
                                  elgen::BuildFlags build = elgen::BuildFlags::as_written) {
  const auto directory = elgen::TemporaryDirectory::create();
  REQUIRE(directory);
  const auto source = directory->path() / "a b.cpp";
  std::ofstream(source) << text;
  return elgen::compile_shared({{"c++"}, 60}, build, source, directory->path() / "a b.so");
}

}  // namespace

TEST_CASE("$CXX is one path or several words, and no other compiler is tried") {
  const ScopedVariable variable("CXX", "ccache g++");
  const auto candidates = compiler_candidates();
  REQUIRE(candidates.size() == 2);
  CHECK(candidates[0] == elgen::CompilerCommand{"ccache g++"});
  CHECK(candidates[1] == elgen::CompilerCommand{"ccache", "g++"});
}

TEST_CASE("an empty $CXX counts as unset") {
  const ScopedVariable variable("CXX", "");
  CHECK(compiler_candidates().front() == elgen::CompilerCommand{"c++"});
  const auto found = elgen::find_compiler(60);
  REQUIRE(found);
  CHECK(found->command == elgen::CompilerCommand{"c++"});
}

TEST_CASE("a $CXX that does not run or is no compiler is named and not replaced") {
  const auto message = [](const std::string& chosen) {
    const ScopedVariable variable("CXX", chosen);
    const auto found = elgen::find_compiler(60);
    REQUIRE_FALSE(found);
    CHECK(found.diagnostics.front().code == elgen::Code::E704);
    return found.diagnostics.front().message;
  };
  CHECK(message("/nonexistent/g++") == "`/nonexistent/g++`, which $CXX names, could not be run");
  CHECK(message("false") == "`false`, which $CXX names, exits 1");
}

TEST_CASE("a compiler that does not answer is stopped at the time limit") {
  const auto scratch = elgen::TemporaryDirectory::create();
  REQUIRE(scratch);
  const auto script = scratch->path() / "slow";
  std::ofstream(script) << "#!/bin/sh\nsleep 100\n";
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  const ScopedVariable variable("CXX", script.string());
  const auto found = elgen::find_compiler(1);
  REQUIRE_FALSE(found);
  CHECK(found.diagnostics.front().code == elgen::Code::E909);
}

TEST_CASE("correct code compiles, also from paths with spaces") {
  const auto result = compile_text("extern \"C\" int f();\nextern \"C\" int f() { return 1; }\n");
  INFO(result.output);
  CHECK(result.succeeded());
}

TEST_CASE("each warning of the documented list is an error") {
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

TEST_CASE("the build with users' flags is optimised and has no warnings enabled") {
  const std::string text = "int f(double x); int f(double x) { return x; }\n";
  const auto result = compile_text("#ifndef __OPTIMIZE__\n#error not optimised\n#endif\n" + text,
                                   elgen::BuildFlags::user_flags);
  INFO(result.output);
  CHECK(result.succeeded());
}

TEST_CASE("this machine's compiler, processor and C library are identified") {
  const auto machine = elgen::this_machine({});
  REQUIRE(machine);
  CHECK_FALSE(machine->compiler.empty());
  CHECK_FALSE(mentions(machine->compiler, "\n"));
  CHECK_FALSE(machine->processor.empty());
  CHECK(machine->c_library.find("glibc 2.") == 0);
}
