// recursive_program: the three stages one after another.
#include "pipeline/recursive_program.hpp"

#include "elgen/cancel.hpp"
#include "elgen/lower.hpp"

namespace elgen {

Result<Program> recursive_program(const Lagrangian& lagrangian,
                                  const std::vector<OutputRequest>& outputs, const Limits& limits) {
  const Result<EquationsOfMotion> equations = derive(lagrangian, outputs, limits);
  if (!equations) return equations.diagnostics;
  Result<Program> lowered = lower(*equations, outputs, limits);
  if (!lowered) return lowered.diagnostics;
  return cancel(std::move(*lowered));
}

}  // namespace elgen
