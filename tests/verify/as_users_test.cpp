// As users compile: what rounds otherwise but within its bounds holds, what does not fails.
#include "verify/bounds/as_users.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "verify/bounds/accuracy.hpp"
#include "verify/changed_code.hpp"
#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// The row of cart_pole's code with what `change` makes of the first entry of its bias.
template <class Scalar>
CertificateRow row_with(const std::function<double(double)>& change, const Sampling& sampling) {
  const System system = cart_pole_system();
  const Changed code(system.program, "bias", change);
  AccuracyOptions options;
  options.visit.as_users = &code;
  const auto states = sample_states<Scalar>(system.subject(), sampling);
  for (CertificateRow& row : check_accuracy(system.subject(), states, options)) {
    if (row.check == "as users compile") return std::move(row);
  }
  FAIL("no such row");
  return {};
}

}  // namespace

TEST_CASE("the code as users compile it has one row of all outputs") {
  const auto same = [](double x) { return x; };
  const CertificateRow row = row_with<double>(same, {4, 1, false});
  CHECK(row.verdict == Verdict::holds);
  CHECK(row.subject == "all outputs (double)");
  CHECK(row.samples == 4);
  REQUIRE(row.error);
  CHECK(*row.error <= promised_bounds);
  CHECK(row.worst.find("21 outputs within ") == 0);
  CHECK(row_with<float>(same, {4, 1, true}).subject == "all outputs (float)");
}

TEST_CASE("another rounding holds, an error beyond the bound fails and is named") {
  const Sampling ordinary{4, 1, false};
  const auto last_bit = [](double x) { return std::nextafter(x, 1e9); };
  CHECK(row_with<double>(last_bit, ordinary).verdict == Verdict::holds);
  const auto wrong = [](double x) { return x * (1 + 1e-12); };
  const CertificateRow row = row_with<double>(wrong, ordinary);
  CHECK(row.verdict == Verdict::fails);
  CHECK(row.worst.find("bias (double): ") == 0);
  CHECK(row.worst.find(" times its error bound") != std::string::npos);
  CHECK(row.where.find("q = (") == 0);
}

TEST_CASE("without a state nothing is said") {
  const System system = cart_pole_system();
  const CertificateRow row = AsUsersRecord().row(system.subject(), "double");
  CHECK(row.verdict == Verdict::skipped);
  CHECK(row.worst == "no state to compare at");
}
