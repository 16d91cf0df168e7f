// A parameter is NAME = number, string or { value, unit, min, max, assume, size, latex, doc }. With
// `size`, the value is one number for all elements or a list.
#include "check/expressions/parameters.hpp"

#include "base/reason.hpp"
#include "check/expressions/units.hpp"
#include "check/expressions/values.hpp"

namespace elgen {
namespace {

constexpr const char* formula_hint = "a formula of other names stands in `[define]`";

void declare_size(Context& context, const KeySyntax& key) {
  const IndexScope nothing(context.sizes);
  const auto value = evaluate_integer(key.value.expression, nothing, context.report);
  if (!value) return;
  (void)context.symbols.declare({key.key, {}, key.key_span}, SymbolKind::size, 0, context.report);
  context.sizes[key.key] = *value;  // even if the name is refused: indices may use the size
}

void override_size(Context& context, const KeySyntax& key) {
  const Sizes nothing;
  const auto value = evaluate_integer(key.value.expression, IndexScope(nothing), context.report);
  const auto found = context.sizes.find(key.key);
  if (found != context.sizes.end()) {
    found->second = value.value_or(found->second);
    return;
  }
  std::vector<std::string> names;
  for (const auto& [name, size] : context.sizes) names.push_back(name);
  context.report.add(Code::E605, key.key_span, "unknown size " + quote_text(key.key),
                     suggestion(key.key, names));
}

Assumption assumption_of(const ValueSyntax& table) {
  const std::string assumption = text_value(table, "assume");
  if (assumption == "positive") return Assumption::positive;
  return assumption == "nonnegative" ? Assumption::nonnegative : Assumption::none;
}

class ParameterReader {
 public:
  ParameterReader(Context& context, ParameterArray& array)
      : context_(context), array_(array), values_(context) {}

  void read(const ValueSyntax& value) {
    if (value.kind != ValueKind::table) {
      read_values(value);
      return;
    }
    array_.latex = text_value(value, "latex");
    array_.doc = text_value(value, "doc");
    read_parameter_unit(value);
    const Assumption assumption = assumption_of(value);
    for (std::uint32_t i = 0; i < array_.count; ++i) element(i).assumption = assumption;
    read_range(value);
    if (const KeySyntax* key = value.find("value")) read_values(key->value);
  }

 private:
  Parameter& element(std::uint32_t i) { return context_.model.parameters[array_.first + i]; }

  void read_parameter_unit(const ValueSyntax& table) {
    const KeySyntax* key = table.find("unit");
    if (key == nullptr) return;
    array_.unit_text = key->value.text;
    const KeySyntax* value = table.find("value");
    const std::optional<Unit> unit =
        read_unit(key->value, context_.report, value == nullptr ? nullptr : &value->value);
    for (std::uint32_t i = 0; i < array_.count; ++i) {
      if (context_.has_units) element(i).unit = unit;
    }
  }

  /// Stores `min` and `max` for check_parameter_value(). The range of the array needs both.
  void read_range(const ValueSyntax& table) {
    const KeySyntax* low = table.find("min");
    const KeySyntax* high = table.find("max");
    const auto end = [&](const KeySyntax* key) {
      return key == nullptr ? std::nullopt : values_.read_constant(key->value);
    };
    const auto minimum = end(low);
    const auto maximum = end(high);
    context_.bounds[element(0).array] = {minimum, maximum};
    if (!minimum || !maximum) return;
    if (*minimum > *maximum) {
      context_.report.add(Reason::empty_range, high->value.span,
                          in_backticks(high->value.span) + " is below `min`");
    } else {
      array_.range = Interval{*minimum, *maximum};
    }
  }

  void read_values(const ValueSyntax& value) {
    if (value.kind != ValueKind::list) {
      if (const auto number = values_.read_exact_constant(value, formula_hint)) {
        for (std::uint32_t i = 0; i < array_.count; ++i) set_element(i, *number, value.span);
      }
      return;
    }
    if (!array_.is_array || value.items.size() != array_.count) {
      context_.report.add(Reason::wrong_list_length, value.span,
                          count_text(value.items.size(), "value") + ", but " +
                              quote_text(array_.name) + " has " +
                              (array_.is_array ? "size " + std::to_string(array_.count)
                                               : std::string("no `size`")));
      return;
    }
    for (std::uint32_t i = 0; i < array_.count; ++i) {
      if (const auto number = values_.read_exact_constant(value.items[i], formula_hint)) {
        set_element(i, *number, value.items[i].span);
      }
    }
  }

  void set_element(std::uint32_t i, const FixedValue& value, const Span& span) {
    element(i).value = value.number;
    element(i).exact_expression = value.exact_expression;
    check_parameter_value(context_, array_.first + i, value.number, span);
  }

  Context& context_;
  ParameterArray& array_;
  ValueReader values_;
};

}  // namespace

void check_parameter_value(Context& context, std::uint32_t parameter, const cln::cl_R& value,
                           const Span& span) {
  const Parameter& row = context.model.parameters[parameter];
  const std::string name = quote_text(context.model.parameter_arrays[row.array].name);
  const bool needs_positive = row.assumption == Assumption::positive;
  const bool needs_nonnegative = row.assumption == Assumption::nonnegative;
  if ((needs_positive && value <= 0) || (needs_nonnegative && value < 0)) {
    context.report.add(Reason::contradicts_assumption, span,
                       in_backticks(span) + (needs_positive ? " is not positive" : " is negative") +
                           ", which `assume` of " + name + " rules out");
  }
  const ParameterBounds& bounds = context.bounds[row.array];
  if ((bounds.minimum && value < *bounds.minimum) || (bounds.maximum && value > *bounds.maximum)) {
    context.report.add(Code::E518, span,
                       in_backticks(span) + " is outside `min` or `max` of " + name);
  }
}

bool append_parameter_array(Context& context, const NewName& array, std::int64_t count,
                            bool is_array) {
  Model& model = context.model;
  ParameterArray declared;
  declared.name = array.base;
  declared.first = static_cast<std::uint32_t>(model.parameters.size());
  declared.count = static_cast<std::uint32_t>(count);
  declared.is_array = is_array;
  declared.span = array.span;
  model.parameter_arrays.push_back(std::move(declared));
  context.bounds.resize(model.parameter_arrays.size());
  // A refused name is reported once; the array still gets all its elements, since other code
  // indexes them.
  bool is_declared = true;
  for (std::int64_t i = 0; i < count; ++i) {
    const NewName name{array.base, is_array ? std::optional(i + 1) : std::nullopt, array.span};
    const auto target = static_cast<std::uint32_t>(model.parameters.size());
    Parameter element;
    element.name = name.text();
    element.identifier = name.identifier();
    element.array = static_cast<std::uint32_t>(model.parameter_arrays.size() - 1);
    element.element = static_cast<std::uint32_t>(i);
    model.parameters.push_back(std::move(element));
    is_declared =
        is_declared && context.symbols.declare(name, SymbolKind::parameter, target, context.report);
  }
  return is_declared;
}

void read_sizes(Context& context, const FileSyntax& model, const FileSyntax* scene,
                const SceneOptions& options) {
  for (const KeySyntax& key : entry_keys(&model, "sizes")) declare_size(context, key);
  for (const KeySyntax& key : entry_keys(scene, "sizes")) override_size(context, key);
  for (const KeySyntax& key : parse_option_keys(context, options.sizes, KeyType::expression)) {
    override_size(context, key);
  }
}

void declare_parameter(Context& context, const KeySyntax& key) {
  const KeySyntax* size = key.value.kind == ValueKind::table ? key.value.find("size") : nullptr;
  std::int64_t count = 1;
  if (size != nullptr) {
    const auto value =
        evaluate_integer(size->value.expression, IndexScope(context.sizes), context.report);
    if (!value) {
      context.symbols.mark_failed(key.key);
      return;
    }
    count = *value;
    if (count < 1) {
      context.symbols.mark_failed(key.key);
      context.report.add(Code::E209, size->value.span,
                         "the size is " + std::to_string(count) + ", so there is no element");
      return;
    }
    if (static_cast<std::uint64_t>(count) > context.limits.definitions) {
      context.is_beyond_limits = true;
      context.report.add(Code::E907, size->value.span,
                         std::to_string(count) + " elements, but the limit is " +
                             std::to_string(context.limits.definitions));
      return;
    }
  }
  (void)append_parameter_array(context, {key.key, {}, key.key_span}, count, size != nullptr);
}

std::vector<std::uint32_t> find_parameters(Context& context, const std::string& name,
                                           const Span& span, const std::string& hint) {
  const Model& model = context.model;
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < model.parameters.size(); ++i) {
    const Parameter& parameter = model.parameters[i];
    if (parameter.name == name || model.parameter_arrays[parameter.array].name == name) {
      found.push_back(i);
    }
  }
  if (found.empty()) {
    const std::vector<std::string> names = context.symbols.names({SymbolKind::parameter});
    context.report.add(Code::E602, span, "unknown parameter " + quote_text(name),
                       hint.empty() ? context.symbols.suggest(name, names) : hint);
  }
  return found;
}

void read_parameters(Context& context, const FileSyntax& syntax) {
  std::size_t next = 0;
  std::vector<ParameterArray>& arrays = context.model.parameter_arrays;
  for (const KeySyntax& key : entry_keys(&syntax, "parameters")) {
    if (next < arrays.size() && arrays[next].name == key.key) {
      ParameterReader(context, arrays[next++]).read(key.value);
    }
  }
}

}  // namespace elgen
