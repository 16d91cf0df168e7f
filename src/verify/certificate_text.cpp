// to_text: one paragraph of aligned lines per row, with equal checks under one heading, and a
// summary line:
//
//     certificate of cart_pole, scene full, seed 1
//
//     program vs oracle
//       holds    mass_matrix (double)   1.2 u B
//                formula    |x - x*| / (u B)
//                samples    276
//     …
//     41 checks hold, 0 fail, 2 skipped
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "elgen/certificate.hpp"

namespace elgen {
namespace {

std::string_view word(Verdict verdict) {
  constexpr std::array<std::string_view, 3> words{"holds", "FAILS", "skipped"};
  return words[static_cast<std::size_t>(verdict)];
}

void append_detail(std::string& text, std::string_view label, const std::string& value) {
  if (!value.empty()) text += fmt::format("           {:<10} {}\n", label, value);
}

void append_row(std::string& text, const CertificateRow& row, std::size_t subject_width) {
  text +=
      fmt::format("  {:<8} {:<{}}  {}\n", word(row.verdict), row.subject, subject_width, row.worst);
  append_detail(text, "formula", row.formula);
  append_detail(text, "samples", std::to_string(row.samples));
  append_detail(text, "worst at", row.where);
  append_detail(text, "tolerance", row.tolerance);
}

std::size_t widest_subject(const std::vector<CertificateRow>& rows) {
  std::size_t width = 0;
  for (const CertificateRow& row : rows) width = std::max(width, row.subject.size());
  return width;
}

std::size_t count(const Certificate& certificate, Verdict verdict) {
  return static_cast<std::size_t>(
      std::count_if(certificate.rows.begin(), certificate.rows.end(),
                    [verdict](const CertificateRow& row) { return row.verdict == verdict; }));
}

}  // namespace

bool holds(const Certificate& certificate) { return count(certificate, Verdict::fails) == 0; }

std::string to_text(const Certificate& certificate) {
  std::string text = fmt::format("certificate of {}, scene {}, seed {}\n", certificate.model,
                                 certificate.scene, certificate.seed);
  const std::size_t width = widest_subject(certificate.rows);
  std::string_view heading;
  for (const CertificateRow& row : certificate.rows) {
    if (row.check != heading) text += fmt::format("\n{}\n", row.check);
    heading = row.check;
    append_row(text, row, width);
  }
  return text + fmt::format("\n{} checks hold, {} fail, {} skipped\n",
                            count(certificate, Verdict::holds), count(certificate, Verdict::fails),
                            count(certificate, Verdict::skipped));
}

}  // namespace elgen
