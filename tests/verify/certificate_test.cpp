// The certificate as text and as JSON.
#include "elgen/certificate.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "support/text.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

CertificateRow row_of(const std::string& check, const std::string& output, Verdict verdict) {
  CertificateRow row;
  row.check = check;
  row.output = row.subject = output;
  row.verdict = verdict;
  return row;
}

/// A certificate with every verdict and every kind of evidence.
Certificate sample() {
  CertificateRow proved = row_of("[[expect]]", "[[expect]] gravity", Verdict::holds);
  proved.subject = "gravity[1]";
  proved.worst_value = "equal";
  proved.evidence = Evidence::proof;
  CertificateRow mass = row_of("program vs oracle", "mass_matrix", Verdict::holds);
  mass.subject = "mass_matrix (double)";
  mass.formula = "x = x*";
  mass.samples = 276;
  mass.skipped = {{SkipReason::overflow, 2}, {SkipReason::undefined, 1}};
  mass.loss = 2.5;
  mass.worst_value = "equal";
  mass.worst_state = "q = (1, 2)";
  mass.tolerance = "50 digits";
  CertificateRow bias = row_of("program vs oracle", "bias", Verdict::fails);
  bias.subject = "bias (double)";
  bias.formula = mass.formula;
  bias.samples = 276;
  bias.worst_value = "entry 1 is inf";
  bias.worst_state = "q = (3, 4)";
  CertificateRow zeros = row_of("zeros that are not proved", "mass_matrix", Verdict::holds);
  zeros.evidence = Evidence::zeros;
  zeros.samples = 64;
  zeros.worst_value = "in entry 1";
  CertificateRow pivots = row_of("mass matrix positive definite", "mass_matrix", Verdict::skipped);
  pivots.skipped = {{SkipReason::singular, 32}};
  pivots.worst_value = "no regular state";
  return {"cart_pole", "full", 7, {proved, mass, bias, zeros, pivots}};
}

}  // namespace

TEST_CASE("each output has a line, failures are printed in full, and skipped rows have a reason") {
  CHECK(to_text(sample()) == R"(certificate of cart_pole, scene full, seed 7

  holds    [[expect]] gravity  1 check, proved
  holds    mass_matrix         3 checks, at 276 states, at most 0.4 digits lost, relies on unproved zeros
           skipped: mass matrix positive definite, mass_matrix
           because    32 singular
  FAILS    bias                1 of 1 check
           program vs oracle, bias (double)
           worst      entry 1 is inf
           formula    x = x*
           decided    at 276 states
           worst at   q = (3, 4)

3 checks hold, 1 fails, 1 skipped
)");
}

TEST_CASE("a loss states the number of its states, the fewest of its rows") {
  CertificateRow often = row_of("compiled code vs program", "linearization", Verdict::holds);
  often.samples = 264;
  CertificateRow seldom = row_of("program vs oracle", "linearization", Verdict::holds);
  seldom.loss = 3;
  seldom.samples = 17;
  CertificateRow in_float = seldom;
  in_float.samples = 16;
  const Certificate certificate{"arm", "full", 1, {often, seldom, in_float}};
  CHECK(mentions(to_text(certificate),
                 "linearization  3 checks, at 16 states, at most 0.5 digits lost\n"));
  const Certificate bits{"arm", "full", 1, {often}};
  CHECK(mentions(to_text(bits), "linearization  1 check, at 264 states\n"));
}

TEST_CASE("the line of an output counts skipped states inside the ranges") {
  Certificate certificate = sample();
  certificate.rows[1].skipped_in_ranges = 2;
  CHECK(mentions(to_text(certificate),
                 "3 checks, at 276 states, 2 inside the ranges skipped, at most 0.4 digits"));
}

TEST_CASE("an output that was not compared is skipped with the reason") {
  CertificateRow row = row_of("compiled code vs program", "compiled code", Verdict::skipped);
  row.worst_value = "<Eigen/Core> is not installed";
  const std::string text = to_text({"arm", "full", 1, {row}});
  CHECK(mentions(text, "           because    <Eigen/Core> is not installed\n"));
}

TEST_CASE("in the full text every row states its evidence") {
  CHECK(to_full_text(sample()) == R"(certificate of cart_pole, scene full, seed 7

[[expect]]
  holds    gravity[1]            equal
           decided    for every state, by proof

program vs oracle
  holds    mass_matrix (double)  equal
           formula    x = x*
           decided    at 276 states
           skipped    2 overflow, 1 outside the domain
           worst at   q = (1, 2)
           tolerance  50 digits
  FAILS    bias (double)         entry 1 is inf
           formula    x = x*
           decided    at 276 states
           worst at   q = (3, 4)

zeros that are not proved
  holds    mass_matrix           in entry 1
           decided    at 64 random points

mass matrix positive definite
  skipped  mass_matrix           no regular state
           decided    at 0 states
           skipped    32 singular

3 checks hold, 1 fails, 1 skipped
)");
}

TEST_CASE("the verdict is one line") {
  Certificate certificate = sample();
  CHECK(verdict_line(certificate) == "cart_pole: 3 checks hold, 1 fails, 1 skipped\n");
  certificate.scene = "balance";
  CHECK(verdict_line(certificate) ==
        "cart_pole, scene balance: 3 checks hold, 1 fails, 1 skipped\n");
}

TEST_CASE("a certificate holds when no row fails") {
  Certificate certificate = sample();
  CHECK_FALSE(holds(certificate));
  certificate.rows[2].verdict = Verdict::holds;
  CHECK(holds(certificate));
}

TEST_CASE("notes are counted, and printed with their states") {
  Certificate certificate = sample();
  CertificateRow row = row_of("digits lost", "gravity", Verdict::noted);
  row.worst_value = "loss 1e+03, 3.0 digits of entry 1";
  row.worst_state = "q = (1, 2)";
  certificate.rows = {row};
  CHECK(verdict_line(certificate) == "cart_pole: 0 checks hold, 0 fail, 0 skipped, 1 noted\n");
  CHECK(mentions(to_text(certificate),
                 "           noted: digits lost, gravity\n"
                 "           worst      loss 1e+03, 3.0 digits of entry 1\n"
                 "           worst at   q = (1, 2)\n"));
  CHECK(holds(certificate));
}

TEST_CASE("an output with only notes is called noted") {
  const Certificate certificate{
      "arm", "full", 1, {row_of("as users compile", "as users compile", Verdict::noted)}};
  CHECK(mentions(to_text(certificate), "  noted    as users compile"));
}

TEST_CASE("an incomplete set of equations is counted, and the verdict may come first") {
  CertificateRow row = row_of("[[expect]]", "[[expect]] equations", Verdict::holds);
  row.subject = "equations";
  row.evidence = Evidence::proof;
  row.worst_value = "row x";
  CertificateRow rank = row_of("[[expect]]", "[[expect]] equations", Verdict::noted);
  rank.subject = "accelerations";
  rank.samples = 8;
  rank.worst_value = "1 of 3 stated";
  rank.stated = StatedEquations{1, 3};
  const Certificate certificate{"crane", "full", 1, {row, rank}};
  CHECK(to_full_text(certificate, true) ==
        "crane: 1 check holds, 0 fail, 0 skipped, 1 noted, 1 of 3 equations stated\n\n"
        "[[expect]]\n"
        "  holds    equations      row x\n"
        "           decided    for every state, by proof\n"
        "  noted    accelerations  1 of 3 stated\n"
        "           decided    at 8 states\n");
  CHECK(to_text(certificate)
            .find("  holds    [[expect]] equations  2 checks, some proved, 1 of 3 "
                  "equations stated\n") != std::string::npos);
  const auto json = nlohmann::json::parse(to_json(certificate));
  CHECK(json.at("checks").at(1).at("equations").at("stated") == 1);
  CHECK(json.at("checks").at(1).at("equations").at("needed") == 3);
  CHECK_FALSE(json.at("checks").at(0).contains("equations"));
}

TEST_CASE("the JSON contains everything") {
  const auto json = nlohmann::json::parse(to_json(sample()));
  CHECK(json.at("model") == "cart_pole");
  CHECK(json.at("scene") == "full");
  CHECK(json.at("seed") == 7);
  CHECK(json.at("holds") == 3);
  CHECK(json.at("fails") == 1);
  CHECK(json.at("skipped") == 1);
  const auto& mass = json.at("checks").at(1);
  CHECK(mass.at("output") == "mass_matrix");
  CHECK(mass.at("evidence") == "states");
  CHECK(mass.at("skipped_states") == nlohmann::json{{"overflow", 2}, {"undefined", 1}});
  CHECK(mass.at("loss") == 2.5);
  CHECK_FALSE(json.at("checks").at(2).contains("loss"));
}
