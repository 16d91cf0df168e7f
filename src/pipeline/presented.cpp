// presented: the parts of what is reduced are derived with it, so that all are sums over one
// algebra.
#include "pipeline/presented.hpp"

#include "pipeline/recursive_program.hpp"

namespace elgen {

Result<Presented> presented(const Lagrangian& lagrangian, const CheckedModel& checked,
                            const Program& recursive, const Limits& limits) {
  Presented result{present(recursive), {}};
  if (!checked.scene.dropping) return result;
  const Result<Program> whole = recursive_program(lagrangian, with_parts(checked.scene), limits);
  if (!whole) return whole.diagnostics;
  Result<ReducedForms> reduced = drop_terms(recursive, *whole, present(*whole), checked);
  if (!reduced) return reduced.diagnostics;
  result.reduced = std::move(*reduced);
  return result;
}

}  // namespace elgen
