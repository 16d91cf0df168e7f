// base_parameters_page: an equation for each base parameter, in the inertial parameters of the
// regressor.
#include <fmt/format.h>

#include "elgen/analysis_pages.hpp"
#include "model/symbols.hpp"
#include "numbers/exact_number.hpp"
#include "print/analyses/page_parts.hpp"

namespace elgen {
namespace {

/// Symbols of inertial parameters. The symbol of hand.Ixx is I with the indices xx and hand;
/// parameters of the model have their own symbols.
class ParameterSymbols {
 public:
  explicit ParameterSymbols(const Model& model)
      : model_(model), of_model_(ModelSymbols(model).leaf_symbols().parameters) {}

  [[nodiscard]] Formula symbol_of(const InertialParameter& parameter) const {
    switch (parameter.owner) {
      case InertialOwner::parameter:
        return of_model_[parameter.index];
      case InertialOwner::coordinate:
        return owner_symbol(parameter, "J", model_.coordinates[parameter.index].name);
      case InertialOwner::point:
        return owner_symbol(parameter, "m", model_.points[parameter.index].name);
      case InertialOwner::body:
        break;
    }
    const std::string& body = model_.bodies[parameter.index].name;
    return owner_symbol(parameter, parameter.name.substr(body.size() + 1), body);
  }

 private:
  [[nodiscard]] static Formula owner_symbol(const InertialParameter& parameter,
                                            const std::string& component,
                                            const std::string& owner) {
    return symbol_formula(parameter.name, symbol_of_name(component + "_" + owner));
  }

  const Model& model_;
  Formulas of_model_;
};

Formula factor_formula(const cln::cl_R& factor) {
  return is_rational(factor) ? number_formula(cln::the<cln::cl_RA>(factor))
                             : six_digit_formula(factor);
}

Formula weighted_term(const WeightedParameter& weighed, Formula symbol) {
  if (weighed.factor == 1) return symbol;
  if (weighed.factor == -1) return negative_of(std::move(symbol));
  const bool is_negative = cln::minusp(weighed.factor);
  Formula product = product_of({factor_formula(cln::abs(weighed.factor)), std::move(symbol)});
  return is_negative ? negative_of(std::move(product)) : product;
}

Formula base_parameter_formula(const BaseParameter& base, const Formulas& symbols) {
  Formulas terms{symbols[base.parameter]};
  for (const WeightedParameter& other : base.regrouped_terms) {
    terms.push_back(weighted_term(other, symbols[other.parameter]));
  }
  return sum_of(std::move(terms));
}

std::string rank_claim(const BaseParameters& found) {
  return fmt::format("rank {} of {}: {}, at {} random states with the file's geometry",
                     found.base.size(), found.parameters.size(),
                     found.is_exact ? "exact over a field of 2^521 - 1 elements" : "in 160 digits",
                     found.states);
}

}  // namespace

Page base_parameters_page(const CheckedModel& checked, const BaseParameters& found) {
  Page page{.title = analysis_title(checked, "base inertial parameters")};
  const ParameterSymbols known(checked.model);
  Formulas symbols;
  for (const InertialParameter& each : found.parameters) symbols.push_back(known.symbol_of(each));
  PageSection& section = page.sections.emplace_back();
  PageTable values{.heads = {prose(""), prose("value"), prose("unit")}};
  for (std::size_t k = 0; k < found.base.size(); ++k) {
    const std::string number = std::to_string(k + 1);
    const Formula left = latex_symbol("beta[" + number + "]", "\\beta_{" + number + "}");
    section.equations.push_back(
        {.left = left, .entries = {base_parameter_formula(found.base[k], symbols)}});
    const auto& unit = found.parameters[found.base[k].parameter].unit;
    values.cells.insert(values.cells.end(), {left, six_digit_formula(found.base[k].value),
                                             prose(unit ? to_string(*unit) : "")});
  }
  page.sections.push_back({.title = prose("Values"), .table = std::move(values)});
  Formulas unseen;
  for (const std::uint32_t k : found.unidentifiable) {
    unseen.push_back(symbols[k]);
  }
  if (!unseen.empty()) {
    page.sections.push_back(
        {.title = prose("Parameters without effect"), .lines = {list_of(std::move(unseen))}});
  }
  page.sections.push_back({.doc = rank_claim(found)});
  return page;
}

}  // namespace elgen
