// The plane of a model: frames turn about z and shift along x and y.
#include "check/entries/plane.hpp"

#include <algorithm>

namespace elgen {
namespace {

/// `blamed` is what the file says there.
void require_zero(Context& context, const std::vector<ExpressionId>& components,
                  ExpressionId blamed, const std::string& moves) {
  const auto is_zero = [&](ExpressionId id) { return context.constants[id] == 0; };
  if (std::all_of(components.begin(), components.end(), is_zero)) return;
  const Span& span = context.model.expressions[blamed].span;
  context.report.add(Code::E516, span,
                     in_backticks(span) + " " + moves +
                         " out of the plane of a model whose vectors have 2 components");
}

void check(Context& context, const FrameStep& step) {
  const auto& [x, y, z] = step.vector;
  switch (step.kind) {
    case FrameStepKind::translation:
      return require_zero(context, {z}, z, "shifts");
    case FrameStepKind::turn:
      if (context.constants[step.angle] == 0) return;
      return require_zero(context, {x, y}, step.angle, "turns");
    case FrameStepKind::quaternion:
      require_zero(context, {step.quaternion[1]}, step.quaternion[1], "turns");
      require_zero(context, {step.quaternion[2]}, step.quaternion[2], "turns");
  }
}

}  // namespace

void check_plane(Context& context) {
  // Vectors of three components there are refused as such.
  if (context.dimension != 2 || context.report.errors() > 0) return;
  for (const Frame& frame : context.model.frames) {
    for (const FrameStep& step : frame.steps) check(context, step);
  }
}

}  // namespace elgen
