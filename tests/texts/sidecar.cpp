// read_sidecar: each object must have exactly the expected keys.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

#include "elgen/wording.hpp"
#include "emit/interface/code_interface.hpp"
#include "model/output_units.hpp"
#include "numbers/exact_number.hpp"
#include "texts/readers.hpp"

namespace elgen::test {
namespace {

using Json = nlohmann::ordered_json;

class SidecarReader {
 public:
  explicit SidecarReader(WrittenEquations& equations)
      : origin_(equations.origin()), equations_(equations) {}

  void read(const std::string& text) {
    Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) fail("the text is no JSON");
    const Model& model = origin_.model;
    take(json, "generated");
    expect(take(json, "model"), origin_.scene.paths.model);
    if (!origin_.scene.paths.scene.empty()) expect(take(json, "scene"), origin_.scene.paths.scene);
    expect(take(json, "format"), 1);
    expect(take(json, "name"), origin_.scene.base_name);
    emission(json);
    coordinates(take(json, "coordinates"));
    if (!model.rotations.empty()) velocities(take(json, "velocities"));
    inputs(take(json, "inputs"));
    if (!model.constraints.empty()) constraints(take(json, "constraints"));
    if (!model.functions.empty()) open_functions(json);
    parameters(take(json, "parameters"));
    outputs(take(json, "outputs"));
    if (!origin_.scene.omitted_outputs.empty()) left_out(take(json, "left_out"));
    take(json, "hash");
    expect_empty(json);
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw Mistake((function_.empty() ? "" : quote_text(function_) + ": ") + problem);
  }

  /// Returns the value of a key and removes the key.
  Json take(Json& object, const std::string& key) {
    const bool is_there = object.is_object() && object.contains(key);
    if (!is_there) fail(quote_text(key) + " is missing");
    Json value = std::move(object[key]);
    object.erase(key);
    return value;
  }

  void expect(const Json& found, const Json& expected) const {
    if (found != expected) fail(fmt::format("{} instead of {}", found.dump(), expected.dump()));
  }

  void expect_empty(const Json& rest) const {
    if (!rest.empty()) fail(quote_text(rest.begin().key()) + " should not be there");
  }

  [[nodiscard]] std::string text_of(const Json& json) const {
    if (!json.is_string()) fail("an expression should stand here");
    return json.get<std::string>();
  }

  void emission(Json& json) {
    const Emission& emission = origin_.scene.emission;
    if (emission.language != LanguageId::cpp) {
      expect(take(json, "language"), language_row(emission.language).name);
    }
    if (emission.storage != Storage::row_major) {
      expect(take(json, "storage"), name_of(emission.storage));
    }
  }

  void expect_size(const Json& list, std::size_t size) const {
    const bool is_right = list.is_array() && list.size() == size;
    if (!is_right) fail(fmt::format("a list of {} should stand here", size));
  }

  template <class Element, class Unit>
  void named(Json list, const std::vector<Element>& elements, const Unit& unit) {
    expect_size(list, elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
      expect(take(list[i], "name"), elements[i].name);
      const std::string text = unit(elements[i]);
      if (!text.empty()) expect(take(list[i], "unit"), text);
      expect_empty(list[i]);
    }
  }

  void interval(Json& json, const char* key, const std::optional<Interval>& interval) {
    if (!interval) return;
    expect(take(json, key), {exact_text(interval->low), exact_text(interval->high)});
  }

  void rate(Json& json, const Velocity& velocity) {
    interval(json, "rate_range", velocity.rate_range);
    expect(take(json, "start_rate"), exact_text(velocity.start_rate));
  }

  void coordinates(Json list) {
    const Model& model = origin_.model;
    expect_size(list, model.coordinates.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
      const Coordinate& coordinate = model.coordinates[i];
      interval(list[i], "range", coordinate.range);
      expect(take(list[i], "start"), exact_text(coordinate.start_value));
      if (coordinate.wraps) expect(take(list[i], "wrap"), true);
      if (model.rotations.empty()) rate(list[i], model.velocities[i]);
    }
    named(std::move(list), model.coordinates, [](const Coordinate& c) { return c.unit_text; });
  }

  void velocities(Json list) {
    const Model& model = origin_.model;
    expect_size(list, model.velocities.size());
    for (std::size_t i = 0; i < list.size(); ++i) rate(list[i], model.velocities[i]);
    named(std::move(list), model.velocities,
          [&](const Velocity& v) { return velocity_unit_text(model, v); });
  }

  void inputs(Json list) {
    const Model& model = origin_.model;
    expect_size(list, model.inputs.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
      interval(list[i], "limits", model.inputs[i].limits);
    }
    named(std::move(list), model.inputs, [](const Input& input) { return input.unit_text; });
  }

  void constraints(Json list) {
    const Model& model = origin_.model;
    expect_size(list, model.constraints.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
      const Constraint& constraint = model.constraints[i];
      expect(take(list[i], "kind"), constraint.is_position ? "position" : "velocity");
      expect(take(list[i], "value"), to_string(model, constraint.value));
    }
    named(std::move(list), model.constraints,
          [](const Constraint& c) { return c.unit ? to_string(*c.unit) : std::string(); });
  }

  void open_functions(Json& json) {
    const Model& model = origin_.model;
    const auto unit = [](const auto& declared) { return declared.unit_text; };
    Json functions = take(json, "functions");
    expect_size(functions, model.functions.size());
    for (std::size_t i = 0; i < functions.size(); ++i) {
      expect_size(take(functions[i], "of"), model.functions[i].arguments.size());
    }
    named(std::move(functions), model.functions, unit);
    Json values = take(json, "open_values");
    expect_size(values, model.open_values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const OpenValue& value = model.open_values[i];
      expect(take(values[i], "function"), model.functions[value.function].name);
      expect_size(take(values[i], "by"), value.derivative_arguments.size());
    }
    named(std::move(values), model.open_values, unit);
  }

  void parameters(Json list) {
    const std::vector<ParameterArray> arrays = emitted_parameters(origin_.model, origin_.program);
    expect_size(list, arrays.size());
    for (std::size_t i = 0; i < arrays.size(); ++i) {
      const ParameterArray& array = arrays[i];
      expect(take(list[i], "name"), array.name);
      if (!array.unit_text.empty()) expect(take(list[i], "unit"), array.unit_text);
      if (array.is_array) expect(take(list[i], "size"), array.count);
      Json values = take(list[i], "value");
      if (!array.is_array) values = Json::array({values});
      expect_size(values, array.count);
      for (std::uint32_t k = 0; k < array.count; ++k) {
        const cln::cl_R& value = origin_.model.parameters[array.first + k].value;
        const std::string problem = equations_.number(value, text_of(values[k]));
        if (!problem.empty()) fail(problem);
      }
      interval(list[i], "range", array.range);
      const Assumption assumption = origin_.model.parameters[array.first].assumption;
      if (assumption != Assumption::none) {
        const bool is_positive = assumption == Assumption::positive;
        expect(take(list[i], "assume"), is_positive ? "positive" : "nonnegative");
      }
      spellings(list[i], array.name);
      expect_empty(list[i]);
    }
  }

  /// Checks `spelt`: the spelling of a reserved word `name` is `name` with an underscore.
  void spellings(Json& json, const std::string& name) {
    if (!json.contains("spelt")) return;
    Json spelt = take(json, "spelt");
    for (const auto& [language, text] : spelt.items()) expect(text, name + "_");
  }

  void outputs(Json all) {
    const Program& program = origin_.program;
    for (std::size_t i = 0; i < program.functions.size(); ++i) {
      const Function& function = program.functions[i];
      Json output = take(all, function.name);
      function_ = function.name;
      equations_.start(i);
      const OutputRow& row = output_row(function.kind);
      if (!row.is_user_output && row.name != function.name)
        expect(take(output, "output"), row.name);
      spellings(output, function.name);
      arguments(take(output, "arguments"), function);
      equations(output, function, has_equations(row));
      operations(take(output, "operations"), function);
      expect_empty(output);
      function_.clear();
    }
    expect_empty(all);
  }

  void left_out(Json all) {
    for (const OmittedOutputs& each : origin_.scene.omitted_outputs) {
      for (const std::string& output : each.outputs) {
        expect(take(all, output), name_of(each.reason));
      }
    }
    expect_empty(all);
  }

  void arguments(const Json& list, const Function& function) {
    const std::vector<Opcode> expected =
        arguments_of(origin_.model, function, origin_.program, origin_.scene.emission.language);
    expect_size(list, expected.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
      expect(list[i], leaf_row(expected[i]).symbol);
    }
  }

  void equations(Json& output, const Function& function, bool has_entries) {
    if (output.contains("definitions")) definitions(take(output, "definitions"));
    if (!returns_struct(function)) return field(output, function.fields.front(), has_entries);
    Json fields = take(output, "fields");
    for (const Field& each : function.fields) {
      Json entries = take(fields, each.name);
      field(entries, each, has_entries);
      spellings(entries, each.name);
      expect_empty(entries);
    }
    expect_empty(fields);
  }

  void definitions(const Json& list) {
    for (Json line : list) {
      const std::string name = text_of(take(line, "name"));
      const std::string problem = equations_.definition(name, text_of(take(line, "value")));
      if (!problem.empty()) fail(problem);
      expect_empty(line);
    }
  }

  /// Checks that `key` has `count` names of rows or columns, all different. The key is absent if
  /// another list of the file contains the names.
  void line_names(Json& json, const std::string& key, std::size_t count) {
    if (!json.contains(key)) return;
    const Json names = take(json, key);
    expect_size(names, count);
    std::set<std::string> known;
    for (const Json& name : names) {
      if (!known.insert(text_of(name)).second) fail(name.dump() + " stands twice in " + key);
    }
  }

  void field(Json& json, const Field& field, bool has_entries) {
    expect(take(json, "shape"), Json{field.rows, field.columns});
    line_names(json, "rows", field.rows);
    line_names(json, "columns", field.columns);
    if (!has_entries) return;
    const Json entries = take(json, "entries");
    expect_size(entries, field.entries.size());
    for (std::size_t i = 0; i < field.entries.size(); ++i) {
      const std::string problem = equations_.entry(field.entries[i], text_of(entries[i]));
      if (!problem.empty()) fail(problem);
    }
  }

  void operations(Json json, const Function& function) {
    const OperationCounts n = count_operations(function);
    for (const auto& [name, count] : operation_columns) {
      expect(take(json, std::string(name)), n.*count);
    }
    expect_empty(json);
  }

  const Origin& origin_;
  WrittenEquations& equations_;
  std::string function_ = {};
};

}  // namespace

void read_sidecar(const std::string& json, WrittenEquations& equations) {
  SidecarReader(equations).read(json);
}

}  // namespace elgen::test
