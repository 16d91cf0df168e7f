// E603: the rows of the Jacobian of an [[output]] are linearly dependent at every sampled state,
// although the scene requests its operational-space equation of motion.
#include <fmt/format.h>

#include <algorithm>

#include "base/reason.hpp"
#include "inspect/checks.hpp"
#include "inspect/null_space.hpp"
#include "inspect/samples.hpp"
#include "model/requests.hpp"

namespace elgen {
namespace {

constexpr unsigned draw_count = 4;

std::size_t sampled_jacobian_rank(const InspectedModel& subject, const OutputRequest& jacobian) {
  const std::size_t n = subject.model.velocities.size();
  std::size_t rank = 0;
  for (unsigned seed = 0; seed < draw_count; ++seed) {
    const OracleValues rows = oracle_values(subject.model, jacobian, sample_state(subject, seed));
    if (rows) rank = std::max(rank, n - null_space(*rows, row_scales(*rows, n)).size());
  }
  return rank;
}

}  // namespace

Diagnostics inspect_tasks(const InspectedModel& subject) {
  const Model& model = subject.model;
  Diagnostics errors;
  for (const OutputRequest& output : subject.scene.outputs) {
    if (output_row(output.kind).singular_fault != SingularFault::dependent_task) continue;
    const std::size_t rank =
        sampled_jacobian_rank(subject, make_request(model, OutputKind::user_jacobian, output.user));
    if (rank == output.rows) continue;
    errors.push_back({Reason::dependent_task, output.span,
                      fmt::format("`{}` has no value: its Jacobian has rank {} of {}", output.name,
                                  rank, output.rows),
                      "give an output whose entries move independently",
                      model.outputs[output.user].span, "declared here"});
  }
  return errors;
}

}  // namespace elgen
