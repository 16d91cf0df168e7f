// Modules of Python: the scripts of this folder have elgen write them, and call them with the
// packages of Python that are installed.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <iostream>
#include <string>

#include "support/installed.hpp"
#include "support/shell.hpp"

namespace elgen::test {

namespace {

/// $PYTHON, else that of the system, which has the packages of Debian.
std::string python() {
  const char* const chosen = std::getenv("PYTHON");
  return chosen == nullptr ? "/usr/bin/python3" : chosen;
}

/// Scripts share the modules that they have in common.
const Workspace& modules() {
  static const Workspace folder("elgen_modules_");
  return folder;
}

void check_script(const std::string& name) {
  if (!is_installed("python3", python() + " --version")) return;
  const std::string command = "export PYTHONDONTWRITEBYTECODE=1 ELGEN_MODULES='" +
                              modules().path().string() + "'\n" + python() +
                              " " ELGEN_SOURCE_DIR "/tests/python/" + name + ".py";
  const Outcome outcome = shell(command, "/");
  std::cout << outcome.output;
  INFO(outcome.errors);
  CHECK(outcome.status == 0);
}

}  // namespace

TEST_CASE("modules of all models compile without a warning") { check_script("compiles"); }

TEST_CASE("names that Python reserves are spelt otherwise, those that modules need are refused") {
  check_script("names");
}

TEST_CASE("functions with kinks refuse symbols in words, and take arrays by elements") {
  check_script("kinks");
}

TEST_CASE("modules run on numbers that forbid what tracers forbid") { check_script("tracers"); }

TEST_CASE("arrays of states have the values of each state") { check_script("numpy_batch"); }

TEST_CASE("SymPy proves every closed form that a model expects") { check_script("sympy_proofs"); }

TEST_CASE("mpmath has the 50 digits of the oracle") { check_script("mpmath_digits"); }

TEST_CASE("numbers that no double is are exact in SymPy and mpmath") {
  check_script("exact_numbers");
}

TEST_CASE("numba has the bits of CPython") { check_script("numba_bits"); }

TEST_CASE("the Jacobian of torch is the linearization") { check_script("torch_jacobian"); }

}  // namespace elgen::test
