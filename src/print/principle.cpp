// principle: Hamilton's and d'Alembert's principle (steps.hpp). `<q>` is a vector.
#include <fmt/ranges.h>

#include <array>
#include <string_view>
#include <utility>

#include "elgen/references.hpp"
#include "print/steps.hpp"

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
constexpr std::string_view explicit_rate = R"(\frac{\partial L}{\partial t})";

bool is_damped(const Model& model) { return !dissipation_roots(model).empty(); }

/// Q - dD/dv + A^T lambda, in brackets unless it is one term without a sign; "" without terms.
std::string virtual_force(const Model& model) {
  std::string text;
  if (has_applied_force(model)) text = applied_force;
  if (is_damped(model)) text += (text.empty() ? "-" : " - ") + std::string(damping_force);
  if (!model.constraints.empty())
    text += (text.empty() ? "" : " + ") + std::string(constraint_force);
  const bool is_plain = text.empty() || text == applied_force || text == constraint_force;
  return is_plain ? text : fmt::format(R"(\left( {} \right))", text);
}

/// The virtual work of forces and constraints (d'Alembert).
std::string virtual_work(const Model& model) {
  const bool has_forces = has_applied_force(model) || is_damped(model);
  const char* const origin = model.constraints.empty() ? "forces"
                             : has_forces              ? "forces and constraints"
                                                       : "constraints";
  return fmt::format(R"({{\delta}} W = {} \cdot {{\delta}} <q> )"
                     R"(\text{{ is the virtual work of {} (d'Alembert)}})",
                     virtual_force(model), origin);
}

}  // namespace

bool has_applied_force(const Model& model) {
  return !model.forces.empty() || !model.inputs.empty();
}

std::vector<std::string> principle_lines(const Model& model) {
  std::vector<std::string> lines(variation_lines.begin(), variation_lines.end());
  const bool is_free = virtual_force(model).empty();
  if (!is_free) lines.push_back(virtual_work(model));
  lines.push_back(
      fmt::format(R"({} \text{{ for every }} {{\delta}} <q> \text{{, so }} {})",
                  is_free ? R"({\delta} S = 0)" : R"({\delta} S + \int {\delta} W dt = 0)",
                  lagrange_equation(model)));
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
  std::string right = virtual_force(model);
  if (!right.empty()) right = R"(<v>^{\top} )" + right;
  if (!is_autonomous) right += (right.empty() ? "-" : " - ") + std::string(explicit_rate);
  return R"(\frac{dE}{dt} = )" + (right.empty() ? "0" : right);
}

std::string energy_conservation(const Model& model) {
  std::vector<std::string> causes;
  if (has_applied_force(model)) causes.emplace_back("forces");
  if (is_damped(model)) causes.emplace_back("dissipation");
  if (!model.constraints.empty()) causes.emplace_back("constraints");
  if (causes.empty()) return "is conserved";
  std::string names = std::move(causes.back());
  causes.pop_back();
  if (!causes.empty()) names = fmt::format("{} and {}", fmt::join(causes, ", "), names);
  return fmt::format("is conserved if {} {} no work", names,
                     names == "dissipation" ? "does" : "do");
}

}  // namespace elgen
