// base_parameters_page: an equation for each base parameter, in the names of the regressor.
#include <fmt/format.h>

#include "elgen/analysis_pages.hpp"
#include "model/symbols.hpp"
#include "numbers/exact_number.hpp"
#include "print/analyses/page_parts.hpp"

namespace elgen {
namespace {

/// hand.Ixx as I with indices: its component, then its owner.
Formula symbol_of(const InertialParameter& parameter) {
  const std::size_t dot = parameter.name.rfind('.');
  const std::string written =
      dot == std::string::npos ? parameter.name
      : parameter.name.starts_with("armature.")
          ? "J_" + parameter.name.substr(9)
          : fmt::format("{}_{}", parameter.name.substr(dot + 1), parameter.name.substr(0, dot));
  return symbol_formula(parameter.name, symbol_of_name(written));
}

Formula number(const cln::cl_R& factor) {
  return is_rational(factor) ? number_formula(cln::the<cln::cl_RA>(factor)) : six_digits(factor);
}

Formula term(const WeighedParameter& weighed, const BaseParameters& found) {
  Formula symbol = symbol_of(found.parameters[weighed.parameter]);
  if (weighed.factor == 1) return symbol;
  if (weighed.factor == -1) return negative(std::move(symbol));
  const bool is_negative = cln::minusp(weighed.factor);
  Formula product = product_of({number(cln::abs(weighed.factor)), std::move(symbol)});
  return is_negative ? negative(std::move(product)) : product;
}

Formula combination(const BaseParameter& base, const BaseParameters& found) {
  Formulas terms{symbol_of(found.parameters[base.parameter])};
  for (const WeighedParameter& other : base.others) terms.push_back(term(other, found));
  return sum_of(std::move(terms));
}

std::string claim_of(const BaseParameters& found) {
  return fmt::format("rank {} of {}: {}, at {} random states and the values of the geometry",
                     found.base.size(), found.parameters.size(),
                     found.is_exact ? "exact over a field of 2^521 - 1 elements" : "in 160 digits",
                     found.states);
}

}  // namespace

Page base_parameters_page(const CheckedModel& checked, const BaseParameters& found) {
  Page page{.title = titled(checked, "base inertial parameters")};
  PageSection& section = page.sections.emplace_back();
  PageTable values{.heads = {prose(""), prose("value"), prose("unit")}};
  for (std::size_t k = 0; k < found.base.size(); ++k) {
    const std::string number = std::to_string(k + 1);
    const Formula left = symbol("beta[" + number + "]", "\\beta_{" + number + "}");
    section.equations.push_back({.left = left, .entries = {combination(found.base[k], found)}});
    const auto& unit = found.parameters[found.base[k].parameter].unit;
    values.cells.insert(values.cells.end(), {left, six_digits(found.base[k].value),
                                             prose(unit ? to_string(*unit) : "")});
  }
  page.sections.push_back({.title = prose("Values"), .table = std::move(values)});
  Formulas unseen;
  for (const std::uint32_t k : found.without_effect) {
    unseen.push_back(symbol_of(found.parameters[k]));
  }
  if (!unseen.empty()) {
    page.sections.push_back(
        {.title = prose("Without effect"), .lines = {list_of(std::move(unseen))}});
  }
  page.sections.push_back({.doc = claim_of(found)});
  return page;
}

}  // namespace elgen
