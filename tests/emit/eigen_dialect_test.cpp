// eigen_dialect: what differs from plain C++; tests/pipeline/languages_test.cpp compiles it.
#include "emit/eigen_dialect.hpp"

#include "emit/definition.hpp"
#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole;
using elgen::testing::Subject;

namespace {

DefinitionText written(std::size_t function) {
  const Subject subject = cart_pole();
  const EigenDialect dialect(subject.model, subject.program);
  return definition(dialect, subject.program, subject.program.functions[function],
                    Storage::row_major)
      .whole;
}

}  // namespace

TEST_CASE("arguments are read in place, entries written into the result") {
  const DefinitionText text = written(1);
  CHECK(text.signature ==
        "[[nodiscard]] Vector<Scalar, 2> gravity(const Parameters<Scalar>& p,\n"
        "                                        const Argument<Scalar, 2>& q) noexcept");
  CHECK(text.body ==
        "  using std::sin;\n"
        "  const Scalar sin_theta = sin(q[1]);\n"
        "  Vector<Scalar, 2> result;\n"
        "  result(0) = constant<Scalar>(0.0);\n"
        "  result(1) = -p.g * p.l * p.m * sin_theta;\n"
        "  return result;\n");
}

TEST_CASE("a matrix stored by columns has the shape of the function's result") {
  const Subject subject = cart_pole();
  const EigenDialect dialect(subject.model, subject.program);
  Function function = subject.program.functions[1];
  function.fields = {{"", 2, 3, {0, 1, 0, 1, 0, 1}}};
  const DefinitionText text =
      definition(dialect, subject.program, function, Storage::column_major).whole;
  CHECK(text.signature.find("Matrix<Scalar, 2, 3> gravity(") != std::string::npos);
  CHECK(text.body.find("  Matrix<Scalar, 2, 3> result;\n") != std::string::npos);
}

TEST_CASE("numbers are returned, structs filled") {
  CHECK(written(2).body == "  return constant<Scalar>(0.5) * p.M * (v[0] * v[0]);\n");
  CHECK(written(4).body.find("  ForwardDynamics<Scalar> result;\n  result.acceleration(0) = ") !=
        std::string::npos);
}

TEST_CASE("temporaries leave the header its names") {
  const Subject subject = cart_pole();
  const EigenDialect dialect(subject.model, subject.program);
  CHECK(dialect.temporary("Vector") == "Vector_");
  CHECK(dialect.temporary("sin") == "sin_");
  CHECK(dialect.temporary("Vectors") == "Vectors");
}
