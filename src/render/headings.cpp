// headings: the equations of the output table once more, in LaTeX.
#include "headings.hpp"

#include <fmt/format.h>

#include "symbols.hpp"

namespace elgen::rendering {
namespace {

struct HeadingRow {
  OutputKind kind;
  const char* symbol;
  const char* definition;
};

/// In the order of the output table.
const HeadingRow heading_table[] = {
    {OutputKind::mass_matrix, "M", "M = \\frac{\\partial^{2} L}{\\partial \\dot{q}^{2}}"},
    {OutputKind::coriolis_matrix, "C",
     "C_{ij} = \\frac{1}{2} \\sum_{k} \\left( \\frac{\\partial M_{ij}}{\\partial q_{k}} + "
     "\\frac{\\partial M_{ik}}{\\partial q_{j}} - \\frac{\\partial M_{jk}}{\\partial q_{i}} "
     "\\right) \\dot{q}_{k}"},
    {OutputKind::velocity_force, "C \\dot{q}", ""},
    {OutputKind::gravity, "g", "g = \\frac{\\partial V_{0}}{\\partial q}"},
    {OutputKind::potential_energy, "V_{0}", "V_{0} = V(q, \\dot{q} = 0)"},
    {OutputKind::drift, "\\mathrm{drift}",
     "\\mathrm{drift} = \\frac{\\partial M}{\\partial t} \\dot{q} + "
     "\\left( \\frac{\\partial b}{\\partial q} - \\frac{\\partial b}{\\partial q}^{\\top} "
     "\\right) \\dot{q} + \\frac{\\partial b}{\\partial t} - "
     "\\frac{\\partial T_{0}}{\\partial q}"},
    {OutputKind::dissipation, "\\frac{\\partial D}{\\partial \\dot{q}}", ""},
    {OutputKind::applied_force, "Q", ""},
    {OutputKind::bias, "\\mathrm{bias}",
     "\\mathrm{bias} = C \\dot{q} + \\mathrm{drift} + g + "
     "\\frac{\\partial D}{\\partial \\dot{q}} - Q"},
    {OutputKind::momentum, "p", "p = \\frac{\\partial L}{\\partial \\dot{q}}"},
    {OutputKind::kinetic_energy, "T", ""},
    {OutputKind::total_energy, "T + V", "T + V = T + V_{0} + V_{1}^{\\top} \\dot{q}"},
    {OutputKind::energy_function, "E",
     "E = \\dot{q}^{\\top} \\frac{\\partial L}{\\partial \\dot{q}} - L"},
    {OutputKind::input_matrix, "B", "B = \\frac{\\partial Q}{\\partial u}"},
    {OutputKind::inverse_dynamics, "\\tau", "\\tau = M \\ddot{q} + \\mathrm{bias}"},
    {OutputKind::reaction, "r",
     "r = \\left[ \\frac{d}{dt} \\frac{\\partial L}{\\partial \\dot{q}} - "
     "\\frac{\\partial L}{\\partial q} + \\frac{\\partial D}{\\partial \\dot{q}} - Q - B u "
     "\\right]_{\\mathrm{locked}}"},
    {OutputKind::forward_dynamics, "\\ddot{q}", "M \\ddot{q} = B u - \\mathrm{bias}"},
    {OutputKind::linearization, "\\delta\\dot{x}",
     "\\delta\\dot{x} = A \\, \\delta x + B \\, \\delta u"},
    {OutputKind::inverse_dynamics_derivatives, "\\delta\\tau",
     "\\delta\\tau = \\frac{\\partial \\tau}{\\partial q} \\delta q + "
     "\\frac{\\partial \\tau}{\\partial \\dot{q}} \\delta\\dot{q} + M \\delta\\ddot{q}"},
    {OutputKind::forward_dynamics_derivatives, "\\delta\\ddot{q}",
     "\\delta\\ddot{q} = \\frac{\\partial \\ddot{q}}{\\partial q} \\delta q + "
     "\\frac{\\partial \\ddot{q}}{\\partial \\dot{q}} \\delta\\dot{q} + "
     "\\frac{\\partial \\ddot{q}}{\\partial u} \\delta u"},
    {OutputKind::coordinate_rates, "\\dot{q}", "\\dot{q} = N(q) v"},
    {OutputKind::normalized, "q", ""},
};

std::string sentence(const std::string& text) {
  const bool has_end = !text.empty() && (text.back() == '.' || text.back() == '!');
  return has_end ? text : text + ".";
}

}  // namespace

Heading heading(const Model& model, const Function& function) {
  for (const HeadingRow& row : heading_table) {
    if (row.kind == function.kind) return {row.symbol, row.definition};
  }
  if (function.kind == OutputKind::dynamics) return {"\\mathrm{dynamics}"};
  const Symbol symbol = latex_symbol(model.outputs[function.user].name);
  const std::string jacobian = fmt::format("\\frac{{\\partial {}}}{{\\partial q}}", symbol.text());
  if (function.kind == OutputKind::user_jacobian) return {jacobian};
  if (function.kind == OutputKind::user_value) return {symbol.text()};
  const std::string second = fmt::format("\\ddot{{{}}}{}", symbol.base, symbol.scripts);
  const std::string bias = fmt::format("\\mathrm{{bias}}_{{{}}}", symbol.text());
  return {bias, fmt::format("{} = {} \\ddot{{q}} + {}", second, jacobian, bias)};
}

std::string field_symbol(OutputKind kind, const Field& field) {
  if (field.name == "acceleration") return "\\ddot{q}";
  if (field.name == "relative_pivots") return "\\frac{D_{i}}{M_{ii}}";
  const bool is_inverse = kind == OutputKind::inverse_dynamics_derivatives;
  const char* above = is_inverse ? "\\tau" : "\\ddot{q}";
  if (field.name == "by_position")
    return fmt::format("\\frac{{\\partial {}}}{{\\partial q}}", above);
  if (field.name == "by_velocity") {
    return fmt::format("\\frac{{\\partial {}}}{{\\partial \\dot{{q}}}}", above);
  }
  if (field.name == "by_input") return fmt::format("\\frac{{\\partial {}}}{{\\partial u}}", above);
  return latex_symbol(field.name).text();
}

std::string output_doc(const Model& model, const Function& function) {
  const OutputRow& row = output_row(function.kind);
  if (row.unit != "user") return std::string(row.doc);
  const UserOutput& output = model.outputs[function.user];
  const std::string what = function.kind == OutputKind::user_value ? "Output"
                           : function.kind == OutputKind::user_jacobian
                               ? "Jacobian of output"
                               : "Bias of the second rate of output";
  return sentence(
      fmt::format("{} `{}`{}{}", what, output.name, output.doc.empty() ? "" : ": ", output.doc));
}

}  // namespace elgen::rendering
