// Python modules: the scripts of this folder let elgen generate modules, and call them with the
// installed Python packages.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <iostream>
#include <string>

#include "support/installed.hpp"
#include "support/shell.hpp"

namespace elgen::test {

namespace {

/// $PYTHON, or else the system's Python, which has Debian's packages.
std::string python() {
  const char* const chosen = std::getenv("PYTHON");
  return chosen == nullptr ? "/usr/bin/python3" : chosen;
}

/// The folder of modules that the scripts share.
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

TEST_CASE("modules of all models compile without warnings") { check_script("compiles"); }

TEST_CASE("names reserved by Python are changed, and names that modules need are refused") {
  check_script("names");
}

TEST_CASE("functions that branch on a number choose for each element of arrays and symbols") {
  check_script("kinks");
}

TEST_CASE("modules run on numbers with the restrictions of tracers") { check_script("tracers"); }

TEST_CASE("functions of arrays of states equal functions of each state") {
  check_script("numpy_batch");
}

TEST_CASE("every call of a module checks the lengths of its arguments") { check_script("lengths"); }

TEST_CASE("mypy --strict accepts modules, and refuses calls with wrong types") {
  check_script("typed");
}

TEST_CASE("functions for a library are pickled") { check_script("pickling"); }

TEST_CASE("SymPy proves every closed form that a model expects") { check_script("sympy_proofs"); }

TEST_CASE("mpmath agrees with the oracle's 50 digits") { check_script("mpmath_digits"); }

TEST_CASE("numbers that no double represents are exact in SymPy and mpmath") {
  check_script("exact_numbers");
}

TEST_CASE("numba gives the bits of CPython") { check_script("numba_bits"); }

TEST_CASE("the Jacobian by torch is the linearization") { check_script("torch_jacobian"); }

}  // namespace elgen::test
