// frame_sections: the quantities of frames -> page sections: the placement of each frame, angular
// velocities, then position, velocity and kinetic energy of each body.
//
//     omega_inner = (beta', alpha' sin beta, alpha' cos beta)
//     r_hand = H_arm H_hand (l/2, 0)        if the position in the world is too long
#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elgen/page.hpp"
#include "model/symbols.hpp"
#include "print/sections.hpp"

namespace elgen {
namespace {

/// H_arm H_hand (x, y): the poses from the world to the frame, and a position in the frame.
Formula position_in_world(const Model& model, std::optional<std::uint32_t> frame, Formulas local) {
  Formulas factors{tuple_of(std::move(local))};
  for (; frame; frame = model.frames[*frame].parent) {
    const std::string name = "H_" + model.frames[*frame].identifier;
    factors.insert(factors.begin(), symbol_formula(name, symbol_of_name(name)));
  }
  return row_of(std::move(factors));
}

/// The section `first` with the quantities from kind `from` to kind `to`. A quantity with
/// definitions ends its section, because definitions of other quantities may have the same names.
/// The next section has no title.
std::vector<PageSection> quantity_sections(const Model& model, const ReadableFrames& frames,
                                           PageSection first, FrameQuantityKind from,
                                           FrameQuantityKind to) {
  ModelSymbols symbols(model);
  std::vector<PageSection> sections{std::move(first)};
  for (std::size_t i = 0; i < frames.quantities.size(); ++i) {
    const auto& [kind, frame] = frames.quantities[i];
    if (kind < from || kind > to) continue;
    if (!sections.back().equations.empty() && sections.back().equations.back().is_definition)
      sections.emplace_back();
    const std::string& name = frames.program.functions[i].name;
    const FunctionEquations read = equations(model, frames.program, i);
    Formulas entries = read.entries.front();
    if (frame) entries = {position_in_world(model, frame, std::move(entries))};
    const auto rows = static_cast<std::uint32_t>(entries.size());
    sections.back().equations.push_back(
        {symbol_formula(name, symbols.make_distinct(symbol_of_name(name))), rows, 1,
         std::move(entries)});
    for (const auto& [symbol, value] : read.definitions)
      sections.back().equations.push_back({symbol, 1, 1, {value}, true});
  }
  if (sections.back().equations.empty()) sections.clear();
  return sections;
}

}  // namespace

std::vector<PageSection> frame_sections(const Model& model, const ReadableFrames& frames) {
  if (model.frames.empty()) return {};
  std::vector<PageSection> result{PageSection{
      .title = prose("Frames"),
      .doc = "Pose H of each frame in its parent: translations and rotations, in order.",
      .table = placement_table(model)}};
  const auto add = [&](PageSection first, FrameQuantityKind from, FrameQuantityKind to) {
    for (PageSection& section : quantity_sections(model, frames, std::move(first), from, to))
      result.push_back(std::move(section));
  };
  using enum FrameQuantityKind;
  add({.title = prose("Angular velocities"),
       .doc = "omega: angular velocity of a frame, in its axes. nu: velocity of its origin, in its "
              "axes, if it is long."},
      spin, origin_velocity);
  const char* const axes = model.rotations.empty()
                               ? "."
                               : "; in the world, if a rotation turns the frame and r has no H.";
  add({.title = prose("Centres of mass"),
       .doc =
           fmt::format("r: position in the world. v: velocity, in the axes of the frame{}", axes)},
      position, velocity);
  add({.title = prose("Kinetic energies"),
       .doc = "T of each body; I is the inertia about the centre of mass.",
       .lines = {latex_formula(R"(T = \frac{1}{2} m v^{2} + \frac{1}{2} \omega^{\top} I \omega)")}},
      energy, energy);
  return result;
}

}  // namespace elgen
