// Sampled zeros: which entries rest on a zero that nobody proved.
#pragma once

#include <vector>

#include "elgen/certificate.hpp"

namespace elgen {

/// `dynamics` repeats the others and does not count.
[[nodiscard]] std::size_t count_sampled_zeros(const Program& program);

/// One row per function with such entries; it holds, since cancel looked at every point.
[[nodiscard]] std::vector<CertificateRow> sampled_zeros(const Program& program);

}  // namespace elgen
