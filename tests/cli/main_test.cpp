// The exit codes of the process are the interface.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

TEST_CASE("each kind of end has its exit code") {
  const Workspace workspace;
  const auto status = [&](const std::string& command) {
    return shell(command, workspace.path()).status;
  };
  const std::string generate = "elgen generate -q " + models + "/cart_pole.toml ";
  CHECK(status("elgen --help") == 0);
  CHECK(status(generate + "--check") == 1);
  CHECK(status("elgen generate") == 2);
  CHECK(status(generate + "--limit derived_nodes=3") == 3);
  CHECK(status(generate + "-o /dev/null/out") == 4);
  CHECK(status(generate) == 0);
  CHECK(status(generate + "--check") == 0);
}

#ifdef ELGEN_HARDENED
TEST_CASE("the program stops at memory errors") {
  const Workspace workspace;
  const auto printed = [&](const std::string& options) {
    const Outcome outcome = shell("readelf -W " + options + " \"$ELGEN\"", workspace.path());
    REQUIRE(outcome.status == 0);
    return outcome.output;
  };
  // Full RELRO: what the loader writes is read-only afterwards, and nothing is bound later.
  CHECK(mentions(printed("--program-headers"), "GNU_RELRO"));
  CHECK(mentions(printed("--dynamic"), "BIND_NOW"));
  const std::string symbols = printed("--dyn-syms");
  CHECK(mentions(symbols, "__stack_chk_fail"));       // -fstack-protector-strong
  CHECK(mentions(symbols, "_chk@GLIBC"));             // -D_FORTIFY_SOURCE=2
  CHECK(mentions(symbols, "__glibcxx_assert_fail"));  // -D_GLIBCXX_ASSERTIONS
}
#endif

}  // namespace elgen::test
