// Programs of tests/emit/compiled/ around an emitted header, built by both compilers and run.
#include <catch2/catch.hpp>

#include "support/shell.hpp"

using namespace elgen;

namespace {

test::Outcome build(const std::string& compiler, const std::string& program,
                    const test::Workspace& workspace, const std::string& flags = "") {
  const std::string source = ELGEN_SOURCE_DIR;
  return test::shell(compiler +
                         " -std=c++17 -O2 -ffp-contract=off -Wall -Wextra -Wpedantic -Wconversion "
                         "-Wshadow -Werror " +
                         flags + " -I" + source + "/generated " + source + "/tests/emit/compiled/" +
                         program + " -o program",
                     workspace.path());
}

/// Builds and runs.
void expect_success(const std::string& program, const std::string& flags = "") {
  const std::string compiler = GENERATE("g++", "clang++");
  const test::Workspace workspace;
  const test::Outcome built = build(compiler, program, workspace, flags);
  INFO(compiler << "\n" << built.errors);
  REQUIRE(built.status == 0);
  const test::Outcome run = test::shell("./program", workspace.path());
  INFO(run.output);
  CHECK(run.status == 0);
}

}  // namespace

TEST_CASE("one call for sine and cosine gives the bits of two") { expect_success("angles.cpp"); }

TEST_CASE("packs pass unmodified, every lane as the scalar") {
  expect_success("packs.cpp", "-Wno-psabi -Wno-ignored-attributes");
}

TEST_CASE("a pack has to declare the type of its elements") {
  expect_success("unnamed_element.cpp", "-Wno-psabi -DVALUE_TYPE");
  const std::string compiler = GENERATE("g++", "clang++");
  const test::Workspace workspace;
  const test::Outcome built = build(compiler, "unnamed_element.cpp", workspace, "-Wno-psabi");
  CHECK(built.status != 0);
  CHECK(test::mentions(built.errors, "using value_type = double;"));
}

TEST_CASE("batches give what the functions of one state give") {
  expect_success("batch.cpp", GENERATE("", "-march=native", "-march=x86-64-v3"));
}

TEST_CASE("batches are refused under fast-math, whatever is defined") {
  const std::string compiler = GENERATE("g++", "clang++");
  const test::Workspace workspace;
  const test::Outcome built =
      build(compiler, "batch.cpp", workspace, "-ffast-math -DELGEN_ALLOW_FAST_MATH");
  CHECK(built.status != 0);
  CHECK(test::mentions(built.errors, "fast-math takes apart how angles are reduced"));
}
