// The rows, each with what makes its steps.
#include "simulate/steps/methods.hpp"

#include <array>

namespace elgen {

std::span<const MethodRow> method_table() {
  static constexpr std::array table{
      MethodRow{"rk4", StepKind::fixed, {}, &make_rk4},
      MethodRow{"dopri5", StepKind::adapted, {}, &make_dopri5},
      MethodRow{"verlet", StepKind::fixed, StepMethod::verlet, &make_step_program},
      MethodRow{"midpoint", StepKind::fixed, StepMethod::midpoint, &make_step_program}};
  return table;
}

const MethodRow& reference_method() {
  static constexpr MethodRow row{"fehlberg78", StepKind::adapted, {}, &make_fehlberg78};
  return row;
}

}  // namespace elgen
