// code_interface: derives the interface from the output table and the instructions of functions.
#include "emit/interface/code_interface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>
#include <unordered_map>
#include <utility>

#include "base/ascii.hpp"
#include "elgen/inertial_parameters.hpp"
#include "elgen/spellings.hpp"
#include "model/output_units.hpp"
#include "program/evaluate/sine_calls.hpp"

namespace elgen {
namespace {

Field transpose_field(const Field& field) {
  Field result{field.name, field.columns, field.rows, {}};
  for (std::uint32_t column = 0; column < field.columns; ++column) {
    for (std::uint32_t row = 0; row < field.rows; ++row) {
      result.entries.push_back(field.entries[row * field.columns + column]);
    }
  }
  return result;
}

template <class Element, class Text>
DeclaredArray text_array(const char* name, const std::vector<Element>& elements, const Text& text) {
  DeclaredArray array{name, DeclaredArray::Kind::texts};
  for (const Element& element : elements) array.texts.push_back(std::invoke(text, element));
  return array;
}

template <class Element, class Number>
DeclaredArray number_array(const char* name, const std::vector<Element>& elements,
                           const Number& number) {
  DeclaredArray array{name, DeclaredArray::Kind::numbers};
  for (const Element& element : elements) array.numbers.push_back(std::invoke(number, element));
  return array;
}

template <class Element, class Range>
DeclaredArray interval_array(const char* name, const std::vector<Element>& elements,
                             const Range& range) {
  DeclaredArray array{name, DeclaredArray::Kind::intervals};
  for (const Element& element : elements) array.intervals.push_back(std::invoke(range, element));
  return array;
}

template <class Predicate>
bool has_instruction(const Program& program, const Predicate& is_wanted) {
  return std::any_of(program.functions.begin(), program.functions.end(), [&](const Function& f) {
    return std::any_of(f.instructions.begin(), f.instructions.end(), is_wanted);
  });
}

}  // namespace

const std::string& name_space(const Scene& scene) {
  const std::string& name = scene.emission.name_space;
  return name.empty() ? scene.base_name : name;
}

std::string upper_case(std::string_view name) {
  std::string text(name);
  std::transform(text.begin(), text.end(), text.begin(), to_upper_case);
  return text;
}

std::string camel_case(std::string_view name) {
  std::string result;
  bool starts_word = true;
  for (const char c : name) {
    if (c != '_') result += starts_word ? to_upper_case(c) : c;
    starts_word = c == '_';
  }
  return result;
}

std::vector<ParameterArray> emitted_parameters(const Model& model, const Program& program) {
  std::set<std::string> names;
  for (const Function& function : program.functions) {
    for (const Instruction& instruction : function.instructions) {
      const bool is_parameter = instruction.opcode == Opcode::parameter;
      if (is_parameter) names.insert(program.leaves.parameters[instruction.a]);
    }
  }
  std::vector<bool> is_read(model.parameter_arrays.size(), false);
  for (const Parameter& parameter : model.parameters) {
    if (names.count(parameter.name) > 0) is_read[parameter.array] = true;
  }
  std::vector<ParameterArray> result;
  for (std::size_t i = 0; i < is_read.size(); ++i) {
    if (is_read[i]) result.push_back(model.parameter_arrays[i]);
  }
  return result;
}

std::string name_in_language(LanguageId language, std::string_view name) {
  const bool is_word =
      language_row(language).is_interpreted && has_word(source_spelling(language).reserved, name);
  return std::string(name) + (is_word ? "_" : "");
}

/// The member for each parameter leaf. A leaf has the same name as its parameter.
std::vector<ParameterMember> parameter_leaf_members(const Model& model, const LeafNames& leaves) {
  std::unordered_map<std::string_view, const Parameter*> known;
  for (const Parameter& parameter : model.parameters) known.emplace(parameter.name, &parameter);
  std::vector<ParameterMember> members;
  for (const std::string& leaf : leaves.parameters) {
    const auto found = known.find(leaf);
    ParameterMember member{leaf, {}};
    if (found != known.end()) {
      const Parameter& parameter = *found->second;
      const ParameterArray& array = model.parameter_arrays[parameter.array];
      member.name = array.name;
      if (array.is_array) member.element = parameter.element;
    }
    members.push_back(std::move(member));
  }
  return members;
}

std::vector<std::string> parameter_member_texts(const Model& model, const LeafNames& leaves) {
  std::vector<std::string> texts;
  for (const auto& [name, element] : parameter_leaf_members(model, leaves)) {
    texts.push_back(element ? fmt::format("{}[{}]", name, *element) : name);
  }
  return texts;
}

std::vector<Opcode> arguments_of(const Model& model, const Function& function) {
  const OutputRow& row = output_row(function.kind);
  if (row.takes_parameters_alone) return {Opcode::parameter};
  LeafSet leaves = Opcode::parameter | Opcode::coordinate | row.argument_kinds;
  if (row.is_user_output) leaves |= model.outputs[function.user].argument_kinds;
  if (row.depends_like_mass && !model.is_quadratic) leaves |= Opcode::velocity;
  if (model.uses_time) leaves |= Opcode::time;
  if (!model.open_values.empty()) leaves |= Opcode::open_value;
  std::vector<Opcode> list;
  for (const LeafRow& leaf : leaf_table()) {
    if (leaves.has_any(leaf.id)) list.push_back(leaf.id);
  }
  return list;
}

std::vector<Opcode> arguments_of(const Model& model, const Function& function,
                                 const Program& program, LanguageId language) {
  std::vector<Opcode> list = arguments_of(model, function);
  const bool has_type = language_row(language).scalars == LanguageScalars::any;
  if (!has_type && emitted_parameter_count(model, program) == 0) {
    std::erase(list, Opcode::parameter);
  }
  return list;
}

std::size_t emitted_parameter_count(const Model& model, const Program& program) {
  std::size_t count = 0;
  for (const ParameterArray& array : emitted_parameters(model, program)) count += array.count;
  return count;
}

std::vector<cln::cl_R> element_values(const Model& model, const ParameterArray& array) {
  std::vector<cln::cl_R> values;
  for (std::uint32_t i = 0; i < array.count; ++i) {
    values.push_back(model.parameters[array.first + i].value);
  }
  return values;
}

std::vector<DeclaredArray> declared_arrays(const Model& model, const Program& program) {
  std::vector<DeclaredArray> list{
      text_array("coordinate_names", model.coordinates, &Coordinate::name),
      text_array("coordinate_units", model.coordinates, &Coordinate::unit_text),
      interval_array("coordinate_ranges", model.coordinates, &Coordinate::range),
      number_array("start_coordinates", model.coordinates, &Coordinate::start_value)};
  if (!model.rotations.empty()) {
    list.push_back(text_array("velocity_names", model.velocities, &Velocity::name));
    list.push_back(text_array("velocity_units", model.velocities, [&](const Velocity& velocity) {
      return velocity_unit_text(model, velocity);
    }));
  }
  list.push_back(interval_array("rate_ranges", model.velocities, &Velocity::rate_range));
  list.push_back(number_array("start_rates", model.velocities, &Velocity::start_rate));
  list.push_back(text_array("input_names", model.inputs, &Input::name));
  list.push_back(text_array("input_units", model.inputs, &Input::unit_text));
  list.push_back(interval_array("input_limits", model.inputs, &Input::limits));
  if (!model.constraints.empty()) {
    list.push_back(text_array("constraint_names", model.constraints, &Constraint::name));
  }
  const auto has_parameters = [](const Function& function) {
    return output_row(function.kind).needs.has(Need::inertial);
  };
  if (std::ranges::any_of(program.functions, has_parameters)) {
    list.push_back(
        text_array("regressor_names", inertial_parameters(model), &InertialParameter::name));
  }
  if (model.open_values.empty()) return list;
  list.push_back(text_array("open_value_names", model.open_values, &OpenValue::name));
  list.push_back(text_array("open_value_units", model.open_values, &OpenValue::unit_text));
  return list;
}

bool needs_ordered_scalar(const Function& function) {
  return std::any_of(
      function.instructions.begin(), function.instructions.end(), [](const Instruction& i) {
        return i.opcode == Opcode::call && !function_row(i.function).own_name.empty();
      });
}

bool compares_numbers(const Program& program) {
  return std::ranges::any_of(program.functions, needs_ordered_scalar);
}

bool calls_sines(const Program& program) {
  return calls_function(program, FunctionId::sin) || calls_function(program, FunctionId::cos);
}

bool has_batch_sine_tables(const Scene& scene, const Program& program) {
  return scene.numerics.trigonometry_error || !calls_sines(program);
}

std::vector<std::string_view> library_calls(const Program& program, std::size_t arity) {
  std::vector<std::string_view> names;
  for (const FunctionRow& row : function_table()) {
    const bool is_own = is_circular(row.id) || !row.own_name.empty() || row.arity != arity;
    if (!is_own && calls_function(program, row.id)) names.push_back(row.name);
  }
  const auto is_root = [](const Instruction& i) { return i.opcode == Opcode::square_root; };
  if (arity == 1 && has_instruction(program, is_root)) names.emplace_back("sqrt");
  return names;
}

bool has_sine_cosine_pair(const Program& program) {
  return std::any_of(program.functions.begin(), program.functions.end(), [](const Function& f) {
    std::size_t at = 0;
    while (at < f.instructions.size() && !starts_sine_cosine_pair(f, at)) ++at;
    return at < f.instructions.size();
  });
}

bool returns_pivots(const Program& program) {
  return std::any_of(program.functions.begin(), program.functions.end(),
                     [](const Function& f) { return has_pivots(f); });
}

bool returns_struct(const Function& function) {
  return function.fields.size() != 1 || !function.fields.front().name.empty();
}

OutputKind kind_of_field(const Program& program, const Function& function, const Field& field) {
  if (!output_row(function.kind).is_summary) return function.kind;
  for (const Function& candidate : program.functions) {
    if (candidate.name == field.name) return candidate.kind;
  }
  const OutputRow* row = find_output(field.name);
  return row != nullptr ? row->kind : function.kind;
}

bool is_scalar(OutputKind kind, const Field& field) {
  return may_be_scalar(field_row(kind, field.name)) && field.rows == 1 && field.columns == 1;
}

bool is_scalar(const Program& program, const Function& function, const Field& field) {
  return is_scalar(kind_of_field(program, function, field), field);
}

bool is_matrix(OutputKind kind, const Field& field) {
  return is_matrix_field(field_row(kind, field.name));
}

std::string_view pivot_count_text(const Model& model) {
  return model.constraints.empty() ? "velocity_count" : "velocity_count + constraint_count";
}

std::string field_type(const Model& model, OutputKind kind, const Field& field) {
  if (is_scalar(kind, field)) return "Scalar";
  const auto type = fmt::runtime(field_row(kind, field.name).type);
  return fmt::format(type, field.rows, field.rows * field.columns, pivot_count_text(model));
}

std::string eigen_type(OutputKind kind, const Field& field) {
  if (is_scalar(kind, field)) return "Scalar";
  if (field.columns == 1) return fmt::format("Vector<Scalar, {}>", field.rows);
  return fmt::format("Matrix<Scalar, {}, {}>", field.rows, field.columns);
}

Function to_storage_order(const Function& function, Storage storage) {
  Function result = function;
  if (storage == Storage::row_major) return result;
  for (Field& field : result.fields) {
    if (field.rows > 1 && field.columns > 1) field = transpose_field(field);
  }
  return result;
}

bool is_returned_by_value(const Function& function) {
  return entry_count(function) <= max_returned_entries;
}

}  // namespace elgen
