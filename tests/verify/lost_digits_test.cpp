// Lost digits: a figure for every output, with its entry and its whole state.
#include "verify/bounds/lost_digits.hpp"

#include <catch2/catch.hpp>

#include "verify/bounds/accuracy.hpp"
#include "verify/pendulum_forms.hpp"

using namespace elgen;
using namespace elgen::test;
using namespace elgen::test::pendulum_forms;

namespace {

CertificateRow row_of(const System& system, Losing losing) {
  const Subject subject = system.subject();
  const auto samples = sample_states<double>(subject, {16, 1, true});
  for (const CertificateRow& row :
       check_accuracy(subject, samples, {{Comparison::entries, nullptr, losing}, {}})) {
    if (row.check == "digits lost") return row;
  }
  FAIL("no row");
  return {};
}

bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The cosine form where the angle stays near 0.
System near_zero(const char* range) {
  System system = written_as(cosine);
  system.model.coordinates[0].range = Interval{0, exact(range)};
  return system;
}

}  // namespace

TEST_CASE("inside the ranges 1 - cos(th) loses little, at the extremes everything") {
  const System system = written_as(cosine);
  const CertificateRow inside = row_of(system, Losing::inside_ranges);
  CHECK(inside.verdict == Verdict::holds);
  CHECK(inside.output == "potential_energy");
  CHECK(inside.subject == "potential_energy (double)");
  CHECK(inside.loss.value_or(1e9) < 64);
  const CertificateRow beyond = row_of(system, Losing::everywhere);
  CHECK(beyond.verdict == Verdict::noted);
  CHECK(beyond.loss.value_or(0) > 1e8);
}

TEST_CASE("half of the digits lost inside the ranges is noted, with a state of 17 digits") {
  const CertificateRow row = row_of(near_zero("1e-6"), Losing::inside_ranges);
  CHECK(row.verdict == Verdict::noted);
  CHECK(mentions(row.worst, "digits of potential_energy (of the largest entry "));
  CHECK(mentions(row.where, "q = ("));
  CHECK(row.where.size() > 60);
  CHECK(row_of(near_zero("1e-1"), Losing::inside_ranges).verdict == Verdict::holds);
}

TEST_CASE("a form that keeps its digits loses none") {
  const CertificateRow row = row_of(written_as(half_angle), Losing::everywhere);
  CHECK(row.verdict == Verdict::holds);
  CHECK(row.samples > 30);
  CHECK(row.loss.value_or(100) <= tolerated_loss);
}

TEST_CASE("losses are not measured where nobody asks") {
  const System system = written_as(cosine);
  const auto samples = sample_states<double>(system.subject(), {4, 1, false});
  CHECK(check_accuracy(system.subject(), samples).size() == 1);
}

TEST_CASE("states are counted once, however many fields an output has") {
  const System system = cart_pole_system();
  const auto samples = sample_states<double>(system.subject(), {8, 1, false});
  for (const CertificateRow& row : check_accuracy(
           system.subject(), samples, {{Comparison::entries, nullptr, Losing::everywhere}, {}})) {
    if (row.check == "digits lost") CHECK(row.samples <= samples.size());
  }
}
