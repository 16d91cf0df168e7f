// scene_text: writes a scene as TOML. A design's choices replace the choices of the scene.
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "base/ascii.hpp"
#include "base/toml_text.hpp"
#include "elgen/syntax.hpp"
#include "elgen/tradeoff.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

/// `text` without quotes if it is an integer of up to 18 digits, otherwise as a TOML string.
std::string expression_text(const std::string& text) {
  constexpr std::size_t most_digits = 18;
  const bool is_integer = !text.empty() && text.size() <= most_digits &&
                          std::ranges::all_of(text, is_digit) &&
                          (text.size() == 1 || text.front() != '0');
  return is_integer ? text : toml_string(text);
}

/// A line of TOML without its end: "a = 1".
std::string toml_assignment(const std::string& key, const std::string& value) {
  return fmt::format("{} = {}", toml_key(key), value);
}

std::string toml_value(const ValueSyntax& value) {
  std::vector<std::string> parts;
  switch (value.kind) {
    case ValueKind::expression:
      return expression_text(value.text);
    case ValueKind::text:
      return toml_string(value.text);
    case ValueKind::boolean:
      return value.boolean ? "true" : "false";
    case ValueKind::list:
      for (const ValueSyntax& item : value.items) parts.push_back(toml_value(item));
      return toml_list(parts);
    case ValueKind::table:
      for (const KeySyntax& key : value.entries) {
        parts.push_back(toml_assignment(key.key, toml_value(key.value)));
      }
      return toml_inline_table(parts);
  }
  return {};
}

/// The text without the characters that cannot occur in a name: "1e7" for "1e-7".
std::string strip_to_word(std::string text) {
  std::erase_if(text, [](char c) { return !is_word_character(c); });
  return text;
}

/// The start of a run as an expansion point, without rotations, which are not expanded.
std::string start_point_table(const Model& model) {
  std::vector<std::string> values;
  for (const Coordinate& coordinate : model.coordinates) {
    if (coordinate.rotation) continue;
    values.push_back(
        toml_assignment(coordinate.name, expression_text(exact_text(coordinate.start_value))));
  }
  return toml_inline_table(values);
}

/// "key = value" and a line end; "" if the value is empty.
std::string toml_line(const std::string& key, const std::string& value) {
  return value.empty() ? "" : toml_assignment(key, value) + "\n";
}

/// The `max_error` of sines in a scene of steps with the scalars of this design; "" for none.
std::string sine_error_of_steps(const Design& design, const Numerics& numerics) {
  const bool has_float = design.inner == InnerScalar::single_precision;
  const ScalarKind coarsest = has_float ? ScalarKind::single_precision : design.scalar;
  const cln::cl_RA least =
      design.in_packs ? trigonometry_error({}, coarsest) : least_lone_sine_error(coarsest);
  const std::optional<cln::cl_RA>& error = numerics.trigonometry_error;
  return error && *error >= least ? exact_text(*error) : "";
}

/// The value of `trigonometry`; "" for the default. A design of steps has the sines of the scene.
std::string trigonometry_value(const Design& design, const Scene& scene) {
  std::vector<std::string> entries;
  const std::string sines =
      design.step ? sine_error_of_steps(design, scene.numerics) : design.trigonometry;
  const bool is_library = design.step ? scene.numerics.has_library_sines : sines == library_sines;
  if (is_library) {
    entries.emplace_back("scalar = \"library\"");
  } else if (!sines.empty()) {
    entries.push_back(fmt::format("max_error = \"{}\"", sines));
  }
  return entries.empty() ? "" : toml_inline_table(entries);
}

class DesignSceneWriter {
 public:
  DesignSceneWriter(const DesignSource& base, const Design& design)
      : base_(base), design_(design) {}

  [[nodiscard]] std::string write(const std::string& model_path) const {
    return fmt::format("format = 1\nmodel = {}\nname = \"{}\"\n", toml_string(model_path),
                       scene_name()) +
           toml_line("doc", design_.doc.empty() ? "" : toml_string(design_.doc)) +
           toml_section("outputs", {toml_line(output_name(), output_value()),
                                    toml_line("projected", projected_request())}) +
           toml_section("parameters", {toml_line("fixed", fixed_value())}) +
           toml_section("sizes", scene_value("sizes")) + toml_section("lock", scene_value("lock")) +
           toml_section("routh", scene_value("routh")) +
           toml_section("functions", scene_value("functions")) +
           toml_section("approximate", approximation_lines()) +
           toml_section("numeric", numeric_lines()) +
           toml_section("emit", {toml_line("batch", design_.in_packs ? "true" : "")});
  }

 private:
  using Lines = std::vector<std::string>;

  static std::string toml_section(const char* title, const Lines& lines) {
    const std::string text = fmt::format("{}", fmt::join(lines, ""));
    return text.empty() ? "" : fmt::format("\n[{}]\n{}", title, text);
  }

  /// The value of a key in the scene; "" if the scene lacks the key.
  [[nodiscard]] std::string scene_value(const char* entry, const char* key) const {
    const KeySyntax* const found = find_key(base_.scene, entry, key);
    return found == nullptr ? "" : toml_value(found->value);
  }

  [[nodiscard]] Lines scene_value(const char* entry) const {
    Lines lines;
    const EntrySyntax* const found = find_entry(base_.scene, entry);
    if (found == nullptr) return lines;
    for (const KeySyntax& key : found->keys)
      lines.push_back(toml_line(key.key, toml_value(key.value)));
    return lines;
  }

  [[nodiscard]] std::string scene_name() const {
    std::string text = base_.checked.scene.name;
    const auto add = [&text](const std::string& word) {
      if (!word.empty()) text += (text.empty() ? "" : "_") + word;
    };
    add(std::string(name_of(design_.scalar)));
    add(design_.in_packs ? "packs" : "");
    add(inner_name().empty() ? "" : "in_" + strip_to_word(inner_name()));
    add(strip_to_word(design_.trigonometry));
    add(design_.is_fixed ? "fixed" : "");
    add(design_.is_typed ? "typed" : "");
    if (!design_.order.empty()) add("order_" + design_.order);
    if (design_.step) add(std::string(step_name()));
    if (design_.step && design_.step->composed_order > 0) {
      add(std::to_string(design_.step->composed_order));
    }
    return text;
  }

  /// The inner scalar; "" if it is the same as the scalar.
  [[nodiscard]] std::string inner_name() const {
    if (design_.inner == InnerScalar::same) return {};
    return std::string(inner_scalar_row(design_.inner).name);
  }

  [[nodiscard]] std::string_view step_name() const {
    return step_method_row(design_.step->method).name;
  }

  [[nodiscard]] std::string output_name() const {
    return design_.step ? std::string(output_row(OutputKind::step).name)
                        : base_.checked.scene.outputs.front().name;
  }

  /// The value of `projected`: "true" if the design has a step and the model has constraints,
  /// because runs project after each step; otherwise "".
  [[nodiscard]] std::string projected_request() const {
    return design_.step && !base_.checked.model.constraints.empty() ? "true" : "";
  }

  [[nodiscard]] std::string output_value() const {
    if (design_.step) {
      Lines entries{fmt::format("method = \"{}\"", step_name())};
      const std::uint32_t order = design_.step->composed_order;
      if (order > 0) entries.push_back(fmt::format("order = {}", order));
      return toml_inline_table(entries);
    }
    const KeySyntax* const key = find_key(base_.scene, "outputs", output_name());
    Lines entries;
    for (const char* const name : {"form", "pivots"}) {
      const bool is_replaced = design_.is_typed && std::string_view(name) == "form";
      const KeySyntax* const own = key == nullptr || is_replaced ? nullptr : key->value.find(name);
      if (own != nullptr) entries.push_back(toml_assignment(name, toml_value(own->value)));
    }
    return entries.empty() ? "true" : toml_inline_table(entries);
  }

  /// The value of `fixed`. A parameter that the scene fixes keeps the scene's value, even if the
  /// design fixes all parameters.
  [[nodiscard]] std::string fixed_value() const {
    const std::string own_value = scene_value("parameters", "fixed");
    if (!design_.is_fixed) return own_value;
    const auto& known = base_.checked.scene.specialisation.fixed;
    if (known.empty()) return "\"all\"";
    Lines values;
    const Model& model = base_.checked.model;
    for (std::uint32_t i = 0; i < model.parameters.size(); ++i) {
      const Parameter& parameter = model.parameters[i];
      const auto found = known.find(i);
      const FixedValue value = found == known.end()
                                   ? FixedValue{parameter.value, parameter.exact_expression}
                                   : found->second;
      const std::string text = value.exact_expression ? to_string(model, *value.exact_expression)
                                                      : exact_text(value.number);
      values.push_back(toml_assignment(parameter.name, expression_text(text)));
    }
    return toml_inline_table(values);
  }

  /// The lines of `[approximate]`; none if the design is exact. The order of the design replaces
  /// the scene's order; if the scene then has no expansion point, the point is the start.
  [[nodiscard]] Lines approximation_lines() const {
    if (design_.order == exact_design.order) return {};
    const bool is_expanded = !design_.order.empty();
    const std::string about = scene_value("approximate", "about");
    return {toml_line("order", is_expanded ? design_.order : scene_value("approximate", "order")),
            toml_line("about", is_expanded && about.empty() ? start_point_table(base_.checked.model)
                                                            : about),
            toml_line("small", scene_value("approximate", "small"))};
  }

  [[nodiscard]] Lines numeric_lines() const {
    return {toml_line("scalar", fmt::format("[\"{}\"]", name_of(design_.scalar))),
            toml_line("inner", inner_name().empty() ? "" : toml_string(inner_name())),
            toml_line("form", design_.is_typed ? R"("recursive")" : scene_value("numeric", "form")),
            toml_line("prefer", design_.is_typed ? R"("speed")" : scene_value("numeric", "prefer")),
            toml_line("trigonometry", trigonometry_value(design_, base_.checked.scene)),
            toml_line("max_error",
                      base_.max_error ? expression_text(fmt::format("{}", *base_.max_error)) : ""),
            toml_line("ranges", ranges_value())};
  }

  /// The ranges of the scene, extended or replaced by the ranges of the command.
  [[nodiscard]] std::string ranges_value() const {
    std::map<std::string, std::string> ends;
    const KeySyntax* const key = find_key(base_.scene, "numeric", "ranges");
    if (key != nullptr) {
      for (const KeySyntax& range : key->value.entries) ends[range.key] = toml_value(range.value);
    }
    const auto given = parse_options(base_.ranges, KeyType::range, Limits{});
    for (const KeySyntax& range : *given) ends[range.key] = toml_value(range.value);
    Lines entries;
    for (const auto& [name, range] : ends) entries.push_back(toml_assignment(name, range));
    return entries.empty() ? "" : toml_inline_table(entries);
  }

  const DesignSource& base_;
  const Design& design_;
};

}  // namespace

std::string scene_text(const DesignSource& base, const Design& design,
                       const std::string& model_path) {
  return DesignSceneWriter(base, design).write(model_path);
}

}  // namespace elgen
