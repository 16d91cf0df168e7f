// as users compile: the largest error of all fields, and whose it is.
#include "verify/bounds/as_users.hpp"

#include <fmt/format.h>

namespace elgen {

void AsUsersRecord::add(const std::string& field, const Finding& finding, const State& state,
                        std::size_t at) {
  if (!finding.users_error) return;
  if (last_ != at) ++states_;
  last_ = at;
  fields_.insert(field);
  const double before = errors_.worst();
  const bool is_first = errors_.samples() == 0;
  errors_.add(*finding.users_error, state);
  if (!is_first && errors_.worst() <= before) return;
  worst_ = field;
  imprecision_ = finding.users_imprecision;
}

CertificateRow AsUsersRecord::row(const Subject& subject, std::string_view scalar) const {
  CertificateRow row;
  row.check = "as users compile";
  row.output = row.check;
  row.subject = fmt::format("all outputs ({})", scalar);
  row.formula = "|x - x*| / (u B); x of -O3 -march=native, contraction on";
  errors_.tell(row, subject, promised_bounds);
  row.samples = states_;
  row.tolerance = "8 u B + N eta, B as above";
  if (row.samples == 0) {
    row.worst = "no state to compare at";
    return row;
  }
  row.error = errors_.worst();
  row.worst = row.verdict == Verdict::fails
                  ? fmt::format("{}: {}", worst_, imprecision_)
                  : fmt::format("{} outputs within {:.2g} u B; most in {}", fields_.size(),
                                errors_.worst(), worst_);
  return row;
}

}  // namespace elgen
