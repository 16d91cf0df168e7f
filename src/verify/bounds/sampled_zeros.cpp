// sampled_zeros: what the certificate says of the zeros that cancel sampled (elgen/cancel.hpp).
#include "verify/bounds/sampled_zeros.hpp"

#include <fmt/format.h>

namespace elgen {
namespace {

std::string numbers(const std::vector<std::uint32_t>& entries) {
  std::string text;
  for (const std::uint32_t entry : entries) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", entry + 1);
  }
  return text;
}

}  // namespace

std::size_t count_sampled_zeros(const Program& program) {
  std::size_t count = 0;
  for (const Function& function : program.functions) {
    if (!output_row(function.kind).repeats) count += function.sampled_zeros.size();
  }
  return count;
}

std::vector<CertificateRow> sampled_zeros(const Program& program) {
  std::vector<CertificateRow> rows;
  for (const Function& function : program.functions) {
    if (function.sampled_zeros.empty()) continue;
    CertificateRow row;
    row.check = "zeros that are not proved";
    row.output = row.subject = function.name;
    row.formula = "|x| <= 1e-40 B in 60 digits, of what is taken for 0";
    row.evidence = Evidence::zeros;
    row.samples = zero_points;
    row.worst = fmt::format("in entr{} {}", function.sampled_zeros.size() == 1 ? "y" : "ies",
                            numbers(function.sampled_zeros));
    row.tolerance = "20 digits above rounding: no proof, but a value that is not 0 would not do it";
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace elgen
