// What a machine is told by: its compiler, its processor and its C library.
#include <catch2/catch.hpp>

#include "elgen/toolchain.hpp"
#include "toolchain/environment.hpp"

TEST_CASE("this machine has a compiler, a processor and a C library") {
  const auto machine = elgen::this_machine({});
  REQUIRE(machine);
  CHECK_FALSE(machine->compiler.empty());
  CHECK(machine->compiler.find('\n') == std::string::npos);
  CHECK_FALSE(machine->processor.empty());
  CHECK(machine->c_library.find("glibc 2.") == 0);
}

TEST_CASE("without a compiler there is E704") {
  const ScopedVariable variable("CXX", "/nonexistent/c++");
  const auto machine = elgen::this_machine({});
  REQUIRE_FALSE(machine);
  CHECK(machine.diagnostics.front().code == elgen::Code::E704);
}
