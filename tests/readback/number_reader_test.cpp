// Numbers as headers write them for every scalar.
#include "readback/number_reader.hpp"

#include <cln/integer.h>

#include <catch2/catch.hpp>

namespace elgen {
namespace {

bool is_read(const std::string& text, const cln::cl_R& number) {
  const SourcePointer source = make_source("number", text);
  TokenReader tokens(*source);
  try {
    read_cpp_number(tokens, number);
    tokens.expect_end();
    return true;
  } catch (const Mistake&) {
    return false;
  }
}

}  // namespace

TEST_CASE("what every scalar holds is one literal") {
  const cln::cl_RA half = cln::cl_RA(1) / 2;
  CHECK(is_read("constant<Scalar>(0.5)", half));
  CHECK(is_read("-constant<Scalar>(0.5)", -half));
  CHECK_FALSE(is_read("constant<Scalar>(0.5)", -half));
  CHECK_FALSE(is_read("constant<Scalar>(0.5F)", half));
  CHECK_FALSE(is_read("constant<Scalar>(0.25)", half));
}

TEST_CASE("other numbers are three literals and a fraction in chunks") {
  const cln::cl_RA tenth = cln::cl_RA(1) / 10;
  CHECK(is_read("constant<Scalar>(0.1F, 0.1, 0.1L, {1}, {10})", tenth));
  CHECK(is_read("constant<Scalar>(0.1F, 0.1, 0.1L, {1}, {1}, -1)", tenth));
  CHECK_FALSE(is_read("constant<Scalar>(0.1F, 0.1, 0.1L, {1}, {10}, 1)", tenth));
  CHECK_FALSE(is_read("constant<Scalar>(0.1F, 0.1, 0.1, {1}, {10})", tenth));
  CHECK_FALSE(is_read("constant<Scalar>(0.1F, 0.1, 0.1L, {1}, {0})", tenth));
  CHECK_FALSE(is_read("constant<Scalar>(0.1F, 0.1, 0.1L, {1000000}, {10, 0})", tenth));
  const cln::cl_RA large = 123456789;
  CHECK(is_read("constant<Scalar>(123456789.0F, 123456789.0, 123456789.0L, {123, 456789}, {1})",
                large));
}

TEST_CASE("a scalar that cannot hold the number has no literal") {
  const cln::cl_RA tiny = cln::cl_RA(1) / cln::expt_pos(cln::cl_I(10), 60);
  CHECK(is_read("constant<Scalar>(detail::OutOfRange{}, 1e-60, 1e-60L, {1}, {1}, -60)", tiny));
  CHECK_FALSE(is_read("constant<Scalar>(1e-60F, 1e-60, 1e-60L, {1}, {1}, -60)", tiny));
}

TEST_CASE("a C literal has the suffix of its scalar") {
  const SourcePointer source = make_source("number", "-9.81f");
  TokenReader single(*source);
  CHECK_NOTHROW(read_c_number(single, cln::cl_RA(-981) / 100, ScalarKind::single_precision));
  TokenReader twice(*source);
  CHECK_THROWS_AS(read_c_number(twice, cln::cl_RA(-981) / 100, ScalarKind::double_precision),
                  Mistake);
}

}  // namespace elgen
