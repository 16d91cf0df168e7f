// A certificate with every verdict and evidence.
#pragma once

#include <cmath>

#include "elgen/certificate.hpp"

namespace elgen::test {

inline CertificateRow row(const std::string& check, const std::string& output, Verdict verdict) {
  CertificateRow result;
  result.check = check;
  result.output = result.subject = output;
  result.verdict = verdict;
  return result;
}

inline Certificate sample() {
  CertificateRow proved = row("[[expect]]", "[[expect]] gravity", Verdict::holds);
  proved.subject = "gravity[1]";
  proved.worst = "equal";
  proved.evidence = Evidence::proof;
  CertificateRow mass = row("program vs oracle", "mass_matrix", Verdict::holds);
  mass.subject = "mass_matrix (double)";
  mass.formula = "|x - x*| / (u B)";
  mass.samples = 276;
  mass.skipped = {{Obstacle::overflow, 2}, {Obstacle::undefined, 1}};
  mass.error = 1.25;
  mass.worst = "1.2 u B";
  mass.where = "q = (1, 2)";
  mass.tolerance = "8 u B";
  CertificateRow bias = row("program vs oracle", "bias", Verdict::fails);
  bias.subject = "bias (double)";
  bias.formula = mass.formula;
  bias.samples = 276;
  bias.error = HUGE_VAL;
  bias.worst = "inf u B";
  bias.where = "q = (3, 4)";
  CertificateRow zeros = row("zeros that are not proved", "mass_matrix", Verdict::holds);
  zeros.evidence = Evidence::zeros;
  zeros.samples = 64;
  zeros.worst = "in entry 1";
  CertificateRow pivots = row("mass matrix positive definite", "mass_matrix", Verdict::skipped);
  pivots.skipped = {{Obstacle::singular, 32}};
  pivots.worst = "no regular state";
  return {"cart_pole", "full", 7, {proved, mass, bias, zeros, pivots}};
}

}  // namespace elgen::test
