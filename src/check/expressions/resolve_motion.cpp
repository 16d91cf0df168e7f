// Resolver, places and frames:
//
//     x(P)            component of a place: a point, the origin of a frame, the com of a body
//     vx(P, G)        velocity of a place against the world, component along an axis of G
//     wx(F)           angular velocity of F against the world, component along an axis of the world
//     wx(F, G)        the same, component along an axis of G
//     axis(F, i, j)   component i in the world of axis j of F: R_ij
//
// F and G are frames, or bodies in a frame. A body has a place only if it is in a frame.
#include <fmt/format.h>

#include <array>
#include <utility>

#include "base/reason.hpp"
#include "check/expressions/node_builder.hpp"
#include "check/expressions/resolver.hpp"

namespace elgen {
namespace {

/// Index of the axis: 0 for x, wx and vx.
std::uint32_t axis_index(const ExpressionSyntax& call) {
  return static_cast<std::uint32_t>(call.text.back() - 'x');
}

bool has_kind(const DeclaredName* symbol, SymbolKind kind) {
  return symbol != nullptr && symbol->kind == kind;
}

/// The index of a frame; none for the world.
template <class Frame>
std::optional<std::uint32_t> frame_index(const Frame& frame) {
  return frame.is_world ? std::nullopt : std::optional(frame.index);
}

}  // namespace

std::optional<Resolver::ResolvedPlace> Resolver::resolve_place(const ExpressionSyntax& name) {
  const bool is_name = name.kind == SyntaxKind::name;
  const DeclaredName* const symbol = context_.symbols.find(name.text);
  const DeclaredName* const frame = context_.frames.find(name.text);
  const Model& model = context_.model;
  if (is_name && has_kind(symbol, SymbolKind::point)) {
    const auto index = resolve_element(name, *symbol);
    if (!index) return std::nullopt;
    return ResolvedPlace{NamedKind::point, *index, 0, model.points[*index].dimension};
  }
  if (is_name && frame != nullptr) {
    const auto index = resolve_element(name, *frame);
    if (!index) return std::nullopt;
    return ResolvedPlace{NamedKind::frame, *index, frame_origin, context_.dimension == 2 ? 2U : 3U};
  }
  if (is_name && has_kind(symbol, SymbolKind::body)) {
    const auto index = resolve_element(name, *symbol);
    if (!index) return std::nullopt;
    const Body& body = model.bodies[*index];
    if (body.local) return ResolvedPlace{NamedKind::body, *index, 0, body.dimension};
  }
  report_unknown_place(name, symbol);
  return std::nullopt;
}

void Resolver::report_unknown_place(const ExpressionSyntax& name, const DeclaredName* symbol) {
  if (context_.symbols.has_failed(name.text) || context_.frames.has_failed(name.text)) return;
  if (name.kind == SyntaxKind::name && has_kind(symbol, SymbolKind::body)) {
    context_.report.add(
        Reason::body_without_frame, name.span, in_backticks(name.span) + " is not a place here",
        "the com of a body in a frame is a place in forces, energies, constraints and "
        "outputs; elsewhere name a point, or a frame for its origin");
    return;
  }
  std::vector<std::string> names = context_.symbols.names({SymbolKind::point, SymbolKind::body});
  for (std::string& each : context_.frames.names()) names.push_back(std::move(each));
  context_.report.add(Reason::unknown_place, name.span, "unknown place " + in_backticks(name.span),
                      context_.symbols.suggest(name.text, names));
}

std::optional<Resolver::ResolvedFrame> Resolver::resolve_frame(const ExpressionSyntax& name) {
  if (name.kind == SyntaxKind::name && name.operands.empty() && name.text == world) {
    return ResolvedFrame{};
  }
  const DeclaredName* const symbol = context_.symbols.find(name.text);
  const bool is_frame = context_.frames.find(name.text) != nullptr;
  if (name.kind == SyntaxKind::name && !is_frame && has_kind(symbol, SymbolKind::body)) {
    const auto index = resolve_element(name, *symbol);
    if (!index) return std::nullopt;
    const auto& local = context_.model.bodies[*index].local;
    if (local) return ResolvedFrame{local->com.frame, false};
    context_.report.add(Reason::body_without_frame, name.span,
                        in_backticks(name.span) + " is in no frame here",
                        "a body has the axes of its `frame`");
    return std::nullopt;
  }
  const DeclaredName* const frame = require_declaration(
      name, SymbolKind::frame, name.kind == SyntaxKind::name, covered_text(name.span));
  if (frame == nullptr) return std::nullopt;
  const auto index = resolve_element(name, *frame);
  if (!index) return std::nullopt;
  return ResolvedFrame{*index, false};
}

bool Resolver::check_axis(const ExpressionSyntax& call, std::uint32_t dimension, bool is_angular) {
  const std::uint32_t axis = axis_index(call);
  if (dimension == 3 || (is_angular ? axis == 2 : axis < 2)) return true;
  context_.report.add(
      Code::E516, call.span,
      in_backticks(call.operands[0].span) + " is planar, so it has no " + call.text);
  return false;
}

/// The node itself, or a new node 0 for `no_expression`, which cannot be a root.
std::optional<ExpressionId> Resolver::replace_shared_zero(ExpressionId id, const Span& span) {
  return id == no_expression ? push_number(0, span) : std::optional(id);
}

std::optional<ExpressionId> Resolver::resolve_component(const ExpressionSyntax& call) {
  if (!check_arity(call, 1)) return std::nullopt;
  const std::optional<ResolvedPlace> place = resolve_place(call.operands[0]);
  if (!place || !check_axis(call, place->dimension, false)) return std::nullopt;
  return push({.kind = ExpressionKind::named,
               .named = place->kind,
               .index = place->index,
               .component = place->first + axis_index(call),
               .span = call.span});
}

std::optional<ExpressionId> Resolver::resolve_velocity(const ExpressionSyntax& call) {
  if (call.operands.size() == 1) {
    const std::string place(covered_text(call.operands[0].span));
    context_.report.add(
        Code::E309, call.span,
        quote_text(call.text) + " needs a frame as its second argument, for its axes",
        fmt::format("along the axes of the world, write `dot({}({}))`", call.text.back(), place));
    return std::nullopt;
  }
  if (!check_arity(call, 2)) return std::nullopt;
  const std::optional<ResolvedPlace> place = resolve_place(call.operands[0]);
  const std::optional<ResolvedFrame> axes = resolve_frame(call.operands[1]);
  if (!place || !axes || !check_axis(call, place->dimension, false)) return std::nullopt;
  NodeBuilder nodes(context_, call.span);
  Vector3 velocity{};
  for (std::uint32_t i = 0; i < place->dimension; ++i) {
    const ExpressionId component = nodes.name_node(place->kind, place->index, place->first + i);
    velocity[i] = nodes.rate(component);
  }
  return replace_shared_zero(
      change_axes(nodes, velocity, std::nullopt, frame_index(*axes))[axis_index(call)], call.span);
}

std::optional<ExpressionId> Resolver::resolve_angular_velocity(const ExpressionSyntax& call) {
  const bool has_axes = call.operands.size() == 2;
  if (!has_axes && !check_arity(call, 1)) return std::nullopt;
  const std::optional<ResolvedFrame> frame = resolve_frame(call.operands[0]);
  std::optional<ResolvedFrame> axes{ResolvedFrame{}};
  if (has_axes) axes = resolve_frame(call.operands[1]);
  if (!frame || !axes || !check_axis(call, context_.dimension, true)) return std::nullopt;
  if (frame->is_world) return push_number(0, call.span);
  NodeBuilder nodes(context_, call.span);
  const bool is_own = !axes->is_world && frame->index == axes->index;
  const Vector3 turning =
      frame_vector(nodes, frame->index, is_own ? frame_recursive_spin : frame_angular_velocity);
  const std::optional<std::uint32_t> to = is_own ? std::nullopt : frame_index(*axes);
  return replace_shared_zero(change_axes(nodes, turning, std::nullopt, to)[axis_index(call)],
                             call.span);
}

std::optional<ExpressionId> Resolver::resolve_axis(const ExpressionSyntax& call) {
  if (!check_arity(call, 3)) return std::nullopt;
  const std::optional<ResolvedFrame> frame = resolve_frame(call.operands[0]);
  if (!frame) return std::nullopt;
  std::array<std::int64_t, 2> places{};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto number = evaluate_integer(call.operands[i + 1], scope_, context_.report);
    if (!number) return std::nullopt;
    if (*number < 1 || *number > 3) {
      context_.report.add(Code::E318, call.operands[i + 1].span,
                          in_backticks(call.operands[i + 1].span) + " is not from 1 to 3");
      return std::nullopt;
    }
    places[i] = *number - 1;
  }
  if (frame->is_world) return push_number(places[0] == places[1] ? 1 : 0, call.span);
  const auto entry = static_cast<std::uint32_t>(3 * places[0] + places[1]);
  return push({.kind = ExpressionKind::named,
               .named = NamedKind::frame,
               .index = frame->index,
               .component = frame_rotation + entry,
               .span = call.span});
}

}  // namespace elgen
