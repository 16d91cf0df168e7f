// specialise: fixed parameters become numbers throughout a Lagrangian, then what is locked leaves
// it.
//
//     before    p = l*sin(q), T = 1/2*m*p_dot^2      l = 1/2 fixed
//     after     p = 1/2*sin(q), T = 1/2*m*p_dot^2
//
// What vanishes is no longer reached from any energy, force or output, so later stages never see
// it. Then what a scene expands is expanded (expand.hpp).
#include "elgen/specialise.hpp"

#include <utility>

#include "specialise/expand.hpp"
#include "specialise/lock.hpp"
#include "specialise/replace.hpp"

namespace elgen {

namespace {

void fix(Lagrangian& lagrangian, const Specialisation& specialisation) {
  Seeds values;
  for (const auto& [parameter, number] : specialisation.fixed) {
    values.emplace(lagrangian.symbols.parameters[parameter], GiNaC::numeric(number));
  }
  replace(lagrangian, values);
}

}  // namespace

Lagrangian specialise(Lagrangian lagrangian, const Specialisation& specialisation) {
  if (!specialisation.fixed.empty()) fix(lagrangian, specialisation);
  if (!lagrangian.locked.empty()) lock(lagrangian);
  return lagrangian.expansion ? expanded(std::move(lagrangian)) : lagrangian;
}

}  // namespace elgen
