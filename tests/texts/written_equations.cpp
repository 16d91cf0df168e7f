// WrittenEquations: the parser of models reads the text. Names in the text are leaves, rates of
// leaves, or definitions read before.
#include "texts/written_equations.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "elgen/oracle.hpp"
#include "elgen/wording.hpp"
#include "numbers/exact_number.hpp"
#include "sample/states.hpp"
#include "texts/real_rules.hpp"

namespace elgen::test {
namespace {

constexpr std::size_t state_count = 2;
/// The computation has 64 digits. Cancellation in sums of many terms may lose some of these digits.
constexpr long agreeing_digits = 40;

std::unordered_map<std::string, Real> leaves_at(const LeafNames& names,
                                                const Arguments<Real>& state) {
  std::unordered_map<std::string, Real> leaves;
  const auto add = [&](Opcode kind, std::uint32_t number, const Real& value) {
    const bool is_written = may_be_argument(names, kind) || kind == Opcode::multiplier;
    if (is_written) leaves.emplace(leaf_text(names, kind, number), value);
  };
  for_each_leaf(add, state);
  leaves.emplace("pi", Real(cln::pi(Real::format())));
  return leaves;
}

/// The value in 12 digits for messages, or "undefined".
std::string short_value(const Real& value) {
  constexpr int digits = 12;
  if (!value.is_defined()) return "undefined";
  return literal_text(rounded_decimal(value.value(), digits));
}

/// States with parameters at their values, random multipliers, and all else random in its range.
std::vector<Arguments<Real>> comparison_states(const Model& model) {
  std::vector<Arguments<Real>> states;
  Sampler draw(1);
  while (states.size() < state_count) {
    State state = nominal_state(model, {});
    draw_motion(model, draw, 0, state);
    for (cln::cl_R& multiplier : state.multipliers) multiplier = draw.number();
    states.push_back(map_leaves([](const cln::cl_R& value) { return Real(value); }, state));
  }
  return states;
}

Real largest_of(const std::vector<Real>& values) {
  Real largest;
  for (const Real& value : values) {
    if (value.is_defined()) largest = max(largest, abs(value));
  }
  return largest;
}

}  // namespace

WrittenEquations::WrittenEquations(const Origin& origin)
    : origin_(origin),
      states_(comparison_states(origin.model)),
      known_(origin.program.functions.size()) {
  for (const Arguments<Real>& state : states_) {
    leaves_.push_back(leaves_at(origin.program.leaves, state));
  }
  clear_parts();
}

void WrittenEquations::clear_parts() {
  parts_ = std::vector<std::unordered_map<std::string, Real>>(states_.size());
  for (Known& known : known_) known.texts.clear();
}

std::string WrittenEquations::part(const std::string& name, const std::string& text) {
  const Evaluated& written = evaluated(text);
  if (!written.problem.empty()) return written.problem;
  if (!written.used.empty()) return quote_text(*written.used.begin()) + " is not defined here";
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const bool is_new = parts_[i].emplace(name, written.values[i]).second;
    if (!is_new) return quote_text(name) + " is defined twice";
  }
  return {};
}

void WrittenEquations::start(std::size_t index) {
  index_ = index;
  defined_.clear();
  Known& known = known_[index];
  if (known.is_evaluated) return;
  known.is_evaluated = true;
  for (const Arguments<Real>& state : states_) {
    known.instructions.push_back(evaluate_instructions(origin_.program, function(), state));
    known.largest.push_back(largest_of(known.instructions.back()));
  }
  const std::vector<std::string> names = temporary_names(origin_.program, function());
  for (std::uint32_t i = 0; i < names.size(); ++i) {
    if (!names[i].empty()) known.named.emplace(names[i], i);
  }
}

std::string WrittenEquations::definition(const std::string& name, const std::string& text) {
  const auto known = known_[index_].named.find(name);
  if (known == known_[index_].named.end()) return quote_text(name) + " is no definition";
  const std::string problem = compare(known->second, text);
  if (!defined_.insert(name).second) return quote_text(name) + " is defined twice";
  return problem;
}

std::string WrittenEquations::entry(std::uint32_t instruction, const std::string& text) {
  return compare(instruction, text);
}

std::string WrittenEquations::number(const cln::cl_R& value, const std::string& text) {
  const Result<ExpressionSyntax> syntax = parse_expression(make_source("", text), Limits{});
  if (!syntax) return syntax.diagnostics.front().message;
  Evaluated result;
  const Real written = this->value(*syntax, result);
  const Real difference = abs(written - Real(value));
  const Real tolerance = abs(Real(value)) * Real(power_of_ten(-agreeing_digits));
  const bool is_right = written.is_defined() && difference.value() <= tolerance.value();
  return is_right ? "" : fmt::format("{} is not {}", quote_text(text), exact_text(value));
}

std::string WrittenEquations::values(const std::vector<Real>& derived,
                                     const std::vector<Real>& largest, const std::string& text) {
  const Evaluated& written = evaluated(text);
  if (!written.problem.empty()) return written.problem;
  for (const std::string& name : written.used) {
    if (defined_.count(name) == 0) return quote_text(name) + " is not defined here";
  }
  const Real relative(power_of_ten(-agreeing_digits));
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (!derived[i].is_defined()) continue;
    const Real difference = abs(written.values[i] - derived[i]);
    const Real tolerance = largest[i] * relative;
    if (difference.is_defined() && difference.value() <= tolerance.value()) continue;
    return fmt::format("{} is {} where {} was derived", quote_text(text),
                       short_value(written.values[i]), short_value(derived[i]));
  }
  return {};
}

std::string WrittenEquations::compare(std::uint32_t instruction, const std::string& text) {
  const Known& known = known_[index_];
  std::vector<Real> derived;
  for (const std::vector<Real>& at_state : known.instructions) {
    derived.push_back(at_state[instruction]);
  }
  return values(derived, known.largest, text);
}

const WrittenEquations::Evaluated& WrittenEquations::evaluated(const std::string& text) {
  const auto [known, is_new] = known_[index_].texts.emplace(text, Evaluated{});
  Evaluated& result = known->second;
  if (!is_new) return result;
  const Result<ExpressionSyntax> syntax = parse_expression(make_source("", text), written_limits());
  if (!syntax) {
    result.problem = syntax.diagnostics.front().message;
    return result;
  }
  for (state_ = 0; state_ < states_.size(); ++state_) {
    result.values.push_back(value(*syntax, result));
  }
  state_ = 0;
  return result;
}

/// Computes values at the current state.
struct WrittenEquations::Rules : RealRules {
  const WrittenEquations& reader;
  Evaluated& result;

  Real named(const std::string& name) const { return reader.named(name, result); }
  Real fail(std::string problem) const {
    result.problem = std::move(problem);
    return Real::undefined();
  }
};

Real WrittenEquations::value(const ExpressionSyntax& e, Evaluated& result) const {
  return fold_expression(e, Rules{{}, *this, result});
}

Real WrittenEquations::named(const std::string& name, Evaluated& result) const {
  const auto leaf = leaves_[state_].find(name);
  if (leaf != leaves_[state_].end()) return leaf->second;
  const auto part = parts_[state_].find(name);
  if (part != parts_[state_].end()) return part->second;
  const Known& known = known_[index_];
  const auto definition = known.named.find(name);
  if (definition == known.named.end()) {
    result.problem = quote_text(name) + " is no name of the model";
    return Real::undefined();
  }
  result.used.insert(name);
  return known.instructions[state_][definition->second];
}

}  // namespace elgen::test
