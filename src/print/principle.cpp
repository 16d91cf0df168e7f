// principle: see principle.hpp. `<q>` is a vector.
#include "print/principle.hpp"

#include <fmt/ranges.h>

#include <array>
#include <string_view>

#include "elgen/references.hpp"

namespace elgen {
namespace {

/// S, its variation, the integration by parts, and the boundary terms.
constexpr std::array<std::string_view, 4> variation_lines{
    R"(S = \int L dt)",
    R"({\delta} S = \int \left( \frac{\partial L}{\partial <q>} \cdot {\delta} <q> + )"
    R"(\frac{\partial L}{\partial <v>} \cdot \frac{d}{dt} {\delta} <q> \right) dt)",
    R"({\delta} S = \int \left( \frac{\partial L}{\partial <q>} - )"
    R"(\frac{d}{dt} \frac{\partial L}{\partial <v>} \right) \cdot {\delta} <q> dt + )"
    R"(\left[ \frac{\partial L}{\partial <v>} \cdot {\delta} <q> \right] \text{ by parts})",
    R"(\left[ \frac{\partial L}{\partial <v>} \cdot {\delta} <q> \right] = 0 )"
    R"(\text{, as } {\delta} <q> = <0> \text{ at both ends})"};

constexpr std::string_view applied_force = "<Q>";
constexpr std::string_view damping_force = R"(\frac{\partial D}{\partial <v>})";
constexpr std::string_view constraint_force = R"(A^{\top} <lambda>)";

bool is_damped(const Model& model) { return !dissipation_roots(model).empty(); }

/// Q - dD/dv + A^T lambda.
struct VirtualForce {
  std::string text = {};
  bool is_single = false;  ///< true: one term without a sign
};

VirtualForce virtual_force(const Model& model) {
  VirtualForce result;
  std::size_t count = 0;
  const auto add = [&](bool exists, std::string_view sign, std::string_view term) {
    if (!exists) return;
    const bool is_first = count++ == 0;
    if (!is_first) result.text += fmt::format(" {} ", sign);
    if (is_first && sign == "-") result.text += sign;
    result.text += term;
  };
  add(has_applied_force(model), "+", applied_force);
  add(is_damped(model), "-", damping_force);
  add(!model.constraints.empty(), "+", constraint_force);
  result.is_single = count == 1 && !result.text.starts_with('-');
  return result;
}

/// The virtual work of forces and constraints (d'Alembert).
std::string virtual_work(const Model& model) {
  const VirtualForce force = virtual_force(model);
  const bool has_forces = has_applied_force(model) || is_damped(model);
  const char* const origin = model.constraints.empty() ? "forces"
                             : has_forces              ? "forces and constraints"
                                                       : "constraints";
  const char* const pattern = force.is_single
                                  ? R"({{\delta}} W = {} \cdot {{\delta}} <q>)"
                                  : R"({{\delta}} W = \left( {} \right) \cdot {{\delta}} <q>)";
  return fmt::format(fmt::runtime(pattern), force.text) +
         fmt::format(R"( \text{{ is the virtual work of {} (d'Alembert)}})", origin);
}

}  // namespace

bool has_applied_force(const Model& model) {
  return !model.forces.empty() || !model.inputs.empty();
}

bool is_free(const Model& model) {
  return !has_applied_force(model) && !is_damped(model) && model.constraints.empty();
}

std::vector<std::string> principle_lines(const Model& model) {
  std::vector<std::string> lines(variation_lines.begin(), variation_lines.end());
  if (!is_free(model)) lines.push_back(virtual_work(model));
  const char* const balance =
      is_free(model) ? R"({\delta} S = 0)" : R"({\delta} S + \int {\delta} W dt = 0)";
  lines.push_back(fmt::format(R"({} \text{{ for every }} {{\delta}} <q> \text{{, so }} {})",
                              balance, lagrange_equation(model)));
  return lines;
}

std::string lagrange_equation(const Model& model) {
  std::string equation =
      R"(\frac{d}{dt} \frac{\partial L}{\partial <v>} - \frac{\partial L}{\partial <q>})";
  if (is_damped(model)) equation += fmt::format(" + {}", damping_force);
  std::vector<std::string_view> right;
  if (has_applied_force(model)) right.push_back(applied_force);
  if (!model.constraints.empty()) right.push_back(constraint_force);
  if (right.empty()) right.emplace_back("<0>");
  return fmt::format("{} = {}", equation, fmt::join(right, " + "));
}

std::string energy_rate(const Model& model, bool is_autonomous) {
  const VirtualForce force = virtual_force(model);
  std::string right = force.text.empty() ? ""
                      : force.is_single
                          ? fmt::format(R"(<v>^{{\top}} {})", force.text)
                          : fmt::format(R"(<v>^{{\top}} \left( {} \right))", force.text);
  if (!is_autonomous) {
    right += fmt::format(R"({}\frac{{\partial L}}{{\partial t}})", right.empty() ? "-" : " - ");
  }
  return fmt::format(R"(\frac{{dE}}{{dt}} = {})", right.empty() ? "0" : right);
}

std::string energy_conservation(const Model& model) {
  std::vector<std::string_view> origins;
  if (has_applied_force(model)) origins.emplace_back("forces");
  if (is_damped(model)) origins.emplace_back("dissipation");
  if (!model.constraints.empty()) origins.emplace_back("constraints");
  if (origins.empty()) return "is conserved";
  std::string names(origins.front());
  for (std::size_t i = 1; i < origins.size(); ++i) {
    names += fmt::format("{}{}", i + 1 == origins.size() ? " and " : ", ", origins[i]);
  }
  const bool is_singular = origins.size() == 1 && origins.front() == "dissipation";
  return fmt::format("is conserved if {} {} no work", names, is_singular ? "does" : "do");
}

}  // namespace elgen
