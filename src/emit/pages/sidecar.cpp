// sidecar: writes an object or list on one line if it fits, else one element per line, so that a
// change of one term changes one line of a diff.

#include "base/json.hpp"
#include "base/utf8.hpp"
#include "emit/interface/code_interface.hpp"
#include "emit/text/emission_input.hpp"
#include "emit/text/layout.hpp"
#include "model/output_units.hpp"
#include "model/requests.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

/// "\"key\": " before a value of an object; "" before a value of a list.
std::string key_prefix(const Json& list, std::string_view key) {
  return list.is_object() ? Json(key).dump() + ": " : "";
}

std::string single_line_json(const Json& json) {
  if (!json.is_structured()) return json.dump();
  std::string text;
  for (const auto& [key, value] : json.items()) {
    text += (text.empty() ? "" : ", ") + key_prefix(json, key) + single_line_json(*value);
  }
  return json.is_object() ? "{" + text + "}" : "[" + text + "]";
}

std::string json_text(const Json& json, std::size_t column, std::size_t indent) {
  const std::string line = single_line_json(json);
  const bool is_nested = indent == 0;
  if (!json.is_structured() || (!is_nested && column + line.size() < line_width)) return line;
  const std::string margin(indent + 2, ' ');
  std::string text;
  for (const auto& [key, value] : json.items()) {
    text += text.empty() ? "\n" : ",\n";
    const std::string start = margin + key_prefix(json, key);
    text += start + json_text(*value, start.size(), indent + 2);
  }
  const char* const brackets = json.is_object() ? "{}" : "[]";
  return brackets[0] + text + "\n" + std::string(indent, ' ') + brackets[1];
}

/// The JSON list of json_of(element) for each of `elements`.
template <class Elements, class F>
Json json_list(const Elements& elements, const F& json_of) {
  Json list = Json::array();
  for (const auto& element : elements) list.push_back(json_of(element));
  return list;
}

/// {"name": …, "unit": …}, without the key "unit" if `unit` is empty.
Json named_json(const std::string& name, const std::string& unit) {
  Json json = {{"name", name}};
  if (!unit.empty()) json["unit"] = unit;
  return json;
}

/// Adds {"spelt": {"python": "lambda_"}} for the languages that spell `name` differently.
void add_spellings(Json& json, const std::string& name) {
  for (const LanguageRow& language : language_table) {
    const std::string spelling = name_in_language(language.id, name);
    if (spelling != name) json["spelt"][std::string(language.name)] = spelling;
  }
}

void add_interval(Json& json, const char* key, const std::optional<Interval>& interval) {
  if (interval) json[key] = {exact_text(interval->low), exact_text(interval->high)};
}

/// Adds "rate_range", if `velocity` has a range, and "start_rate".
void add_rate(Json& json, const Velocity& velocity) {
  add_interval(json, "rate_range", velocity.rate_range);
  json["start_rate"] = exact_text(velocity.start_rate);
}

/// The coordinates; in models without rotations also the ranges and start values of rates.
Json coordinates_json(const Model& model) {
  return json_list(model.coordinates, [&](const Coordinate& coordinate) {
    Json json = named_json(coordinate.name, coordinate.unit_text);
    add_interval(json, "range", coordinate.range);
    json["start"] = exact_text(coordinate.start_value);
    if (coordinate.wraps) json["wrap"] = true;
    if (model.rotations.empty()) add_rate(json, model.velocities[coordinate.velocity]);
    return json;
  });
}

Json velocities_json(const Model& model) {
  return json_list(model.velocities, [&](const Velocity& velocity) {
    Json json = named_json(velocity.name, velocity_unit_text(model, velocity));
    add_rate(json, velocity);
    return json;
  });
}

Json inputs_json(const Model& model) {
  return json_list(model.inputs, [](const Input& input) {
    Json json = named_json(input.name, input.unit_text);
    add_interval(json, "limits", input.limits);
    return json;
  });
}

/// Constraints `value` = 0 on positions or velocities.
Json constraints_json(const Model& model) {
  return json_list(model.constraints, [&](const Constraint& constraint) {
    Json json = named_json(constraint.name, constraint.unit ? to_string(*constraint.unit) : "");
    json["kind"] = constraint.is_position ? "position" : "velocity";
    json["value"] = to_string(model, constraint.value);
    return json;
  });
}

/// Open functions; their arguments are expressions of the model language.
Json open_functions_json(const Model& model) {
  const auto text = [&model](ExpressionId argument) { return to_string(model, argument); };
  return json_list(model.functions, [&](const OpenFunction& function) {
    Json json = named_json(function.name, function.unit_text);
    json["of"] = json_list(function.arguments, text);
    return json;
  });
}

/// Values and derivatives of open functions. `by` counts arguments from 1.
Json open_values_json(const Model& model) {
  const auto count = [](std::uint32_t argument) { return argument + 1; };
  return json_list(model.open_values, [&](const OpenValue& value) {
    Json json = named_json(value.name, value.unit_text);
    json["function"] = model.functions[value.function].name;
    json["by"] = json_list(value.derivative_arguments, count);
    return json;
  });
}

Json parameters_json(const Model& model, const Program& program) {
  return json_list(emitted_parameters(model, program), [&](const ParameterArray& array) {
    const std::vector<cln::cl_R> values = element_values(model, array);
    Json json = named_json(array.name, array.unit_text);
    if (array.is_array) json["size"] = array.count;
    json["value"] =
        array.is_array ? json_list(values, &exact_text) : Json(exact_text(values.front()));
    add_interval(json, "range", array.range);
    const Assumption assumption = model.parameters[array.first].assumption;
    if (assumption != Assumption::none) {
      json["assume"] = assumption == Assumption::positive ? "positive" : "nonnegative";
    }
    add_spellings(json, array.name);
    return json;
  });
}

Json operations_json(const Function& function) {
  const OperationCounts n = count_operations(function);
  Json json = Json::object();
  for (const auto& [name, count] : operation_columns) json[std::string(name)] = n.*count;
  return json;
}

Json definitions_json(const FunctionEquations& equations) {
  return json_list(equations.definitions, [](const NamedFormula& line) {
    return Json{{"name", text_of(line.name)}, {"value", text_of(line.value)}};
  });
}

/// The arguments of the function; their order is the same in all languages.
Json arguments_json(const EmissionInput& input, const Function& function) {
  const LanguageId language = input.scene.emission.language;
  return json_list(arguments_of(input.model, function, input.program, language),
                   [](Opcode argument) { return leaf_row(argument).symbol; });
}

/// {"shape": …, "rows": …, "columns": …, "entries": …}. Names of rows and columns are omitted if
/// another list of the sidecar contains these names; entries, if the output has no equations.
Json field_json(const Model& model, const OutputRow& row, const FunctionEquations& equations,
                const Field& field, std::size_t at) {
  Json json{{"shape", {field.rows, field.columns}}};
  const FieldRow& declared = field_row(row.kind, field.name);
  const auto rows = names_without_leaf(model, declared.rows);
  const auto columns = names_without_leaf(model, declared.columns);
  if (!rows.empty()) json["rows"] = rows;
  if (!columns.empty()) json["columns"] = columns;
  if (has_equations(row)) json["entries"] = texts_of(equations.entries[at]);
  return json;
}

Json output_json(const EmissionInput& input, const Function& function,
                 const FunctionEquations& equations) {
  Json json = Json::object();
  const OutputRow& row = output_row(function.kind);
  if (!row.is_user_output && row.name != function.name) json["output"] = row.name;
  add_spellings(json, function.name);
  json["arguments"] = arguments_json(input, function);
  if (has_equations(row) && !equations.definitions.empty()) {
    json["definitions"] = definitions_json(equations);
  }
  if (returns_struct(function)) {
    for (std::size_t i = 0; i < function.fields.size(); ++i) {
      const Field& each = function.fields[i];
      json["fields"][each.name] = field_json(input.model, row, equations, each, i);
      add_spellings(json["fields"][each.name], each.name);
    }
  } else {
    json.update(field_json(input.model, row, equations, function.fields.front(), 0));
  }
  json["operations"] = operations_json(function);
  return json;
}

Json outputs_json(const EmissionInput& input) {
  Json json = Json::object();
  for (std::size_t i = 0; i < input.program.functions.size(); ++i) {
    const Function& function = input.program.functions[i];
    json[function.name] = output_json(input, function, input.equations[i]);
  }
  return json;
}

/// {"linearization": "too many entries"}
Json omitted_outputs_json(const Scene& scene) {
  Json json = Json::object();
  for (const OmittedOutputs& each : scene.omitted_outputs) {
    for (const std::string& output : each.outputs) json[output] = name_of(each.reason);
  }
  return json;
}

}  // namespace

std::string sidecar_text(const EmissionInput& input) {
  Json json = {{"generated", input.generated_notice}, {"model", input.scene.paths.model}};
  if (!input.scene.paths.scene.empty()) json["scene"] = input.scene.paths.scene;
  json["format"] = 1;
  json["name"] = input.scene.base_name;
  // The sidecar lists entries row-major. The keys "language" and "storage" describe the code;
  // without these keys, the code has the default language and row-major storage.
  const Emission& emission = input.scene.emission;
  if (emission.language != default_language) {
    json["language"] = language_row(emission.language).name;
  }
  if (emission.storage != Storage::row_major) json["storage"] = name_of(emission.storage);
  json["coordinates"] = coordinates_json(input.model);
  if (!input.model.rotations.empty()) json["velocities"] = velocities_json(input.model);
  json["inputs"] = inputs_json(input.model);
  if (!input.model.constraints.empty()) {
    json["constraints"] = constraints_json(input.model);
  }
  if (!input.model.functions.empty()) {
    json["functions"] = open_functions_json(input.model);
    json["open_values"] = open_values_json(input.model);
  }
  json["parameters"] = parameters_json(input.model, input.program);
  json["outputs"] = outputs_json(input);
  if (!input.scene.omitted_outputs.empty()) json["left_out"] = omitted_outputs_json(input.scene);
  json["hash"] = {{"model", input.model_hash},
                  {"scene", input.scene_hash},
                  {"body", std::string(blank_hash())}};
  return with_body_hash(visible_json(json_text(json, 0, 0)) + "\n");
}

}  // namespace elgen
