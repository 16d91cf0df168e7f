// The plane of a model: frames turn about z and shift along x and y.
#include "check/entries/plane.hpp"

#include <algorithm>

namespace elgen {
namespace {

class PlaneCheck {
 public:
  explicit PlaneCheck(Context& context) : context_(context) {}

  void check(const Frame& frame) {
    for (const FrameStep& step : frame.steps) {
      switch (step.kind) {
        case FrameStepKind::translation:
          require_zero({step.vector[2]}, step.vector[2], "shifts");
          break;
        case FrameStepKind::turn:
          if (!is_zero(step.angle)) {
            require_zero({step.vector[0], step.vector[1]}, step.angle, "turns");
          }
          break;
        case FrameStepKind::quaternion:
          require_zero({step.quaternion[1]}, step.quaternion[1], "turns");
          require_zero({step.quaternion[2]}, step.quaternion[2], "turns");
          break;
      }
    }
  }

 private:
  [[nodiscard]] bool is_zero(ExpressionId id) const {
    const auto& value = context_.constants[id];
    return value && cln::zerop(*value);
  }

  /// `blamed` is what the file says there.
  void require_zero(const std::vector<ExpressionId>& components, ExpressionId blamed,
                    const std::string& moves) {
    const auto zero = [&](ExpressionId id) { return is_zero(id); };
    if (std::all_of(components.begin(), components.end(), zero)) return;
    const Span& span = context_.model.expressions[blamed].span;
    context_.report.add(Code::E516, span,
                        quoted(span) + " " + moves +
                            " out of the plane of a model whose vectors have 2 components");
  }

  Context& context_;
};

}  // namespace

void check_plane(Context& context) {
  // Vectors of three components there are refused as such.
  if (context.dimension != 2 || context.report.errors() > 0) return;
  PlaneCheck plane(context);
  for (const Frame& frame : context.model.frames) plane.check(frame);
}

}  // namespace elgen
