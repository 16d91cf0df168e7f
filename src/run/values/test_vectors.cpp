// Test vectors: draws states of several kinds in turn; finds how many digits of each value a double
// keeps.
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "elgen/wording.hpp"
#include "program/evaluate/subject.hpp"
#include "run/values/records.hpp"
#include "sample/states.hpp"
#include "verify/bounds/exact_run.hpp"

namespace elgen {
namespace {

using cln::cl_R;

constexpr int digits_of_double = 17;

struct VectorState {
  const char* place = "";
  State drawn = {};
  std::optional<State> kept = {};  ///< on the constraints; none: Newton's method fails
};

State start_of(const Subject& subject) {
  State state = start_state(subject.model, subject.scene);
  state.momenta = with_leaves(subject.model, state, {}).momenta;
  state.h = cln::cl_RA(1) / 100;
  return state;
}

/// State 0 is the start. Every third state has other parameters: half to twice the model's values,
/// or anywhere in their ranges.
VectorState state_number(const Subject& subject, std::size_t number, Sampler& draw) {
  if (number == 0) return {"start", start_of(subject)};
  const bool varies = number % 3 == 0;
  const std::size_t turn = varies ? 3 * (1 + number / 3) : 0;  // turn mod 3 = 0: rates up to 1
  State state = drawn_state(subject.model, subject.scene, draw, turn);
  state.h = cln::abs(draw.number()) / 10;
  if (varies) return {"parameters", std::move(state)};
  if (number % 3 == 2) return {"moving", std::move(state)};
  for (auto* const list : {&state.v, &state.momenta, &state.a, &state.u}) {
    list->assign(list->size(), cl_R(0));
  }
  return {"rest", std::move(state)};
}

/// Draws the states. Their numbers are exact doubles.
std::vector<VectorState> drawn_states(const Subject& subject, const VectorOptions& options) {
  Sampler draw(options.seed);
  std::vector<VectorState> states;
  for (std::size_t i = 0; i < options.samples; ++i) {
    VectorState& next = states.emplace_back(state_number(subject, i, draw));
    next.drawn = exact_state(subject, arguments_at<double>(next.drawn));
    next.kept = move_onto_constraints(subject.model, next.drawn);
  }
  return states;
}

/// The state at which an output is evaluated, on the constraints if this output is compared there;
/// none if the projection failed.
std::optional<State> state_for(const Subject& subject, OutputKind output, const VectorState& at) {
  if (!is_compared_on_constraints(subject.model, output)) return at.drawn;
  if (!at.kept) return std::nullopt;
  const State state = compared_state(subject.model, output, at.drawn, *at.kept);
  return exact_state(subject, arguments_at<double>(state));
}

/// How many digits, relative to `size`, remain correct in double, with rounding errors up to u E.
int kept_digits(const Running<Real>& value, const cl_R& size) {
  if (value.is_lost || !value.error.is_defined()) return 0;
  const cl_R error = value.error.value() * rounding<double>().roundoff.value();
  int digits = digits_of_double;
  while (digits > 0 && error * power_of_ten(digits) > size) --digits;
  return digits;
}

/// The correct digits of all values in double, by the running errors of the emitted function.
std::vector<int> digits_of(const Subject& subject, const ValueFunction& function,
                           const ValueRecord& record) {
  const Function& emitted =
      *find_function(subject.program, function.output.kind, function.output.user);
  const ExactRun run = exact_run(subject.program, emitted, record.state, rounding<double>());
  std::vector<int> digits;
  for (const ValueField& field : function.fields) {
    const auto first = record.values.begin() + static_cast<std::ptrdiff_t>(digits.size());
    const auto size = static_cast<std::ptrdiff_t>(field.units.size());
    const cl_R largest = largest_of({first, first + size});
    for (auto value = first; value != first + size; ++value) {
      const cl_R of_entry = cln::zerop(*value) ? largest : cln::abs(*value);
      digits.push_back(kept_digits(run.entries[digits.size()], of_entry));
    }
  }
  return digits;
}

/// E633 for each function that the program calls although it has no expression.
Diagnostics refuse_open_functions(const Model& model, const Program& program) {
  std::vector<std::set<std::string>> readers(model.functions.size());
  for (const Function& function : program.functions) {
    for (const Instruction& instruction : function.instructions) {
      if (instruction.opcode != Opcode::open_value) continue;
      readers[model.open_values[instruction.a].function].insert(in_backticks(function.name));
    }
  }
  Diagnostics errors;
  for (std::size_t i = 0; i < readers.size(); ++i) {
    if (readers[i].empty()) continue;
    errors.push_back(
        {Code::E633, model.functions[i].span,
         fmt::format("{} is left open, but vectors of {} need its values",
                     in_backticks(model.functions[i].name), fmt::join(readers[i], ", ")),
         "give it an expression in `[functions]` of a scene, or request other `--outputs`"});
  }
  return errors;
}

}  // namespace

Result<ValueTable> test_vectors(const CheckedModel& checked, const Program& program,
                                const VectorOptions& options) {
  Diagnostics errors = refuse_open_functions(checked.model, program);
  if (!errors.empty()) return errors;
  const Subject subject{checked.model, checked.scene, program};
  const std::vector<VectorState> states = drawn_states(subject, options);
  ValueTable table = table_of(checked, digits_of_double);
  if (!checked.model.constraints.empty()) {
    const auto is_unmet = [](const VectorState& at) { return !at.kept; };
    table.skipped_states = static_cast<std::size_t>(std::ranges::count_if(states, is_unmet));
  }
  for (std::size_t i = 0; i < table.functions.size(); ++i) {
    const std::size_t known = table.records.size();
    for (const VectorState& at : states) {
      const auto state = state_for(subject, table.functions[i].output.kind, at);
      if (!state) continue;
      Result<ValueRecord> record = record_at(table, i, at.place, *state);
      if (!record) continue;
      record->digits = digits_of(subject, table.functions[i], *record);
      table.records.push_back(std::move(*record));
    }
    if (table.records.size() > known) continue;
    errors.push_back(
        {Code::E521, table.functions[i].output.span,
         fmt::format("{} has no value at {}", in_backticks(table.functions[i].output.name),
                     count_text(states.size(), "state that was drawn"))});
  }
  if (!errors.empty()) return errors;
  return table;
}

}  // namespace elgen
