#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

using namespace elgen::test;

namespace {

/// What `show` prints on a terminal of 60 columns.
std::string shown_on_terminal(const std::string& environment) {
  const std::string command = "stty cols 60; " + environment + " " + std::string(ELGEN_BINARY) +
                              " show " + models + "/cart_pole.toml --what mass_matrix";
  return run("script -qc '" + command + "' /dev/null").output;
}

}  // namespace

TEST_CASE("a terminal whose locale is UTF-8 is shown Unicode, others text") {
  CHECK(shown_on_terminal("LC_ALL=C.UTF-8 TERM=xterm").find("⎣ m l cos θ") != std::string::npos);
  for (const char* const other : {"LC_ALL=C TERM=xterm", "LC_ALL=C.UTF-8 TERM=dumb"}) {
    INFO(other);
    CHECK(shown_on_terminal(other).find("mass_matrix[1,2] = m*l*cos(theta)") != std::string::npos);
  }
}
