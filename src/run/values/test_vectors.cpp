// Test vectors: draws states of several kinds in turn; finds the values of the emitted functions,
// and how many digits of each value a double keeps.
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
#include "verify/bounds/confirmed_values.hpp"
#include "verify/bounds/exact_run.hpp"

namespace elgen {
namespace {

using cln::cl_R;

constexpr int digits_of_double = 17;

struct TestVectorState {
  const char* label = "";
  State drawn = {};
  std::optional<State> projected_state = {};  ///< on the constraints; none: Newton's method fails
};

State start_with_momenta(const SystemUnderTest& subject) {
  State state = start_state(subject.model, subject.scene);
  state.momenta = with_leaves(subject.model, state, {}).momenta;
  state.h = cln::cl_RA(1) / 100;
  return state;
}

/// The state with the index `number`; 0 is the start. Every third state has other parameters: half
/// to twice the model's values, or anywhere in their ranges.
TestVectorState draw_vector_state(const SystemUnderTest& subject, std::size_t number,
                                  Sampler& draw) {
  if (number == 0) return {"start", start_with_momenta(subject)};
  const bool varies = number % 3 == 0;
  const std::size_t turn = varies ? 3 * (1 + number / 3) : 0;  // a multiple of 3: rates up to 1
  State state = draw_state(subject.model, subject.scene, draw, turn);
  state.h = cln::abs(draw.number()) / 10;
  if (varies) return {"parameters", std::move(state)};
  if (number % 3 == 2) return {"moving", std::move(state)};
  for (auto* const list : {&state.v, &state.momenta, &state.a, &state.u}) {
    list->assign(list->size(), cl_R(0));
  }
  return {"rest", std::move(state)};
}

/// Draws the states. Their numbers are exact doubles.
std::vector<TestVectorState> draw_vector_states(const SystemUnderTest& subject,
                                                const TestVectorOptions& options) {
  Sampler draw(options.seed);
  std::vector<TestVectorState> states;
  for (std::size_t i = 0; i < options.samples; ++i) {
    TestVectorState& next = states.emplace_back(draw_vector_state(subject, i, draw));
    next.drawn = exact_state(subject, arguments_at<double>(next.drawn));
    next.projected_state = move_onto_constraints(subject.model, next.drawn);
  }
  return states;
}

/// The state at which an output is evaluated, on the constraints if this output is compared there;
/// none if the projection failed.
std::optional<State> evaluation_state(const SystemUnderTest& subject, OutputKind output,
                                      const TestVectorState& at) {
  if (!is_compared_on_constraints(subject.model, output)) return at.drawn;
  if (!at.projected_state) return std::nullopt;
  const State state = compared_state(subject.model, output, at.drawn, *at.projected_state);
  return exact_state(subject, arguments_at<double>(state));
}

/// The correct digits of `value` in double, relative to `size`, for the error u value.error.
int correct_digits(const RunningValue<Real>& value, const cl_R& size) {
  if (value.is_lost || !value.error.is_defined()) return 0;
  const cl_R error = value.error.value() * rounding_constants<double>().roundoff.value();
  int digits = digits_of_double;
  while (digits > 0 && error * power_of_ten(digits) > size) --digits;
  return digits;
}

/// The correct digits of all values in double, by the running errors of the emitted function.
std::vector<int> record_digits(const ValueFunction& function, const ValueRecord& record,
                               const ExactRun& run) {
  std::vector<int> digits;
  for (const ValueField& field : function.fields) {
    const auto first = record.values.begin() + static_cast<std::ptrdiff_t>(digits.size());
    const auto size = static_cast<std::ptrdiff_t>(field.units.size());
    const cl_R largest = max_magnitude({first, first + size});
    for (auto value = first; value != first + size; ++value) {
      const cl_R of_entry = cln::zerop(*value) ? largest : cln::abs(*value);
      digits.push_back(correct_digits(run.entries[digits.size()], of_entry));
    }
  }
  return digits;
}

/// The values of table.functions[index] at the state, and their digits in double. Errors of
/// make_value_record().
Result<ValueRecord> make_vector(const SystemUnderTest& subject, const ValueTable& table,
                                std::size_t index, std::string place, const State& state) {
  const ValueFunction& function = table.functions[index];
  const Function* const emitted =
      find_function(subject.program, function.output.kind, function.output.user);
  const ExactRun run = run_exactly(subject.program, *emitted, state, rounding_constants<double>());
  const auto number = static_cast<std::size_t>(emitted - subject.program.functions.data());
  auto confirmed = confirmed_values(subject, number, state, run);
  Result<ValueRecord> record =
      confirmed ? ValueRecord{index, std::move(place), state, std::move(*confirmed)}
                : make_value_record(table, index, std::move(place), state);
  if (record) record->digits = record_digits(function, *record, run);
  return record;
}

/// E633 for each function that the program calls although it has no expression.
Diagnostics check_open_functions(const Model& model, const Program& program) {
  std::vector<std::set<std::string>> readers(model.functions.size());
  for (const Function& function : program.functions) {
    for (const Instruction& instruction : function.instructions) {
      if (instruction.opcode != Opcode::open_value) continue;
      readers[model.open_values[instruction.a].function].insert(quote_text(function.name));
    }
  }
  Diagnostics errors;
  for (std::size_t i = 0; i < readers.size(); ++i) {
    if (readers[i].empty()) continue;
    errors.push_back(
        {Code::E633, model.functions[i].span,
         fmt::format("{} is left open, but vectors of {} need its values",
                     quote_text(model.functions[i].name), fmt::join(readers[i], ", ")),
         "give it an expression in `[functions]` of a scene, or request other `--outputs`"});
  }
  return errors;
}

}  // namespace

Result<ValueTable> test_vectors(const CheckedModel& checked, const Program& program,
                                const TestVectorOptions& options) {
  Diagnostics errors = check_open_functions(checked.model, program);
  if (!errors.empty()) return errors;
  const SystemUnderTest subject{checked.model, checked.scene, program};
  const std::vector<TestVectorState> states = draw_vector_states(subject, options);
  ValueTable table = make_value_table(checked, digits_of_double);
  if (!checked.model.constraints.empty()) {
    const auto is_unmet = [](const TestVectorState& at) { return !at.projected_state; };
    table.skipped_states = static_cast<std::size_t>(std::ranges::count_if(states, is_unmet));
  }
  for (std::size_t i = 0; i < table.functions.size(); ++i) {
    const std::size_t known = table.records.size();
    const OutputRequest& output = table.functions[i].output;
    for (std::size_t k = 0; k < states.size(); ++k) {
      if (options.on_step) {
        options.on_step(fmt::format("{}, state {} of {}", output.name, k + 1, states.size()));
      }
      const auto state = evaluation_state(subject, output.kind, states[k]);
      if (!state) continue;
      Result<ValueRecord> record = make_vector(subject, table, i, states[k].label, *state);
      if (record) table.records.push_back(std::move(*record));
    }
    if (table.records.size() > known) continue;
    errors.push_back({Code::E521, output.span,
                      fmt::format("{} has no value at {}", quote_text(output.name),
                                  count_text(states.size(), "state that was drawn"))});
  }
  if (!errors.empty()) return errors;
  return table;
}

}  // namespace elgen
