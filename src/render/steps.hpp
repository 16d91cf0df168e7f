// steps: a part of a derivation as it is read, a title with equations below; and the sentences that
// are the same for every model, `<q>` being a vector in LaTeX.
//
// Hamilton's principle, with d'Alembert's where forces work or constraints hold: Goldstein, Poole,
// Safko, Classical Mechanics, 3rd ed., sections 1.4, 2.3 and 2.4.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace elgen {

/// `left` = one field of one function.
struct StepEquation {
  std::string text = {};
  std::string latex = {};
  std::size_t function = 0;
  std::size_t field = 0;
  std::uint32_t rows = 1;
};

/// A formula of no function, or a sentence with formulas.
struct StepLine {
  std::string text = {};
  std::string latex = {};
};

struct DerivationStep {
  std::string title = {};
  std::string title_latex = {};  ///< as SheetOutput has it
  std::string doc = {};
  std::vector<StepEquation> equations = {};
  std::vector<StepLine> lines = {};  ///< before the equations
};

struct FixedLine {
  const char* text;
  const char* latex;
};

inline constexpr std::string_view action_doc =
    "Hamilton's principle: the motion between two fixed ends makes S stationary.";
inline constexpr std::string_view turning_variation =
    " Of an angular velocity delta q is a turn about the axes of the body, and d/dt is the rate "
    "seen from the world.";

/// S, its variation, the integration by parts, and its boundary terms.
inline constexpr std::array<FixedLine, 4> variation_lines{{
    {"S = int L dt", R"(S = \int L dt)"},
    {"delta S = int (dL/dq delta q + dL/dv d(delta q)/dt) dt",
     R"({\delta} S = \int \left( \frac{\partial L}{\partial <q>} \cdot {\delta} <q> + )"
     R"(\frac{\partial L}{\partial \dot{<q>}} \cdot \frac{d}{dt} {\delta} <q> \right) dt)"},
    {"delta S = int (dL/dq - d/dt dL/dv) delta q dt + [dL/dv delta q] by parts",
     R"({\delta} S = \int \left( \frac{\partial L}{\partial <q>} - )"
     R"(\frac{d}{dt} \frac{\partial L}{\partial \dot{<q>}} \right) \cdot {\delta} <q> dt + )"
     R"(\left[ \frac{\partial L}{\partial \dot{<q>}} \cdot {\delta} <q> \right] \text{ by parts})"},
    {"[dL/dv delta q] = 0, as delta q = 0 at both ends",
     R"(\left[ \frac{\partial L}{\partial \dot{<q>}} \cdot {\delta} <q> \right] = 0 )"
     R"(\text{, as } {\delta} <q> = <0> \text{ at both ends})"},
}};

/// Hamilton's principle, and d'Alembert's where forces work.
inline constexpr FixedLine stationary{
    "delta S = 0 for every delta q, so d/dt dL/dv - dL/dq = 0",
    R"({\delta} S = 0 \text{ for every } {\delta} <q> \text{, so } )"
    R"(\frac{d}{dt} \frac{\partial L}{\partial \dot{<q>}} - )"
    R"(\frac{\partial L}{\partial <q>} = <0>)"};
inline constexpr FixedLine virtual_work{
    "delta W = (Q - dD/dv) delta q is the virtual work of forces (d'Alembert)",
    R"({\delta} W = \left( <Q> - \frac{\partial D}{\partial \dot{<q>}} \right) \cdot {\delta} <q> )"
    R"(\text{ is the virtual work of forces (d'Alembert)})"};
inline constexpr FixedLine balanced_forces{
    "delta S + int delta W dt = 0 for every delta q, so d/dt dL/dv - dL/dq + dD/dv = Q",
    R"({\delta} S + \int {\delta} W dt = 0 \text{ for every } {\delta} <q> \text{, so } )"
    R"(\frac{d}{dt} \frac{\partial L}{\partial \dot{<q>}} - \frac{\partial L}{\partial <q>} + )"
    R"(\frac{\partial D}{\partial \dot{<q>}} = <Q>)"};
inline constexpr std::string_view lagrange =
    R"(\frac{d}{dt} \frac{\partial L}{\partial \dot{<q>}} - \frac{\partial L}{\partial <q>} + )"
    R"(\frac{\partial D}{\partial \dot{<q>}} = <Q>)";

/// The same with constraints.
inline constexpr FixedLine constrained_work{
    "delta W = (Q - dD/dv + A^T lambda) delta q is the virtual work of forces and constraints "
    "(d'Alembert)",
    R"({\delta} W = \left( <Q> - \frac{\partial D}{\partial \dot{<q>}} + A^{\top} <lambda> )"
    R"(\right) \cdot {\delta} <q> )"
    R"(\text{ is the virtual work of forces and constraints (d'Alembert)})"};
inline constexpr FixedLine constraint_forces{" + A^T lambda", R"( + A^{\top} <lambda>)"};
inline constexpr std::string_view constraints_doc =
    "Each has an unknown multiplier; A = df/dq of positions, dphi/dv of velocities.";
inline constexpr FixedLine of_velocities{
    "nothing is added to L for velocities: delta q A^T lambda is virtual work (d'Alembert)",
    R"(\text{nothing is added to } L \text{ for velocities: } {\delta} <q> \cdot A^{\top} )"
    R"(<lambda> \text{ is virtual work (d'Alembert)})"};

inline constexpr std::string_view turning_doc =
    "An angular velocity: d/dt is the rate seen from the world, with [w]x dL/dw, and the slope of "
    "L "
    "is along a turn about the axis of the body.";

inline constexpr const char* energy_of_free = "dE/dt = -dL/dt at fixed q and v.";
inline constexpr const char* energy_of_driven =
    "dE/dt = v (Q - dD/dv) - dL/dt, the last at fixed q and v.";
inline constexpr const char* energy_of_constrained =
    "dE/dt = v (Q - dD/dv + A^T lambda) - dL/dt, the last at fixed q and v.";
inline constexpr const char* conserved_unless_driven =
    "is conserved wherever no force and no dissipation work";
inline constexpr const char* conserved_unless_constrained =
    "is conserved wherever no force, no dissipation and no constraint works";

}  // namespace elgen
