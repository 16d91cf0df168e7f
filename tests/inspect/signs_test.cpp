// E523, E524 and E525: masses, kinetic energies and dissipations that are negative.
#include <catch2/catch.hpp>

#include "inspect/checks.hpp"
#include "inspect/found.hpp"
#include "oracle/samples.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string sign_findings(const ModelBuilder& b) {
  Diagnostics found = inspect_mass_matrix({b.model, {}});
  const Diagnostics signs = inspect_signs({b.model, {}});
  found.insert(found.end(), signs.begin(), signs.end());
  return text_of(found);
}

ModelBuilder coupled(const std::string& kinetic) {
  ModelBuilder b;
  b.coordinate("x").coordinate("th").parameter("m", "2").parameter("M", "3").T(kinetic);
  return b;
}

const std::string th_is_negative =
    "E524: M is not positive definite: motions of `th` have negative kinetic energy";

}  // namespace

TEST_CASE("a negative mass is named once") {
  ModelBuilder b;
  b.coordinate("x").parameter("m", "2").point("bob", {"x", "0"}, "-m");
  CHECK(sign_findings(b) == "E523: the mass of `bob` is -2");
  ModelBuilder positive;
  positive.coordinate("x").parameter("m", "2").point("bob", {"x", "0"}, "m");
  CHECK(sign_findings(positive).empty());
}

TEST_CASE("M has to be positive definite") {
  CHECK(sign_findings(coupled("1/2*M*x_d^2 + 1/2*m*th_d^2 + 1/2*m*cos(th)*x_d*th_d")).empty());
  CHECK(sign_findings(coupled("1/2*M*x_d^2 - 1/2*m*th_d^2")) == th_is_negative);
  CHECK(sign_findings(coupled("1/2*M*x_d^2 + 1/2*m*th_d^2 + 4*m*x_d*th_d")) == th_is_negative);
}

TEST_CASE("a chart that breaks is not negative, nor is a parameter that is 0") {
  CHECK(sign_findings(coupled("1/2*M*x_d^2 + 1/2*m*sin(th)^2*th_d^2")).empty());
  ModelBuilder zero;
  zero.coordinate("x").parameter("m", "0").point("bob", {"x", "0"}, "m");
  CHECK(sign_findings(zero).empty());
}

TEST_CASE("D brakes") {
  const std::string kinetic = "1/2*M*x_d^2 + 1/2*m*th_d^2";
  CHECK(sign_findings(coupled(kinetic).D("1/2*m*x_d^2")).empty());
  CHECK(sign_findings(coupled(kinetic).D("-1/2*m*x_d^2")) ==
        "E525: D is negative, so that it drives the motion");
}
