// plan: combines all values of all dimensions, and removes combinations that do not exist. Example:
// a function of parameters and sines, in double and float, if the command names `trigonometry`:
//
//     scalar double, float   batch one, packs   trigonometry full, 4e-16, 1e-7, library
//     parameters arguments, fixed   form chosen, typed
//     ->   17 designs: sines of 4e-16 exist only for one state in double, sines of 1e-7 only in
//          packs of double, sines of the library only for one state. Only the first of the other 16
//          designs is also tried as typed.
#include <cln/rational.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "elgen/emitted_files.hpp"
#include "elgen/syntax.hpp"
#include "elgen/tradeoff.hpp"
#include "elgen/wording.hpp"
#include "emit/interface/code_interface.hpp"
#include "program/evaluate/sine_calls.hpp"

namespace elgen {
namespace {

/// A dimension, and the entry and key by which a scene sets its value.
struct DimensionRow {
  std::string_view name;
  std::string_view entry;
  std::string_view key;
  bool is_optional;  ///< used only if the command names the dimension or pins a value
  std::string_view doc;
};

constexpr std::string_view form_dimension = "form";

/// The value of `trigonometry` for lone sines by one polynomial, with its least error.
constexpr const char* lone_sines = "4e-16";

constexpr std::array dimension_rows{
    DimensionRow{"scalar", "numeric", "scalar", false, "try only this scalar"},
    DimensionRow{"batch", "emit", "batch", false, "try only one state per call, or only packs"},
    DimensionRow{"trigonometry", "numeric", "trigonometry", false,
                 "try only sines of this accuracy, or only the library's"},
    DimensionRow{"parameters", "parameters", "fixed", false,
                 "try parameters only as arguments, or only fixed"},
    DimensionRow{"inner", "numeric", "inner", true,
                 "try only this scalar between arguments and results in double"},
    DimensionRow{"order", "approximate", "order", true, "try only this order of an expansion"},
    DimensionRow{form_dimension, "numeric", "form", false,
                 "try only the form that elgen chooses, or only the text as typed"}};

/// A value of a dimension. `is_compatible`: true if the value does not contradict a scene that sets
/// the key.
struct DimensionValueRow {
  std::string_view dimension;
  std::string_view value;
  void (*apply)(Design&);
  bool (*is_compatible)(const CheckedModel&);
  bool is_optional = false;  ///< tried only if the command pins it or names its dimension
};

bool has_scalar(const CheckedModel& base, ScalarKind scalar) {
  return std::ranges::count(base.scene.numerics.scalars, scalar) > 0;
}

bool has_order(const CheckedModel& base, std::uint32_t order) {
  return base.model.approximation && base.model.approximation->order == order;
}

template <InnerScalar inner>
constexpr DimensionValueRow inner_value_row() {
  return {"inner", inner_scalar_row(inner).name, [](Design& d) { d.inner = inner; },
          [](const CheckedModel& base) { return base.scene.numerics.inner == inner; }};
}

constexpr std::array value_rows{
    DimensionValueRow{
        "scalar", "double", [](Design& d) { d.scalar = ScalarKind::double_precision; },
        [](const CheckedModel& base) { return has_scalar(base, ScalarKind::double_precision); }},
    DimensionValueRow{
        "scalar", "float", [](Design& d) { d.scalar = ScalarKind::single_precision; },
        [](const CheckedModel& base) { return has_scalar(base, ScalarKind::single_precision); }},
    DimensionValueRow{
        "batch", "one", [](Design& d) { d.in_packs = false; },
        [](const CheckedModel& base) { return !base.scene.emission.has_batch_header; }},
    DimensionValueRow{
        "batch", "packs", [](Design& d) { d.in_packs = true; },
        [](const CheckedModel& base) { return base.scene.emission.has_batch_header; }},
    DimensionValueRow{"trigonometry", "full", [](Design& d) { d.trigonometry = ""; },
                      [](const CheckedModel& base) {
                        const Numerics& numerics = base.scene.numerics;
                        return !numerics.trigonometry_error && !numerics.has_library_sines;
                      }},
    DimensionValueRow{"trigonometry", lone_sines, [](Design& d) { d.trigonometry = lone_sines; },
                      [](const CheckedModel& base) {
                        return base.scene.numerics.trigonometry_error ==
                               least_lone_sine_error(ScalarKind::double_precision);
                      },
                      true},
    DimensionValueRow{"trigonometry", "1e-7", [](Design& d) { d.trigonometry = "1e-7"; },
                      [](const CheckedModel& base) {
                        return base.scene.numerics.trigonometry_error == cln::cl_RA(1) / 10'000'000;
                      },
                      true},
    DimensionValueRow{
        "trigonometry", library_sines, [](Design& d) { d.trigonometry = library_sines; },
        [](const CheckedModel& base) { return base.scene.numerics.has_library_sines; }, true},
    DimensionValueRow{"parameters", "arguments", [](Design& d) { d.is_fixed = false; },
                      [](const CheckedModel& base) {
                        return base.scene.specialisation.fixed.size() <
                               base.model.parameters.size();
                      }},
    DimensionValueRow{"parameters", "fixed", [](Design& d) { d.is_fixed = true; },
                      [](const CheckedModel&) { return true; }},
    inner_value_row<InnerScalar::same>(),
    inner_value_row<InnerScalar::long_double>(),
    inner_value_row<InnerScalar::double_double>(),
    DimensionValueRow{"order", "exact", [](Design& d) { d.order = "exact"; },
                      [](const CheckedModel& base) { return !base.model.approximation; }},
    DimensionValueRow{"order", "3", [](Design& d) { d.order = "3"; },
                      [](const CheckedModel& base) { return has_order(base, 3); }},
    DimensionValueRow{"order", "1", [](Design& d) { d.order = "1"; },
                      [](const CheckedModel& base) { return has_order(base, 1); }},
    DimensionValueRow{form_dimension, "chosen", [](Design& d) { d.is_typed = false; },
                      [](const CheckedModel&) { return true; }},
    DimensionValueRow{form_dimension, "typed", [](Design& d) { d.is_typed = true; },
                      [](const CheckedModel& base) {
                        return base.scene.outputs.front().form == Form::recursive;
                      }},
};

/// E631 for each unknown name. A command may also name dimensions that are used by default.
Diagnostics check_dimension_names(const std::vector<std::string>& more) {
  const std::vector<std::string> known = column_words(dimension_rows, &DimensionRow::name);
  Diagnostics found;
  for (const std::string& word : more) {
    if (std::ranges::find(known, word) != known.end()) continue;
    found.push_back({Code::E631,
                     {},
                     fmt::format("unknown dimension {}", quote_text(word)),
                     suggestion(word, known, fmt::format("one of {}", fmt::join(known, ", ")))});
  }
  return found;
}

/// Decides which combinations exist for a model and a program.
class DesignFilter {
 public:
  DesignFilter(const CheckedModel& checked, const Program& program)
      : has_parameters_(emitted_parameter_count(checked.model, program) > 0),
        has_sines_(calls_function(program, FunctionId::sin) ||
                   calls_function(program, FunctionId::cos)),
        has_lone_sines_(has_lone_sine_calls(program, SineCosinePairing::grouped)),
        fits_float_(literals_fit(checked.model, program, ScalarKind::single_precision)),
        varies_parameters_(!checked.scene.numerics.varied_parameters.empty()) {}

  /// Why the design does not exist; "" if it exists.
  [[nodiscard]] const char* missing_reason(const Design& design) const {
    const bool is_float = design.scalar == ScalarKind::single_precision;
    if (is_float && !fits_float_) return "a number of the output does not fit float";
    if (design.is_fixed && !has_parameters_)
      return "the output has no parameter that could be fixed";
    if (design.is_fixed && varies_parameters_) return "`--over` varies parameters";
    if (design.inner != InnerScalar::same && (is_float || design.in_packs)) {
      return "a wider scalar needs functions of one state in double";
    }
    if (design.trigonometry.empty()) return "";
    if (!has_sines_) return "the output has no sine and no cosine";
    if (design.trigonometry == library_sines) {
      const bool is_plain = design.inner == InnerScalar::same && !design.in_packs;
      return is_plain ? "" : "packs and wider scalars use their own sines";
    }
    if (design.trigonometry != lone_sines) {
      // Float is not accurate to 1e-7.
      return design.in_packs && !is_float ? "" : "only packs of double have sines of this accuracy";
    }
    if (is_float) return "float is not as accurate as this";
    if (design.in_packs || design.inner != InnerScalar::same)
      return "packs and wider scalars use their own sines";
    return has_lone_sines_ ? "" : "no function of the output computes a sine alone";
  }

 private:
  bool has_parameters_;
  bool has_sines_;
  bool has_lone_sines_;  ///< in C++, in which designs are compiled
  bool fits_float_;
  bool varies_parameters_;
};

const PinnedDimension* find_pin(const std::vector<PinnedDimension>& pinned,
                                std::string_view dimension) {
  const auto found = std::ranges::find(pinned, dimension, &PinnedDimension::name);
  return found == pinned.end() ? nullptr : &*found;
}

/// The option that pins the value: "`--scalar float`".
std::string option_text(const PinnedDimension& pin) {
  return fmt::format("`--{} {}`", pin.name, pin.value);
}

/// E645: no design has all pinned values.
Diagnostics no_design_error(const std::vector<PinnedDimension>& pinned, const char* why) {
  const std::vector<std::string> options = column_words(pinned, option_text);
  return {{Code::E645, {}, fmt::format("no design fits {}", fmt::join(options, ", ")), why}};
}

/// The pinned value if there is one; otherwise all values if the dimension is named, or else the
/// default values.
std::vector<DimensionValueRow> values_to_try(const DimensionRow& dimension,
                                             const DesignChoices& choices) {
  const PinnedDimension* const pin = find_pin(choices.pinned, dimension.name);
  const bool is_named = std::ranges::find(choices.more, dimension.name) != choices.more.end();
  std::vector<DimensionValueRow> values;
  for (const DimensionValueRow& row : value_rows) {
    const bool is_tried = is_named || !(dimension.is_optional || row.is_optional);
    const bool is_chosen = pin == nullptr ? is_tried : row.value == pin->value;
    if (row.dimension == dimension.name && is_chosen) values.push_back(row);
  }
  return values;
}

/// Each design, combined with each value of another dimension.
std::vector<PlannedDesign> combine_designs(const std::vector<PlannedDesign>& designs,
                                           const std::vector<DimensionValueRow>& values) {
  std::vector<PlannedDesign> result;
  for (const PlannedDesign& planned : designs) {
    for (const DimensionValueRow& row : values) {
      PlannedDesign more = planned;
      more.values.emplace_back(row.value);
      row.apply(more.design);
      result.push_back(std::move(more));
    }
  }
  return result;
}

/// Removes all designs as typed except the first, unless the command names or pins `form`.
void limit_typed_designs(std::vector<PlannedDesign>& designs, const DesignChoices& choices) {
  const bool is_named = std::ranges::find(choices.more, form_dimension) != choices.more.end();
  if (is_named || find_pin(choices.pinned, form_dimension) != nullptr) return;
  bool has_typed = false;
  std::erase_if(designs, [&has_typed](const PlannedDesign& planned) {
    return planned.design.is_typed && std::exchange(has_typed, true);
  });
}

/// Removes each dimension that is not pinned and in which all designs have the same value.
void remove_constant_dimensions(TradeoffPlan& plan, const std::vector<PinnedDimension>& pinned) {
  for (std::size_t i = plan.dimensions.size(); i-- > 0;) {
    const auto is_first = [&](const PlannedDesign& design) {
      return design.values[i] == plan.designs.front().values[i];
    };
    const bool is_pinned = find_pin(pinned, plan.dimensions[i]) != nullptr;
    if (is_pinned || !std::ranges::all_of(plan.designs, is_first)) continue;
    const auto at = static_cast<std::ptrdiff_t>(i);
    plan.dimensions.erase(plan.dimensions.begin() + at);
    for (PlannedDesign& design : plan.designs) design.values.erase(design.values.begin() + at);
  }
}

}  // namespace

std::vector<DesignDimension> design_dimensions() {
  std::vector<DesignDimension> dimensions;
  for (const DimensionRow& row : dimension_rows) {
    DesignDimension& dimension =
        dimensions.emplace_back(DesignDimension{std::string(row.name), std::string(row.doc)});
    for (const DimensionValueRow& value : value_rows) {
      if (value.dimension == row.name) dimension.values.emplace_back(value.value);
    }
  }
  return dimensions;
}

Diagnostics scene_conflicts(const DesignSource& base, const std::vector<PinnedDimension>& pinned) {
  Diagnostics found;
  for (const DimensionRow& dimension : dimension_rows) {
    const PinnedDimension* const pin = find_pin(pinned, dimension.name);
    const KeySyntax* const key = find_key(base.scene, dimension.entry, dimension.key);
    if (pin == nullptr || key == nullptr) continue;
    for (const DimensionValueRow& row : value_rows) {
      const bool is_pinned = row.dimension == dimension.name && row.value == pin->value;
      if (!is_pinned || row.is_compatible(base.checked)) continue;
      found.push_back({Code::E644, key->value.span,
                       fmt::format("{} contradicts the scene", option_text(*pin)),
                       "remove one of the two"});
    }
  }
  return found;
}

Result<TradeoffPlan> plan_designs(const CheckedModel& checked, const Program& program,
                                  const DesignChoices& choices) {
  const Diagnostics unknown = check_dimension_names(choices.more);
  if (!unknown.empty()) return unknown;
  TradeoffPlan plan{{}, {PlannedDesign{}}};
  for (const DimensionRow& dimension : dimension_rows) {
    const std::vector<DimensionValueRow> values = values_to_try(dimension, choices);
    if (values.empty()) continue;
    plan.dimensions.emplace_back(dimension.name);
    plan.designs = combine_designs(plan.designs, values);
  }
  const DesignFilter existing(checked, program);
  const char* const why = existing.missing_reason(plan.designs.front().design);
  std::erase_if(plan.designs, [&](const PlannedDesign& planned) {
    return !std::string_view(existing.missing_reason(planned.design)).empty();
  });
  if (plan.designs.empty()) return no_design_error(choices.pinned, why);
  limit_typed_designs(plan.designs, choices);
  remove_constant_dimensions(plan, choices.pinned);
  return plan;
}

Design derivation_key(const Design& design) {
  return {.is_fixed = design.is_fixed, .is_typed = design.is_typed, .order = design.order};
}

}  // namespace elgen
