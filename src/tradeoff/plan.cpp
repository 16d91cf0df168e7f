// plan: all combinations of the rows of a table, without those that do not exist. For a function of
// parameters and sines, in double and float:
//
//     scalar double, float   batch 1, packs   trigonometry full, 1e-7   parameters arguments, fixed
//     ->   10 designs: sines of 1e-7 are in packs of double alone
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "elgen/tradeoff.hpp"
#include "elgen/wording.hpp"
#include "emit/text/emission_checks.hpp"
#include "lower/code_interface.hpp"

namespace elgen {
namespace {

/// A value of a dimension.
struct DimensionRow {
  std::string_view dimension;
  std::string_view value;
  bool is_asked;  ///< there only where its dimension is named
  void (*choose)(Design&);
};

constexpr std::array dimension_rows{
    DimensionRow{"scalar", "double", false,
                 [](Design& d) { d.scalar = ScalarKind::double_precision; }},
    DimensionRow{"scalar", "float", false,
                 [](Design& d) { d.scalar = ScalarKind::single_precision; }},
    DimensionRow{"batch", "1", false, [](Design& d) { d.in_packs = false; }},
    DimensionRow{"batch", "packs", false, [](Design& d) { d.in_packs = true; }},
    DimensionRow{"trigonometry", "full", false, [](Design& d) { d.trigonometry = ""; }},
    DimensionRow{"trigonometry", "1e-7", false, [](Design& d) { d.trigonometry = "1e-7"; }},
    DimensionRow{"parameters", "arguments", false, [](Design& d) { d.is_fixed = false; }},
    DimensionRow{"parameters", "fixed", false, [](Design& d) { d.is_fixed = true; }},
    DimensionRow{"order", "exact", true, [](Design& d) { d.order = "exact"; }},
    DimensionRow{"order", "3", true, [](Design& d) { d.order = "3"; }},
    DimensionRow{"order", "1", true, [](Design& d) { d.order = "1"; }},
};

/// E631. Dimensions that are always there may be named too.
Diagnostics unknown_dimensions(const std::vector<std::string>& more) {
  std::vector<std::string> known;
  for (const DimensionRow& row : dimension_rows) {
    if (std::ranges::find(known, row.dimension) == known.end()) known.emplace_back(row.dimension);
  }
  Diagnostics found;
  for (const std::string& word : more) {
    if (std::ranges::find(known, word) != known.end()) continue;
    const std::string hint = suggestion(word, known);
    found.push_back({Code::E631,
                     {},
                     fmt::format("unknown dimension {}", in_backticks(word)),
                     hint.empty() ? fmt::format("one of {}", fmt::join(known, ", ")) : hint});
  }
  return found;
}

/// The properties of the model that decide which combinations exist.
class ExistingDesigns {
 public:
  ExistingDesigns(const CheckedModel& checked, const Program& program)
      : has_parameters_(emitted_parameter_count(checked.model, program) > 0),
        has_sines_(calls(program, FunctionId::sin) || calls(program, FunctionId::cos)),
        fits_float_(fits(checked.model, program, ScalarKind::single_precision)) {}

  [[nodiscard]] bool contain(const Design& design) const {
    const bool is_float = design.scalar == ScalarKind::single_precision;
    if (is_float && !fits_float_) return false;
    if (design.is_fixed && !has_parameters_) return false;
    // A float cannot be as good as 1e-7; and outside of packs there are no polynomials.
    return design.trigonometry.empty() || (design.in_packs && !is_float && has_sines_);
  }

 private:
  bool has_parameters_;
  bool has_sines_;
  bool fits_float_;
};

/// Every design by every value of one more dimension.
std::vector<PlannedDesign> multiplied(const std::vector<PlannedDesign>& designs,
                                      const std::vector<DimensionRow>& values) {
  std::vector<PlannedDesign> result;
  for (const PlannedDesign& planned : designs) {
    for (const DimensionRow& row : values) {
      PlannedDesign more = planned;
      more.values.emplace_back(row.value);
      row.choose(more.design);
      result.push_back(std::move(more));
    }
  }
  return result;
}

/// Columns in which all designs are alike go.
void leave_out_constant_dimensions(TradeoffPlan& plan) {
  for (std::size_t i = plan.dimensions.size(); i-- > 0;) {
    const auto is_first = [&](const PlannedDesign& design) {
      return design.values[i] == plan.designs.front().values[i];
    };
    if (!std::ranges::all_of(plan.designs, is_first)) continue;
    const auto at = static_cast<std::ptrdiff_t>(i);
    plan.dimensions.erase(plan.dimensions.begin() + at);
    for (PlannedDesign& design : plan.designs) design.values.erase(design.values.begin() + at);
  }
}

}  // namespace

Result<TradeoffPlan> plan(const CheckedModel& checked, const Program& program,
                          const std::vector<std::string>& more) {
  const Diagnostics unknown = unknown_dimensions(more);
  if (!unknown.empty()) return unknown;
  TradeoffPlan plan{{}, {PlannedDesign{}}};
  for (std::size_t i = 0; i < dimension_rows.size();) {
    const std::string_view dimension = dimension_rows[i].dimension;
    std::vector<DimensionRow> values;
    for (; i < dimension_rows.size() && dimension_rows[i].dimension == dimension; ++i) {
      const bool is_named = std::ranges::find(more, dimension) != more.end();
      if (is_named || !dimension_rows[i].is_asked) values.push_back(dimension_rows[i]);
    }
    if (values.empty()) continue;
    plan.dimensions.emplace_back(dimension);
    plan.designs = multiplied(plan.designs, values);
  }
  const ExistingDesigns existing(checked, program);
  std::erase_if(plan.designs,
                [&](const PlannedDesign& planned) { return !existing.contain(planned.design); });
  leave_out_constant_dimensions(plan);
  return plan;
}

Design derivation_of(const Design& design) {
  return {.is_fixed = design.is_fixed, .order = design.order};
}

}  // namespace elgen
