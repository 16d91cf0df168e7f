// The equations of rest are copied into one graph with v = 0 and given u. Blocks are connected
// components of the relation "row i contains coordinate k".
#include "analyse/rest.hpp"

#include <cln/rational.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <string>

#include "analyse/formulas.hpp"
#include "elgen/closed_forms.hpp"
#include "elgen/fold.hpp"
#include "elgen/oracle.hpp"
#include "elgen/references.hpp"
#include "program/evaluate/subject.hpp"
#include "program/network/cheapest.hpp"
#include "program/network/linearise.hpp"

namespace elgen {
namespace {

using cln::cl_RA;

/// Thrown by divisions by 0 at rest.
struct NoValueAtRest {};

struct RestRules : GraphRules {
  const std::vector<cln::cl_R>& inputs;

  RestRules(Graph& to, const std::vector<cln::cl_R>& given) : GraphRules{to}, inputs(given) {}

  [[nodiscard]] SignedNode leaf(Opcode kind, std::uint32_t number) const {
    if (kind == Opcode::velocity) return graph.rational(0);
    if (kind == Opcode::input) return graph.rational(cln::rational(inputs[number]));
    return graph.leaf(kind, number);
  }
  [[nodiscard]] SignedNode divide(SignedNode x, SignedNode y) const {
    if (graph.is_zero(y.node)) throw NoValueAtRest();
    return GraphRules::divide(x, y);
  }
};

std::vector<SignedNode> entries_at_rest(const RestRules& rules, const Program& program,
                                        OutputKind kind) {
  const Function& function = *find_function(program, kind);
  return entries_of(function, fold<SignedNode>(rules, program, function));
}

/// Appends a function with the entries `expressions`, shaped like the function `kind` in `shapes`.
void append_function(Program& program, const Program& shapes, OutputKind kind,
                     const Expressions& expressions) {
  Function function = without_instructions(*find_function(shapes, kind));
  linearise(cheapest_network(expressions, function), program, function);
  program.functions.push_back(std::move(function));
}

/// bias - B u at v = 0, with all entries in one graph.
Expressions residual_of(const Program& moving, const std::vector<cln::cl_R>& inputs) {
  Expressions residual;
  const RestRules rules(residual.graph, inputs);
  residual.values = entries_at_rest(rules, moving, OutputKind::bias);
  if (inputs.empty()) return residual;
  const std::vector<SignedNode> matrix = entries_at_rest(rules, moving, OutputKind::input_matrix);
  for (std::size_t i = 0; i < residual.values.size(); ++i) {
    std::vector<SignedNode> terms{residual.values[i]};
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      const SignedNode u = residual.graph.rational(cln::rational(inputs[k]));
      terms.push_back(-residual.graph.product({{matrix[i * inputs.size() + k], 1}, {u, 1}}));
    }
    residual.values[i] = residual.graph.sum(terms);
  }
  return residual;
}

/// A value as a sum of two parts: rational multiples of coordinates, and all other terms. `all` has
/// the coordinates of both parts. `number` is the value if the value is a rational constant.
struct LinearOccurrence {
  std::map<std::uint32_t, cl_RA> multiples = {};
  std::optional<cl_RA> number = {};
  CoordinateOccurrence all = {};
};

void merge_occurrence(CoordinateOccurrence& to, const CoordinateOccurrence& from) {
  to.coordinates.insert(from.coordinates.begin(), from.coordinates.end());
  to.outside_sinusoids.insert(from.outside_sinusoids.begin(), from.outside_sinusoids.end());
  to.has_time = to.has_time || from.has_time;
}

/// The result of a nonlinear function of x: the coordinates in x.multiples are outside sinusoids.
LinearOccurrence nonlinear_result(const LinearOccurrence& x) {
  LinearOccurrence result;
  result.all = x.all;
  for (const auto& [coordinate, multiple] : x.multiples) {
    result.all.outside_sinusoids.insert(coordinate);
  }
  return result;
}

LinearOccurrence nonlinear_result(const LinearOccurrence& x, const LinearOccurrence& y) {
  LinearOccurrence result = nonlinear_result(x);
  merge_occurrence(result.all, nonlinear_result(y).all);
  return result;
}

LinearOccurrence scale(LinearOccurrence x, const cl_RA& factor) {
  if (factor == 0) return {{}, cl_RA(0), {}};
  for (auto& [coordinate, multiple] : x.multiples) multiple = multiple * factor;
  if (x.number) x.number = *x.number * factor;
  return x;
}

/// Rules for fold() that collect the coordinates on which a value depends.
struct OccurrenceRules {
  [[nodiscard]] LinearOccurrence constant(const Constant& constant) const {
    LinearOccurrence result;
    if (is_rational(constant)) result.number = cln::rational(constant.value);
    return result;
  }
  [[nodiscard]] LinearOccurrence leaf(Opcode kind, std::uint32_t number) const {
    LinearOccurrence result;
    if (kind == Opcode::coordinate) {
      result.multiples[number] = 1;
      result.all.coordinates.insert(number);
    }
    result.all.has_time = kind == Opcode::time;
    return result;
  }
  [[nodiscard]] LinearOccurrence negate(const LinearOccurrence& x) const { return scale(x, -1); }
  [[nodiscard]] LinearOccurrence add(const LinearOccurrence& x, const LinearOccurrence& y) const {
    LinearOccurrence result = x;
    for (const auto& [coordinate, multiple] : y.multiples) {
      cl_RA& sum = result.multiples.try_emplace(coordinate, 0).first->second;
      sum = sum + multiple;
      if (sum == 0) result.multiples.erase(coordinate);
    }
    if (result.number && y.number) result.number = *result.number + *y.number;
    if (!y.number) result.number.reset();
    merge_occurrence(result.all, y.all);
    return result;
  }
  [[nodiscard]] LinearOccurrence subtract(const LinearOccurrence& x,
                                          const LinearOccurrence& y) const {
    return add(x, negate(y));
  }
  [[nodiscard]] LinearOccurrence multiply(const LinearOccurrence& x,
                                          const LinearOccurrence& y) const {
    if (x.number) return scale(y, *x.number);
    if (y.number) return scale(x, *y.number);
    return nonlinear_result(x, y);
  }
  [[nodiscard]] LinearOccurrence divide(const LinearOccurrence& x,
                                        const LinearOccurrence& y) const {
    if (y.number && *y.number != 0) return scale(x, 1 / *y.number);
    return nonlinear_result(x, y);
  }
  [[nodiscard]] LinearOccurrence square_root(const LinearOccurrence& x) const {
    return nonlinear_result(x);
  }
  [[nodiscard]] LinearOccurrence call(FunctionId function, const LinearOccurrence& x,
                                      const LinearOccurrence& y) const {
    const bool is_trigonometric = is_circular(function) || function == FunctionId::tan;
    if (!is_trigonometric)
      return function_row(function).arity == 2 ? nonlinear_result(x, y) : nonlinear_result(x);
    LinearOccurrence result;
    result.all = x.all;
    for (const auto& [coordinate, multiple] : x.multiples) {
      if (cln::denominator(multiple) != 1) result.all.outside_sinusoids.insert(coordinate);
    }
    return result;
  }
};

}  // namespace

Result<RestProgram> rest_program(const Program& motion_program,
                                 const std::vector<cln::cl_R>& inputs) {
  RestProgram rest;
  rest.program.leaves = motion_program.leaves;
  try {
    append_function(rest.program, motion_program, OutputKind::bias,
                    residual_of(motion_program, inputs));
    for (const OutputKind kind : {OutputKind::mass_matrix, OutputKind::energy_function}) {
      Expressions expressions;
      expressions.values = entries_at_rest({expressions.graph, inputs}, motion_program, kind);
      append_function(rest.program, motion_program, kind, expressions);
    }
  } catch (const NoValueAtRest&) {
    return Diagnostic{Code::E530, {}, "the equations of motion have no value at rest"};
  }
  return rest;
}

std::vector<CoordinateOccurrence> coordinate_occurrences(const Program& program,
                                                         const Function& function) {
  std::vector<CoordinateOccurrence> result;
  for (const LinearOccurrence& entry :
       entries_of(function, fold<LinearOccurrence>(OccurrenceRules{}, program, function))) {
    result.push_back(nonlinear_result(entry).all);
  }
  return result;
}

std::vector<RestBlock> rest_blocks(const std::vector<CoordinateOccurrence>& rows) {
  std::vector<RestBlock> blocks;
  for (std::uint32_t row = 0; row < rows.size(); ++row) {
    std::set<std::uint32_t> coordinates = rows[row].coordinates;
    RestBlock joined{{row}, {}};
    std::erase_if(blocks, [&](const RestBlock& block) {
      const bool is_joined = std::ranges::any_of(block.coordinates, [&](std::uint32_t coordinate) {
        return rows[row].coordinates.contains(coordinate);
      });
      if (!is_joined) return false;
      joined.rows.insert(joined.rows.end(), block.rows.begin(), block.rows.end());
      coordinates.insert(block.coordinates.begin(), block.coordinates.end());
      return true;
    });
    std::ranges::sort(joined.rows);
    joined.coordinates.assign(coordinates.begin(), coordinates.end());
    blocks.push_back(std::move(joined));
  }
  std::ranges::sort(blocks, {}, [](const RestBlock& block) { return block.rows.front(); });
  return blocks;
}

Result<std::vector<cln::cl_R>> rest_inputs(const CheckedModel& checked, const State& state) {
  const Model& model = checked.model;
  std::vector<cln::cl_R> values;
  for (const Input& input : model.inputs) {
    const ExpressionId* const law = find_law(checked.scene, input);
    if (law == nullptr) {
      values.emplace_back(0);
      continue;
    }
    const auto moves = [&](ExpressionId id) {
      const Expression& e = model.expressions[id];
      return e.kind == ExpressionKind::leaf && e.leaf != Opcode::parameter;
    };
    const auto value = oracle_expression_value(model, *law, state);
    if (!value || std::ranges::any_of(reachable_expressions(model, {*law}), moves)) {
      return Diagnostic{Code::E606, model.expressions[*law].span,
                        fmt::format("`{}` has to be a number at an equilibrium", input.name)};
    }
    values.push_back(*value);
  }
  return values;
}

std::string time_removal_hint(const Model& model, const RestProgram& rest) {
  ClosedForms forms = present(rest.program);
  const std::vector<OptionalFraction>& entries = forms.functions[0].fields[0].entries;
  std::string options;
  for (std::uint32_t i = 0; i < model.parameters.size(); ++i) {
    Replacements zero;
    zero[{Opcode::parameter, i}].value = Fraction{};
    bool contains_terms = false;
    const bool is_timeless = std::ranges::all_of(entries, [&](const OptionalFraction& entry) {
      const OptionalFraction left = substitute(forms.algebra, entry, zero);
      LeafSearch times(forms.algebra, [](const Atom& leaf) { return leaf.leaf == Opcode::time; });
      contains_terms = contains_terms || (left && !left->numerator.empty());
      return left && !times.contains(*left);
    });
    if (!is_timeless || !contains_terms) continue;
    options +=
        fmt::format("{}`--fix {}=0`", options.empty() ? "" : " or ", model.parameters[i].name);
  }
  return options.empty() ? "" : options + " removes t";
}

}  // namespace elgen
