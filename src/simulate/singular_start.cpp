// Charts by the factors that the model states, M by its relative pivots.
#include "simulate/singular_start.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace elgen {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The sine of the double nearest to pi is 1e-16.
constexpr double zero = 64 * epsilon;

Diagnostic singular(std::string message) {
  return {Code::E623, {}, std::move(message), "`--state` starts the run elsewhere"};
}

}  // namespace

Diagnostics refuse_start(System& system, const Numbers& state, double t) {
  const double* const q = state.data();
  const double* const v = system.v_of(state);
  const Model& model = system.model();
  for (const Coordinate& coordinate : model.coordinates) {
    if (!coordinate.singular) continue;
    if (std::abs(system.value(*coordinate.singular, q, v, t)) > zero) continue;
    const std::string_view factor = covered_text(model.expressions[*coordinate.singular].span);
    return {singular(fmt::format("the chart of `{}` breaks at the start, where `{}` is zero",
                                 coordinate.name, factor))};
  }
  Numbers a(system.velocities());
  system.acceleration(q, v, t, a.data());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double pivot = system.relative_pivots()[i];
    if (std::abs(pivot) > static_cast<double>(a.size()) * epsilon) continue;
    const std::string name =
        leaf_text(system.leaves(), Opcode::velocity, static_cast<std::uint32_t>(i));
    const std::string value = std::isfinite(pivot) ? fmt::format("{:.1e}", pivot) : "no number";
    return {singular(
        fmt::format("M is singular at the start: the relative pivot of `{}` is {}", name, value))};
  }
  return {};
}

}  // namespace elgen
