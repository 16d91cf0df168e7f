// The rows of methods.def.
#include "simulate/steps/methods.hpp"

#include <array>

namespace elgen {

std::span<const MethodRow> method_table() {
  static constexpr std::array table{
#define ELGEN_METHOD(name, step, domain) \
  MethodRow{#name, StepKind::step, MethodDomain::domain, &make_##name},
#include "simulate/steps/methods.def"
#undef ELGEN_METHOD
  };
  return table;
}

}  // namespace elgen
