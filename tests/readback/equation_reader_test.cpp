// Equations in the model language are compared by value, however they are written.
#include "readback/equation_reader.hpp"

#include <catch2/catch.hpp>

#include "changes.hpp"

namespace elgen {
namespace {

/// Equations of the mass matrix.
struct Mass {
  Origin origin{test::cpp().checked.model, test::cpp().checked.scene, test::cpp().program};
  EquationReader reader{origin};
  const Field& field = test::cpp().program.functions.front().fields.front();

  Mass() { reader.start(0); }
  std::string entry(std::size_t index, const std::string& text) {
    return reader.entry(field.entries[index], text);
  }
};

}  // namespace

TEST_CASE("another way to write it is the same equation") {
  Mass mass;
  for (const char* text : {"M + m", "m + M", "2*M - (M - m)", "(M^2 - m^2)/(M - m)",
                           "(M + m)*(sin(theta)^2 + cos(theta)^2)"}) {
    CHECK(mass.entry(0, text).empty());
  }
  CHECK(mass.entry(3, "m*l^2").empty());
}

TEST_CASE("another value is told, and what cannot be read") {
  Mass mass;
  CHECK_THAT(mass.entry(0, "M - m"), Catch::Contains("`M - m` is 1.0 where 1.2 was derived"));
  CHECK_THAT(mass.entry(0, "M + m + x*1e-30"), Catch::Contains("was derived"));
  for (const char* text : {"M +", "M + mm", "M + f(m)", "M^m", "sin(M, m)", "M = m", ""}) {
    INFO(text);
    CHECK_FALSE(mass.entry(0, text).empty());
  }
}

TEST_CASE("a definition is known from where it stands") {
  Mass mass;
  CHECK_THAT(mass.entry(1, "t_679f3*cos(theta)"), Catch::Contains("is not defined here"));
  CHECK(mass.reader.definition("t_679f3", "m*l").empty());
  CHECK(mass.entry(1, "t_679f3*cos(theta)").empty());
  CHECK_THAT(mass.reader.definition("t_679f3", "m*l"), Catch::Contains("is defined twice"));
  CHECK_THAT(mass.reader.definition("t_1", "m*l"), Catch::Contains("is no definition"));
  CHECK_THAT(mass.reader.definition("cos_theta", "sin(theta)"), Catch::Contains("was derived"));
}

TEST_CASE("a number is compared in forty digits") {
  Mass mass;
  CHECK(mass.reader.number(cln::cl_RA(1) / 3, "1/3").empty());
  CHECK_FALSE(mass.reader.number(cln::cl_RA(1) / 3, "0.3333333333").empty());
  CHECK_FALSE(mass.reader.number(0, "a").empty());
}

}  // namespace elgen
