// Runs a model text through all stages up to the choice of forms.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "elgen/cancel.hpp"
#include "elgen/choose.hpp"
#include "elgen/compose.hpp"
#include "elgen/equations_of_motion.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/lower.hpp"
#include "elgen/page.hpp"
#include "pipeline/combined_stages.hpp"
#include "support/models.hpp"

namespace elgen::test {

struct ChosenForms {
  CheckedModel checked;
  ClosedForms forms;
  FormChoice choice;
  Program recursive = {};  ///< the program before the choice; all forms are derived from it
};

inline ChosenForms chosen(const std::string& text, const SceneOptions& options = {},
                          Preference prefer = Preference::balanced) {
  ChosenForms result{checked_model(text, options), {}, {}, {}};
  result.checked.scene.numerics.prefer = prefer;
  const Result<UnreducedLagrangian> lagrangian = formulate(result.checked.model);
  const auto equations = derive(*lagrangian, result.checked.scene.outputs, {});
  result.recursive = compose_outputs(cancel(*lower(*equations, result.checked.scene.outputs, {})));
  result.forms = present(result.recursive);
  result.choice =
      *choose_forms(*lagrangian, result.recursive, result.forms, result.checked, Limits{});
  return result;
}

/// The entries in the first field of the function `name`, as text.
inline std::vector<std::string> readable(const ChosenForms& chosen, const std::string& name) {
  const Program& program = chosen.choice.program;
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    if (program.functions[i].name == name) return texts_of(equations(program, i).entries.at(0));
  }
  return {};
}

/// The state `q` at rest and without inputs; parameters have their declared values.
inline Arguments<double> state_at_rest(const ChosenForms& c, const std::vector<double>& q) {
  Arguments<double> point =
      domain_of({c.checked.model, c.checked.scene, c.recursive.leaves}).states.front();
  point.q = q;
  for (auto* rates : {&point.v, &point.a, &point.u}) std::ranges::fill(*rates, 0.0);
  return point;
}

}  // namespace elgen::test
