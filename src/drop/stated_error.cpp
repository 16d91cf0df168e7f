// stated_error: constant + sum_j by_acceleration[j] |a_j|
#include "elgen/drop.hpp"

namespace elgen {

Real stated_error(const Program& program, OutputKind output, std::size_t entry,
                  const State& state) {
  static const cln::cl_RA slack = 1 + cln::expt(cln::cl_RA(2), -20);
  const ReducedOutput* reduced =
      program.reduction ? find_reduced(*program.reduction, output) : nullptr;
  if (reduced == nullptr) return {};
  const EntryError& error = reduced->errors[entry];
  cln::cl_R total = error.constant;
  for (std::size_t j = 0; j < error.by_acceleration.size(); ++j) {
    total = total + error.by_acceleration[j] * cln::abs(state.a[j]);
  }
  return Real(total * slack);
}

}  // namespace elgen
