// E511: configurations at which the coordinates break.
#include <catch2/catch.hpp>

#include "inspect/checks.hpp"
#include "inspect/found.hpp"
#include "oracle/samples.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string chart_findings(const ModelBuilder& b) { return text_of(inspect_charts({b.model, {}})); }

}  // namespace

TEST_CASE("charts without a singular configuration pass") {
  CHECK(chart_findings(pendulum()).empty());
  CHECK(chart_findings(cart_pole()).empty());
  CHECK(chart_findings(double_pendulum()).empty());
}

TEST_CASE("special values at which M loses rank are listed") {
  CHECK(chart_findings(spherical_pendulum()) == "E511: the mass matrix loses rank at `th` = 0, pi");
  ModelBuilder polar;
  polar.coordinate("r", "m").coordinate("ph", "rad").T("r_d^2/2 + r^2*ph_d^2/2");
  CHECK(chart_findings(polar) == "E511: the mass matrix loses rank at `r` = 0");
  ModelBuilder latitude;
  latitude.coordinate("la", "rad").coordinate("lo", "rad").T("la_d^2 + cos(la)^2*lo_d^2");
  CHECK(chart_findings(latitude) == "E511: the mass matrix loses rank at `la` = pi/2, -pi/2");
}

TEST_CASE("values outside the declared range are not reached") {
  ModelBuilder b = spherical_pendulum();
  b.model.coordinates[0].range = Interval{1, 2};
  CHECK(chart_findings(b).empty());
}

TEST_CASE("a declared factor is reported as it is written, and not searched for") {
  ModelBuilder b = spherical_pendulum();
  const SourcePointer source = make_source("model.toml", "singular = \"sin(th)\"");
  const ExpressionId factor = b.expression("sin(th)");
  b.model.expressions[factor].span = {source.get(), 12, 19};
  b.model.coordinates[0].singular = factor;
  CHECK(chart_findings(b) == "E511: the chart of `th` breaks where `sin(th)` is zero");
}
