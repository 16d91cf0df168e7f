// specialise: replaces fixed parameters by numbers, then removes locked coordinates and the cyclic
// coordinates of `[routh]`.
//
//     before    p = l*sin(q), T = 1/2*m*p_dot^2      l = 1/2 fixed
//     after     p = 1/2*sin(q), T = 1/2*m*p_dot^2
//
// No energy, force or output refers to a definition that became 0, so later stages do not see it.
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

void fix(WholeLagrangian& lagrangian, const Model& model, const FixedParameters& fixed) {
  Seeds values;
  for (const auto& [parameter, value] : fixed) {
    const ex number =
        value.form ? constant_value(model, *value.form) : ex(GiNaC::numeric(value.number));
    values.emplace(lagrangian.symbols.parameters[parameter], number);
  }
  replace(lagrangian, values);
}

bool is_complex(const ex& value) {
  if (GiNaC::is_a<GiNaC::numeric>(value)) return !GiNaC::ex_to<GiNaC::numeric>(value).is_real();
  for (std::size_t i = 0; i < value.nops(); ++i) {
    if (is_complex(value.op(i))) return true;
  }
  return false;
}

struct Problem {
  Code code;
  const char* text;
};

constexpr Problem division{Code::E312, "a denominator 0"};
constexpr Problem undefined{Code::E313, "a value undefined"};
constexpr Problem complex{Code::E314, "a value complex"};

using Step = std::function<void(WholeLagrangian&)>;

/// Runs a step. Returns the first problem of its values: a division by 0, an undefined value or a
/// complex value.
std::optional<Problem> run_checked(const Step& step, WholeLagrangian& lagrangian) {
  const std::size_t known = lagrangian.definitions.list.size();
  try {
    step(lagrangian);
  } catch (const GiNaC::pole_error& pole) {
    return pole.degree() == 0 ? undefined : division;  // degree 0: pole of a logarithm
  } catch (const std::domain_error&) {
    return undefined;
  }
  const auto& list = lagrangian.definitions.list;
  for (std::size_t i = known; i < list.size(); ++i) {
    if (is_complex(list[i].value)) return complex;
  }
  // A small term has no definition, so energies and forces are checked too.
  for (const EnergyTerms* const terms : {&lagrangian.kinetic, &lagrangian.potential,
                                         &lagrangian.dissipation, &lagrangian.lagrangian}) {
    if (std::ranges::any_of(*terms, is_complex, &EnergyTerm::value)) return complex;
  }
  if (std::ranges::any_of(lagrangian.forces, is_complex)) return complex;
  return std::nullopt;
}

/// One fixed parameter or one lock. It is run by itself to find the cause of a problem.
struct StepPart {
  std::string name;
  Span span;
  Step step;
};

struct Phrases {
  std::string one;
  std::string many;
};

/// The error for a problem. It names the first part that fails by itself; if no part fails by
/// itself, it names all parts.
Diagnostic diagnose(const Problem& problem, const std::vector<StepPart>& parts,
                    const WholeLagrangian& before, const Phrases& at) {
  std::string names;
  for (const StepPart& part : parts) {
    WholeLagrangian trial = before;
    const auto found = run_checked(part.step, trial);
    if (found) {
      return {
          found->code, part.span,
          "`" + part.name + "` " + at.one + " makes " + found->text + ", whatever the state is"};
    }
    names += (names.empty() ? "`" : ", `") + part.name + "`";
  }
  return {problem.code, parts.front().span,
          names + " " + at.many + " make " + problem.text + ", whatever the state is"};
}

Diagnostics fix_parameters(WholeLagrangian& lagrangian, const CheckedModel& checked) {
  const auto& fixed = checked.scene.specialisation.fixed;
  const Model& model = checked.model;
  const WholeLagrangian before = lagrangian;
  const auto problem =
      run_checked([&](WholeLagrangian& whole) { fix(whole, model, fixed); }, lagrangian);
  if (!problem) return {};
  std::vector<StepPart> parts;
  for (const auto& entry : fixed) {
    const Parameter& parameter = model.parameters[entry.first];
    parts.push_back({parameter.name, model.parameter_arrays[parameter.array].span,
                     [&](WholeLagrangian& part) { fix(part, model, {entry}); }});
  }
  return {diagnose(*problem, parts, before, {"at its fixed value", "at their fixed values"})};
}

Diagnostics lock_coordinates(WholeLagrangian& lagrangian) {
  const WholeLagrangian before = lagrangian;
  const auto problem = run_checked(lock, lagrangian);
  if (!problem) return {};
  std::vector<StepPart> parts;
  for (std::size_t i = 0; i < before.locked.size(); ++i) {
    parts.push_back({before.leaves.q[before.locked[i].coordinate], before.locked[i].span,
                     [i](WholeLagrangian& part) {
                       part.locked = {part.locked[i]};
                       lock(part);
                     }});
  }
  return {diagnose(*problem, parts, before, {"where it is locked", "where they are locked"})};
}

Diagnostics remove_cyclic(WholeLagrangian& lagrangian, const CheckedModel& checked) {
  const auto problem = run_checked(routh, lagrangian);
  if (!problem) return {};
  return {{problem->code, checked.model.variant.cyclic.front().span,
           "`[routh]` makes " + std::string(problem->text) + ", whatever the state is"}};
}

}  // namespace

Result<Lagrangian> specialise(WholeLagrangian lagrangian, const CheckedModel& checked) {
  Diagnostics errors;
  if (!checked.scene.specialisation.fixed.empty()) errors = fix_parameters(lagrangian, checked);
  if (errors.empty() && !lagrangian.locked.empty()) errors = lock_coordinates(lagrangian);
  if (errors.empty() && !lagrangian.cyclic.empty()) errors = remove_cyclic(lagrangian, checked);
  if (!errors.empty()) return errors;
  Lagrangian& rest = lagrangian;  // without locked and cyclic variables
  return rest.expansion ? expanded(std::move(rest)) : std::move(rest);
}

}  // namespace elgen
