// Avoidable losses: a row that fails where one way keeps the digits, and is noted where none does.
#include "verify/bounds/avoidable_loss.hpp"

#include <catch2/catch.hpp>

#include "verify/bounds/accuracy.hpp"
#include "verify/pendulum_forms.hpp"

using namespace elgen;
using namespace elgen::test;
using namespace elgen::test::pendulum_forms;

namespace {

CertificateRow row_of(const std::string& code, const std::string& way, std::size_t states = 16) {
  System system = written_as(code);
  const std::vector<Way> ways{{"other form", program_of(way)}};
  const Subject subject = system.subject();
  const auto samples = sample_states<double>(subject, {states, 1, true});
  for (const CertificateRow& row :
       check_accuracy(subject, samples, {{Comparison::entries, nullptr, &ways}, {}})) {
    if (row.check == "avoidable loss") return row;
  }
  FAIL("no row");
  return {};
}

bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("1 - cos(th) fails beside 2 sin(th/2)^2") {
  const CertificateRow row = row_of(cosine, half_angle);
  CHECK(row.verdict == Verdict::fails);
  CHECK(row.subject == "potential_energy (double)");
  CHECK(row.loss.value_or(0) > 1e6);
  CHECK(mentions(row.worst, "most of it in 1 - cos_th; the other form keeps them"));
}

TEST_CASE("terms that cancel fail beside the form without them") {
  CHECK(row_of(uncancelled, half_angle).verdict == Verdict::fails);
}

TEST_CASE("what loses nothing holds, whatever the other ways lose") {
  const CertificateRow row = row_of(half_angle, cosine);
  CHECK(row.verdict == Verdict::holds);
  CHECK(row.samples > 30);
  CHECK(row.loss.value_or(100) <= tolerated_loss);
}

TEST_CASE("a loss that no way avoids is noted") {
  const CertificateRow row = row_of(cosine, quotient);
  CHECK(row.verdict == Verdict::noted);
  CHECK(mentions(row.worst, "no known way keeps them there"));
}

TEST_CASE("a better way that costs more than digits are worth is noted") {
  const CertificateRow row = row_of(cosine, costly);
  CHECK(row.verdict == Verdict::noted);
  CHECK(mentions(row.worst, "the other form keeps them at 5.5 times the cost"));
}

TEST_CASE("nothing is said of losses where no ways are known") {
  const System system = written_as(cosine);
  const auto samples = sample_states<double>(system.subject(), {4, 1, false});
  CHECK(check_accuracy(system.subject(), samples).size() == 1);
}
