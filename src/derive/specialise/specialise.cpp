// specialise: replaces fixed parameters by numbers, then removes locked coordinates and the cyclic
// coordinates of `[routh]`.
//
//     before    p = l*sin(q), T = 1/2*m*p_dot^2      l = 1/2 fixed
//     after     p = 1/2*sin(q), T = 1/2*m*p_dot^2
//
// A definition that became 0 occurs in no energy, force or output, so later stages ignore it.
// If the scene requests an expansion, energies and forces are expanded at the end.
#include "elgen/specialise.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>

#include "derive/formulate/expressions.hpp"
#include "derive/specialise/passes.hpp"

namespace elgen {

namespace {

using GiNaC::ex;

void substitute_fixed_values(UnreducedLagrangian& lagrangian, const Model& model,
                             const FixedParameters& fixed) {
  Seeds values;
  for (const auto& [parameter, value] : fixed) {
    const ex number = value.exact_expression ? constant_value(model, *value.exact_expression)
                                             : ex(GiNaC::numeric(value.number));
    values.emplace(lagrangian.symbols.parameters[parameter], number);
  }
  substitute_leaves(lagrangian, values);
}

bool is_complex(const ex& value) {
  if (GiNaC::is_a<GiNaC::numeric>(value)) return !GiNaC::ex_to<GiNaC::numeric>(value).is_real();
  for (std::size_t i = 0; i < value.nops(); ++i) {
    if (is_complex(value.op(i))) return true;
  }
  return false;
}

struct ValueProblem {
  Code code;
  const char* text;
};

constexpr ValueProblem division_by_zero{Code::E312, "a denominator 0"};
constexpr ValueProblem undefined_value{Code::E313, "a value undefined"};
constexpr ValueProblem complex_value{Code::E314, "a value complex"};

using LagrangianPass = std::function<void(UnreducedLagrangian&)>;

/// Runs a step. Returns the first problem of the new values: a division by 0, an undefined value or
/// a complex value.
std::optional<ValueProblem> run_checked(const LagrangianPass& step,
                                        UnreducedLagrangian& lagrangian) {
  const std::size_t known = lagrangian.definitions.list.size();
  try {
    step(lagrangian);
  } catch (const GiNaC::pole_error& pole) {
    return pole.degree() == 0 ? undefined_value
                              : division_by_zero;  // degree 0: pole of a logarithm
  } catch (const std::domain_error&) {
    return undefined_value;
  }
  const auto& list = lagrangian.definitions.list;
  for (std::size_t i = known; i < list.size(); ++i) {
    if (is_complex(list[i].value)) return complex_value;
  }
  // A small term has no definition, so energies and forces are checked too.
  for (const EnergyTerms* const terms : {&lagrangian.kinetic, &lagrangian.potential,
                                         &lagrangian.dissipation, &lagrangian.lagrangian}) {
    if (std::ranges::any_of(*terms, is_complex, &EnergyTerm::value)) return complex_value;
  }
  if (std::ranges::any_of(lagrangian.forces, is_complex)) return complex_value;
  return std::nullopt;
}

/// The step that fixes one parameter or locks one coordinate. diagnose() runs `step` alone to find
/// the cause of a problem.
struct SinglePass {
  std::string name;
  Span span;
  LagrangianPass step;
};

struct SingularAndPlural {
  std::string singular;
  std::string plural;
};

/// The error for `problem`. The error names the first of `parts` that fails alone; if no part fails
/// alone, the error names all parts.
Diagnostic diagnose(const ValueProblem& problem, const std::vector<SinglePass>& parts,
                    const UnreducedLagrangian& before, const SingularAndPlural& at) {
  std::string names;
  for (const SinglePass& part : parts) {
    UnreducedLagrangian trial = before;
    const auto found = run_checked(part.step, trial);
    if (found) {
      return {found->code, part.span,
              "`" + part.name + "` " + at.singular + " makes " + found->text +
                  ", whatever the state is"};
    }
    names += (names.empty() ? "`" : ", `") + part.name + "`";
  }
  return {problem.code, parts.front().span,
          names + " " + at.plural + " make " + problem.text + ", whatever the state is"};
}

Diagnostics fix_parameters(UnreducedLagrangian& lagrangian, const CheckedModel& checked) {
  const auto& fixed = checked.scene.specialisation.fixed;
  const Model& model = checked.model;
  const UnreducedLagrangian before = lagrangian;
  const auto problem =
      run_checked([&](UnreducedLagrangian& whole) { substitute_fixed_values(whole, model, fixed); },
                  lagrangian);
  if (!problem) return {};
  std::vector<SinglePass> parts;
  for (const auto& entry : fixed) {
    const Parameter& parameter = model.parameters[entry.first];
    parts.push_back(
        {parameter.name, model.parameter_arrays[parameter.array].span,
         [&](UnreducedLagrangian& part) { substitute_fixed_values(part, model, {entry}); }});
  }
  return {diagnose(*problem, parts, before, {"at its fixed value", "at their fixed values"})};
}

Diagnostics lock_coordinates(UnreducedLagrangian& lagrangian) {
  const UnreducedLagrangian before = lagrangian;
  const auto problem = run_checked(apply_locks, lagrangian);
  if (!problem) return {};
  std::vector<SinglePass> parts;
  for (std::size_t i = 0; i < before.locked.size(); ++i) {
    parts.push_back({before.leaves.q[before.locked[i].coordinate], before.locked[i].span,
                     [i](UnreducedLagrangian& part) {
                       part.locked = {part.locked[i]};
                       apply_locks(part);
                     }});
  }
  return {diagnose(*problem, parts, before, {"where it is locked", "where they are locked"})};
}

Diagnostics remove_cyclic_coordinates(UnreducedLagrangian& lagrangian,
                                      const CheckedModel& checked) {
  const auto problem = run_checked(apply_routh_reduction, lagrangian);
  if (!problem) return {};
  return {{problem->code, checked.model.reduction.cyclic.front().span,
           "`[routh]` makes " + std::string(problem->text) + ", whatever the state is"}};
}

}  // namespace

Result<Lagrangian> specialise(UnreducedLagrangian lagrangian, const CheckedModel& checked) {
  Diagnostics errors;
  if (!checked.scene.specialisation.fixed.empty()) errors = fix_parameters(lagrangian, checked);
  if (errors.empty() && !lagrangian.locked.empty()) errors = lock_coordinates(lagrangian);
  if (errors.empty() && !lagrangian.cyclic.empty())
    errors = remove_cyclic_coordinates(lagrangian, checked);
  if (!errors.empty()) return errors;
  Lagrangian& rest = lagrangian;  // without locked and cyclic variables
  return rest.expansion ? expand_energies(std::move(rest)) : std::move(rest);
}

}  // namespace elgen
