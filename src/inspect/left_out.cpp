// E619: the outputs that the built-in scene `full` does without, one note per reason.
#include <fmt/format.h>

#include "inspect/checks.hpp"

namespace elgen {
namespace {

/// "`mass_matrix`, `linearization`"
std::string quoted_names(const LeftOut& left_out) {
  return fmt::format("`{}`", fmt::join(left_out.outputs, "`, `"));
}

Diagnostic note(const LeftOut& left_out) {
  if (left_out.reason == LeftOutReason::too_many_entries) {
    return {Code::E619, left_out.span,
            fmt::format("left out, with more than {} entries: {}", entries_in_full,
                        quoted_names(left_out)),
            "a scene or `--outputs` that names an output gets it"};
  }
  return {Code::E619, left_out.span,
          "left out, as a force with a kink has no derivatives: " + quoted_names(left_out),
          "a smooth stand-in has them: `tanh(x/width)` for `sign(x)`"};
}

}  // namespace

Diagnostics inspect_left_out(const Inspected& subject) {
  Diagnostics notes;
  for (const LeftOut& left_out : subject.scene.left_out) notes.push_back(note(left_out));
  return notes;
}

}  // namespace elgen
