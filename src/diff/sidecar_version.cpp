// sidecar_version: the lists of a sidecar become those of a Model, its equations instructions.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "elgen/diff.hpp"
#include "elgen/wording.hpp"
#include "lower/network/instructions.hpp"
#include "lower/operation_columns.hpp"
#include "parse/fold_expression.hpp"

namespace elgen {
namespace {

using Json = nlohmann::ordered_json;

/// What is wrong with the text. It leaves this file as a Diagnostic.
struct NoSidecar {
  std::string problem;
};

[[noreturn]] void fail(std::string problem) { throw NoSidecar{std::move(problem)}; }

const Json& member(const Json& object, const std::string& key) {
  if (!object.is_object() || !object.contains(key)) fail(in_backticks(key) + " is missing");
  return object[key];
}

std::string text_of(const Json& json) {
  if (!json.is_string()) fail(fmt::format("{} is no text", json.dump()));
  return json.get<std::string>();
}

std::uint32_t number_of(const Json& json) {
  if (!json.is_number_unsigned() || json.get<std::uint64_t>() > UINT32_MAX) {
    fail(fmt::format("{} is no number of things", json.dump()));
  }
  return json.get<std::uint32_t>();
}

const Json& list_of(const Json& json) {
  if (!json.is_array()) fail(fmt::format("{} is no list", json.dump()));
  return json;
}

std::string unit_of(const Json& json) {
  return json.contains("unit") ? text_of(json["unit"]) : std::string();
}

ExpressionSyntax parsed(const std::string& text) {
  Result<ExpressionSyntax> syntax = parse_expression(make_source("", text), written_limits());
  if (!syntax) fail(fmt::format("{}: {}", in_backticks(text), syntax.diagnostics.front().message));
  return *std::move(syntax);
}

/// Numbers alone: values of parameters.
struct ValueRules {
  using Value = cln::cl_R;

  static Value number(const cln::cl_RA& x) { return x; }
  static Value named(const std::string& name) { return fail(in_backticks(name) + " is no number"); }
  static Value negate(const Value& x) { return -x; }
  static Value add(const Value& x, const Value& y) { return x + y; }
  static Value multiply(const Value& x, const Value& y) { return x * y; }
  static Value divide(const Value& x, const Value& y) {
    return cln::zerop(y) ? fail("a value is divided by 0") : x / y;
  }
  static Value square_root(const Value& /*x*/) { return fail("a value is a root"); }
  static Value call(const FunctionRow& row, const Value& /*x*/, const Value& /*y*/) {
    return fail(fmt::format("a value is a {}", row.name));
  }
  static Value fail(std::string problem) { elgen::fail(std::move(problem)); }
};

using LeafPlaces = std::unordered_map<std::string, Instruction>;
using Definitions = std::unordered_map<std::string, std::uint32_t>;

/// Instructions of a function that is read.
struct InstructionRules {
  using Value = std::uint32_t;

  const LeafPlaces& leaves;
  const Definitions& definitions;
  std::vector<Constant>& constants;
  Instructions& instructions;

  Value constant(const Constant& constant) const {
    return instructions.add({.opcode = Opcode::constant, .a = position_of(constant, constants)});
  }
  Value number(const cln::cl_RA& x) const { return constant(rational_constant(x)); }
  Value named(const std::string& name) const {
    if (const auto leaf = leaves.find(name); leaf != leaves.end()) {
      return instructions.add(leaf->second);
    }
    if (const auto known = definitions.find(name); known != definitions.end()) return known->second;
    if (name == "pi") return constant(*constant_of({.kind = ConstantKind::pi, .parts = {}}));
    return fail(in_backticks(name) + " is not defined");
  }
  Value negate(Value x) const { return instructions.add(Opcode::negate, x); }
  Value add(Value x, Value y) const { return instructions.add(Opcode::add, x, y); }
  Value multiply(Value x, Value y) const { return instructions.add(Opcode::multiply, x, y); }
  Value divide(Value x, Value y) const { return instructions.add(Opcode::divide, x, y); }
  Value square_root(Value x) const { return instructions.add(Opcode::square_root, x); }
  Value call(const FunctionRow& row, Value x, Value y) const {
    return instructions.add(
        {.opcode = Opcode::call, .function = row.id, .a = x, .b = row.arity > 1 ? y : 0});
  }
  static Value fail(std::string problem) { elgen::fail(std::move(problem)); }
};

class FunctionParser {
 public:
  FunctionParser(const LeafPlaces& leaves, std::vector<Constant>& constants, Function function)
      : leaves_(leaves), constants_(constants), function_(std::move(function)) {}

  Function operator()(const Json& json) {
    if (json.contains("definitions")) {
      for (const Json& line : list_of(json["definitions"])) {
        definitions_[text_of(member(line, "name"))] = value(member(line, "value"));
      }
    }
    if (json.contains("entries")) read_field("", json);
    if (json.contains("fields")) {
      for (const auto& [name, entries] : json["fields"].items()) read_field(name, entries);
    }
    return std::move(function_);
  }

 private:
  std::uint32_t value(const Json& text) {
    return fold_expression(parsed(text_of(text)),
                           InstructionRules{leaves_, definitions_, constants_, instructions_});
  }

  void read_field(const std::string& name, const Json& json) {
    const Json& shape = list_of(member(json, "shape"));
    if (shape.size() != 2) fail("a shape has two numbers");
    Field field{name, number_of(shape[0]), number_of(shape[1]), {}};
    for (const Json& entry : list_of(member(json, "entries"))) {
      field.entries.push_back(value(entry));
    }
    if (field.entries.size() != std::size_t{field.rows} * field.columns) {
      fail(fmt::format("{} of {} x {} has {} entries", in_backticks(function_.name), field.rows,
                       field.columns, field.entries.size()));
    }
    function_.fields.push_back(std::move(field));
  }

  const LeafPlaces& leaves_;
  std::vector<Constant>& constants_;
  Function function_;
  Instructions instructions_{function_};
  Definitions definitions_ = {};
};

class SidecarParser {
 public:
  SidecarVersion operator()(const Json& json) {
    Scene& scene = result_.checked.scene;
    scene.base_name = text_of(member(json, "name"));
    read_target(json);
    read_model(json);
    result_.program.leaves = leaf_names(result_.checked.model);
    // Whether t is an argument is not said; equations that have it say so.
    result_.program.leaves.t = "t";
    collect_leaves();
    const Json& outputs = member(json, "outputs");
    if (!outputs.is_object()) fail("`outputs` is no table");
    for (const auto& [name, output] : outputs.items()) read_output(name, output);
    result_.checked.model.uses_time = result_.program.leaves.uses_time;
    return std::move(result_);
  }

 private:
  void read_target(const Json& json) {
    Emission& emission = result_.checked.scene.emission;
    if (json.contains("language")) {
      const std::string name = text_of(json["language"]);
      const auto row = std::ranges::find(language_table, name, &LanguageRow::name);
      if (row == language_table.end()) fail(in_backticks(name) + " is no language");
      emission.language = row->id;
    }
    if (json.contains("storage")) {
      const bool is_by_columns = text_of(json["storage"]) == name_of(Storage::column_major);
      emission.storage = is_by_columns ? Storage::column_major : Storage::row_major;
    }
  }

  void read_model(const Json& json) {
    Model& model = result_.checked.model;
    model.name = result_.checked.scene.base_name;
    for (const Json& each : list_of(member(json, "coordinates"))) {
      Coordinate& q = model.coordinates.emplace_back();
      q.name = text_of(member(each, "name"));
      q.unit_text = unit_of(each);
    }
    // Where nothing rotates, velocities are called as their coordinates.
    const char* const rates = json.contains("velocities") ? "velocities" : "coordinates";
    for (const Json& each : list_of(member(json, rates))) {
      model.velocities.emplace_back().name = text_of(member(each, "name"));
    }
    for (const Json& each : list_of(member(json, "inputs"))) {
      Input& u = model.inputs.emplace_back();
      u.name = text_of(member(each, "name"));
      u.unit_text = unit_of(each);
    }
    for (const Json& each : list_of(member(json, "parameters"))) read_parameter(each);
  }

  void read_parameter(const Json& json) {
    Model& model = result_.checked.model;
    ParameterArray array{.name = text_of(member(json, "name")),
                         .first = static_cast<std::uint32_t>(model.parameters.size()),
                         .is_array = json.contains("size"),
                         .unit_text = unit_of(json)};
    const Json& value = member(json, "value");
    const Json values = array.is_array ? list_of(value) : Json::array({value});
    array.count = static_cast<std::uint32_t>(values.size());
    for (std::uint32_t i = 0; i < array.count; ++i) {
      Parameter& parameter = model.parameters.emplace_back();
      parameter.name = array.is_array ? fmt::format("{}[{}]", array.name, i + 1) : array.name;
      parameter.array = static_cast<std::uint32_t>(model.parameter_arrays.size());
      parameter.element = i;
      parameter.value = fold_expression(parsed(text_of(values[i])), ValueRules{});
    }
    model.parameter_arrays.push_back(std::move(array));
  }

  void collect_leaves() {
    const LeafNames& names = result_.program.leaves;
    for_each_leaf(
        [&](Opcode kind, std::uint32_t number, const std::string& name) {
          if (name.empty()) return;
          leaves_.emplace(leaf_text(names, kind, number), Instruction{.opcode = kind, .a = number});
        },
        static_cast<const LeafValues<std::string>&>(names));
  }

  void read_output(const std::string& name, const Json& json) {
    result_.operations.emplace(name, operations_of(member(json, "operations")));
    const OutputRow* const row =
        find_output(json.contains("output") ? text_of(json["output"]) : name);
    const OutputKind kind = row != nullptr ? row->kind : OutputKind::user_value;
    result_.checked.scene.outputs.push_back({.kind = kind, .name = name});
    if (!json.contains("entries") && !json.contains("fields")) return;
    Function function =
        FunctionParser(leaves_, result_.program.constants, {.kind = kind, .name = name})(json);
    const auto reads_time = [](const Instruction& i) { return i.opcode == Opcode::time; };
    bool& uses_time = result_.program.leaves.uses_time;
    uses_time = uses_time || std::ranges::any_of(function.instructions, reads_time);
    result_.program.functions.push_back(std::move(function));
  }

  static OperationCounts operations_of(const Json& json) {
    OperationCounts counts;
    for (const auto& [name, count] : operation_columns) {
      counts.*count = number_of(member(json, std::string(name)));
    }
    return counts;
  }

  SidecarVersion result_ = {};
  LeafPlaces leaves_ = {};
};

}  // namespace

Version SidecarVersion::version() const {
  return {syntax, nullptr, checked, program, warnings, &operations};
}

Result<SidecarVersion> parse_sidecar(const SourcePointer& source) {
  const auto no_sidecar = [&source](const std::string& problem) {
    return Diagnostic{
        Code::E714,
        {source.get(), 0, 0},
        fmt::format("{} is no sidecar of equations: {}", in_backticks(source->path), problem)};
  };
  const Json json = Json::parse(source->text, nullptr, false);
  if (json.is_discarded()) return no_sidecar("the text is no JSON");
  try {
    SidecarVersion version = SidecarParser()(json);
    version.syntax.source = source;
    return version;
  } catch (const NoSidecar& found) {
    return no_sidecar(found.problem);
  }
}

}  // namespace elgen
