// base_parameters_page: an equation for each base parameter, in the inertial parameters of the
// regressor.
#include <fmt/format.h>

#include "elgen/analysis_pages.hpp"
#include "model/symbols.hpp"
#include "numbers/exact_number.hpp"
#include "print/analyses/page_parts.hpp"

namespace elgen {
namespace {

/// Symbols of inertial parameters. The symbol of hand.Ixx is I with its axes and then its owner as
/// indices; parameters of the model have their own symbols.
class ParameterSymbols {
 public:
  explicit ParameterSymbols(const Model& model)
      : model_(model), of_model_(ModelSymbols(model).leaves().parameters) {}

  [[nodiscard]] Formula of(const InertialParameter& parameter) const {
    switch (parameter.owner) {
      case InertialOwner::parameter:
        return of_model_[parameter.index];
      case InertialOwner::coordinate:
        return apply_to_owner(parameter, "J", model_.coordinates[parameter.index].name);
      case InertialOwner::point:
        return apply_to_owner(parameter, "m", model_.points[parameter.index].name);
      case InertialOwner::body:
        break;
    }
    const std::string& body = model_.bodies[parameter.index].name;
    return apply_to_owner(parameter, parameter.name.substr(body.size() + 1), body);
  }

 private:
  [[nodiscard]] static Formula apply_to_owner(const InertialParameter& parameter,
                                              const std::string& component,
                                              const std::string& owner) {
    return symbol_formula(parameter.name, symbol_of_name(component + "_" + owner));
  }

  const Model& model_;
  Formulas of_model_;
};

Formula number(const cln::cl_R& factor) {
  return is_rational(factor) ? number_formula(cln::the<cln::cl_RA>(factor)) : six_digits(factor);
}

Formula term(const WeightedParameter& weighed, Formula symbol) {
  if (weighed.factor == 1) return symbol;
  if (weighed.factor == -1) return negative(std::move(symbol));
  const bool is_negative = cln::minusp(weighed.factor);
  Formula product = product_of({number(cln::abs(weighed.factor)), std::move(symbol)});
  return is_negative ? negative(std::move(product)) : product;
}

Formula combination(const BaseParameter& base, const Formulas& symbols) {
  Formulas terms{symbols[base.parameter]};
  for (const WeightedParameter& other : base.others) {
    terms.push_back(term(other, symbols[other.parameter]));
  }
  return sum_of(std::move(terms));
}

std::string claim_of(const BaseParameters& found) {
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
  for (const InertialParameter& each : found.parameters) symbols.push_back(known.of(each));
  PageSection& section = page.sections.emplace_back();
  PageTable values{.heads = {prose(""), prose("value"), prose("unit")}};
  for (std::size_t k = 0; k < found.base.size(); ++k) {
    const std::string number = std::to_string(k + 1);
    const Formula left = symbol("beta[" + number + "]", "\\beta_{" + number + "}");
    section.equations.push_back({.left = left, .entries = {combination(found.base[k], symbols)}});
    const auto& unit = found.parameters[found.base[k].parameter].unit;
    values.cells.insert(values.cells.end(), {left, six_digits(found.base[k].value),
                                             prose(unit ? to_string(*unit) : "")});
  }
  page.sections.push_back({.title = prose("Values"), .table = std::move(values)});
  Formulas unseen;
  for (const std::uint32_t k : found.without_effect) {
    unseen.push_back(symbols[k]);
  }
  if (!unseen.empty()) {
    page.sections.push_back(
        {.title = prose("Parameters without effect"), .lines = {list_of(std::move(unseen))}});
  }
  page.sections.push_back({.doc = claim_of(found)});
  return page;
}

}  // namespace elgen
