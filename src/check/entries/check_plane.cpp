// Checks that the frames of a planar model stay in the plane.
#include <algorithm>
#include <string>
#include <vector>

#include "check/entries/entries.hpp"
#include "check/names/context.hpp"

namespace elgen {
namespace {

/// Reports E516 at the expression `blamed` unless all components are 0.
void require_zero(Context& context, const std::vector<ExpressionId>& components,
                  ExpressionId blamed, const std::string& moves) {
  const auto is_zero = [&](ExpressionId id) { return context.constants[id] == 0; };
  if (std::ranges::all_of(components, is_zero)) return;
  const Span& span = context.model.expressions[blamed].span;
  context.report.add(Code::E516, span,
                     in_backticks(span) + " " + moves +
                         " out of the plane of a model whose vectors have 2 components");
}

void check_transform(Context& context, const ElementaryTransform& transform) {
  const auto& [x, y, z] = transform.vector;
  switch (transform.kind) {
    case TransformKind::translation:
      return require_zero(context, {z}, z, "shifts");
    case TransformKind::turn:
      if (context.constants[transform.angle] == 0) return;
      return require_zero(context, {x, y}, transform.angle, "turns");
    case TransformKind::quaternion:
      require_zero(context, {transform.quaternion[1]}, transform.quaternion[1], "turns");
      require_zero(context, {transform.quaternion[2]}, transform.quaternion[2], "turns");
  }
}

}  // namespace

void check_plane(Context& context) {
  // In a planar model, vectors of three components are already errors.
  if (context.dimension != 2 || context.report.error_count() > 0) return;
  for (const Frame& frame : context.model.frames) {
    for (const ElementaryTransform& transform : frame.transforms)
      check_transform(context, transform);
  }
}

}  // namespace elgen
