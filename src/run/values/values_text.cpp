// Writes tables of values: as text, as JSON, as CSV with a row per entry, and as C arrays.
#include <fmt/ranges.h>

#include <algorithm>

#include "base/json.hpp"
#include "base/text_table.hpp"
#include "elgen/wording.hpp"
#include "emit/interface/code_interface.hpp"
#include "model/state_text.hpp"
#include "run/values/records.hpp"

namespace elgen {
namespace {

/// The leaves of a kind, as models name them.
std::vector<std::string> leaf_texts(const Model& model, Opcode kind) {
  std::vector<std::string> texts;
  const auto count = static_cast<std::uint32_t>(leaf_count(model, kind));
  for (std::uint32_t i = 0; i < count; ++i) texts.push_back(leaf_text(model, kind, i));
  return texts;
}

LeafSet leaf_set(const std::vector<Opcode>& kinds) {
  LeafSet set;
  for (const Opcode kind : kinds) set |= kind;
  return set;
}

/// The kinds of leaves that at least one function takes.
LeafSet argument_kinds(const ValueTable& table) {
  LeafSet kinds;
  for (const ValueFunction& function : table.functions) kinds |= leaf_set(function.takes);
  return kinds;
}

/// The text of one field; `texts`: its numbers with units.
std::string field_text(const std::string& title, const ValueField& field,
                       std::vector<std::string> texts) {
  const std::vector<std::string> no_name{""};
  const bool has_columns = field.columns != no_name;
  if (!has_columns && field.rows == no_name) return title + " = " + texts.front() + "\n";
  const std::size_t width = field.columns.size();
  TextRows rows{{""}};
  rows.front().insert(rows.front().end(), field.columns.begin(), field.columns.end());
  for (std::size_t i = 0; i < field.rows.size(); ++i) {
    rows.push_back({field.rows[i]});
    const auto first = texts.begin() + static_cast<std::ptrdiff_t>(i * width);
    rows.back().insert(rows.back().end(), first, first + static_cast<std::ptrdiff_t>(width));
  }
  std::vector<std::string> lines = table_lines(rows, {{}, {.is_right_aligned = true}});
  if (!has_columns) lines.erase(lines.begin());
  return fmt::format("{}\n{}\n", title, fmt::join(lines, "\n"));
}

/// The leaves that some function takes, except parameters: "theta = 0.1, dot(theta) = 2.0".
std::string state_text(const ValueTable& table, const State& state) {
  const LeafSet kinds = argument_kinds(table);
  std::vector<std::string> parts;
  const auto add = [&](Opcode kind, std::uint32_t number, const cln::cl_R& value) {
    if (kind == Opcode::parameter || !kinds.has_any(kind)) return;
    parts.push_back(fmt::format("{} = {}", leaf_text(table.model, kind, number),
                                rounded_decimal_text(value, table.digits)));
  };
  for_each_leaf(add, state);
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string function_json(const ValueTable& table, const ValueFunction& function) {
  Json object{{"name", function.output.name}};
  for (const Opcode kind : function.takes) {
    object["takes"][leaf_row(kind).symbol] = leaf_texts(table.model, kind);
  }
  for (const auto& [name, rows, columns, units] : function.fields) {
    object["fields"].push_back(
        {{"name", name}, {"rows", rows}, {"columns", columns}, {"units", units}});
  }
  return object.dump();
}

std::string record_json(const ValueTable& table, const ValueRecord& record) {
  const ValueFunction& function = table.functions[record.function];
  std::string text = fmt::format(
      R"({{"function": "{}", "state": "{}", {}, "value": [{}])", function.output.name,
      record.state_name, state_json(table.model, record.state, function.takes, table.digits),
      rounded_decimal_texts(record.values, table.digits));
  if (!record.digits.empty())
    text += fmt::format(R"(, "digits": [{}])", fmt::join(record.digits, ", "));
  return text + "}";
}

/// The members of a function's C struct: arguments, values, and digits of the values.
std::string struct_text(const ValueTable& table, const ValueFunction& function) {
  std::string text;
  for (const Opcode kind : function.takes) {
    const std::vector<std::string> names = leaf_texts(table.model, kind);
    if (names.empty()) continue;  // C has no empty arrays
    text += fmt::format("  double {}{}; /* {} */\n", leaf_row(kind).symbol,
                        is_single(kind) ? "" : fmt::format("[{}]", names.size()),
                        fmt::join(names, ", "));
  }
  std::size_t size = 0;
  std::vector<std::string> shapes;
  for (const ValueField& field : function.fields) {
    size += field.units.size();
    shapes.push_back(fmt::format("{} {} x {}", field.name.empty() ? "value" : field.name,
                                 field.rows.size(), field.columns.size()));
  }
  return text + fmt::format("  double value[{0}]; /* {1} */\n  int digits[{0}];\n", size,
                            fmt::join(shapes, ", "));
}

std::string initializer(const ValueTable& table, const ValueRecord& record) {
  std::string text;
  for (const Opcode kind : table.functions[record.function].takes) {
    const auto* const list = leaf_list(record.state, kind);
    if (list != nullptr && list->empty()) continue;
    text += list == nullptr
                ? rounded_decimal_text(leaf_of(record.state, kind, 0), table.digits) + ", "
                : fmt::format("{{{}}}, ", rounded_decimal_texts(*list, table.digits));
  }
  return fmt::format("  {{{}{{{}}}, {{{}}}}}, /* {} */\n", text,
                     rounded_decimal_texts(record.values, table.digits),
                     fmt::join(record.digits, ", "), record.state_name);
}

}  // namespace

std::string to_text(const ValueTable& table) {
  std::string text;
  for (const ValueRecord& record : table.records) {
    if (text.empty()) text = table.name + " at " + state_text(table, record.state) + "\n";
    const ValueFunction& function = table.functions[record.function];
    auto value = record.values.begin();
    for (const ValueField& field : function.fields) {
      std::vector<std::string> texts;
      for (const std::string& unit : field.units) {
        const bool has_unit = !unit.empty() && unit != "1";
        texts.push_back(rounded_decimal_text(*value++, table.digits) +
                        (has_unit ? " " + unit : ""));
      }
      const std::string part = field.name.empty() ? "" : "." + field.name;
      text += field_text(function.output.name + part, field, std::move(texts));
    }
  }
  return text;
}

std::string to_json(const ValueTable& table) {
  std::vector<std::string> functions;
  for (const ValueFunction& f : table.functions) functions.push_back(function_json(table, f));
  std::vector<std::string> records;
  for (const ValueRecord& record : table.records) records.push_back(record_json(table, record));
  const std::string unmet =
      table.skipped_states ? fmt::format(" \"off_constraints\": {},\n", *table.skipped_states) : "";
  return fmt::format(
      "{{\"name\": \"{}\",\n{} \"functions\": [\n  {}\n ],\n \"values\": [\n  {}\n ]}}\n",
      table.name, unmet, fmt::join(functions, ",\n  "), fmt::join(records, ",\n  "));
}

std::string to_csv(const ValueTable& table) {
  const LeafSet kinds = argument_kinds(table);
  std::string text = "function,field,row,column,unit,value,digits,state";
  for (const LeafRow& row : leaf_table()) {
    if (!kinds.has_any(row.id) || leaf_count(table.model, row.id) == 0) continue;
    text += fmt::format(",{}", fmt::join(leaf_texts(table.model, row.id), ","));
  }
  text += "\n";
  for (const ValueRecord& record : table.records) {
    const ValueFunction& function = table.functions[record.function];
    const LeafSet own_kinds = leaf_set(function.takes);
    std::string cells = record.state_name;
    for_each_leaf(
        [&](Opcode kind, std::uint32_t, const cln::cl_R& value) {
          if (!kinds.has_any(kind)) return;
          cells += "," + (own_kinds.has_any(kind) ? rounded_decimal_text(value, table.digits) : "");
        },
        record.state);
    std::size_t entry = 0;
    for (const ValueField& field : function.fields) {
      for (std::size_t i = 0; i < field.units.size(); ++i, ++entry) {
        const std::size_t width = field.columns.size();
        text +=
            fmt::format("{},{},{},{},{},{},{},{}\n", function.output.name, field.name,
                        field.rows[i / width], field.columns[i % width], field.units[i],
                        rounded_decimal_text(record.values[entry], table.digits),
                        record.digits.empty() ? "" : std::to_string(record.digits[entry]), cells);
      }
    }
  }
  return text;
}

std::string to_header(const ValueTable& table) {
  const std::string unmet =
      table.skipped_states.value_or(0) == 0
          ? ""
          : fmt::format("\n   {} omitted: not projected onto the constraints.",
                        count_text(*table.skipped_states, "state"));
  std::string text = fmt::format(
      "/* Test vectors of {0}: arguments of its functions and their values, row-major, one field\n"
      "   after the other. digits: the significant digits of a value that a double keeps.{2} */\n"
      "#ifndef {1}_VECTORS_H\n#define {1}_VECTORS_H\n",
      table.name, upper_case(table.name), unmet);
  for (std::size_t i = 0; i < table.functions.size(); ++i) {
    const ValueFunction& function = table.functions[i];
    std::string rows;
    for (const ValueRecord& record : table.records) {
      if (record.function == i) rows += initializer(table, record);
    }
    text +=
        fmt::format("\nstatic const struct {0}_vector {{\n{1}}} {0}_vectors[{2}] = {{\n{3}}};\n",
                    table.name + "_" + function.output.name, struct_text(table, function),
                    std::ranges::count(table.records, i, &ValueRecord::function), rows);
  }
  return text + "\n#endif\n";
}

}  // namespace elgen
