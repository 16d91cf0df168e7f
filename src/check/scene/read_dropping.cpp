// drop_below: which outputs it reduces, and the parts those are made of. A part is what terms are
// dropped from; the rest follows, so that the outputs stay those of one system.
//
//     [outputs] bias = true    ->    parts mass_matrix, gravity, potential_energy, dissipation,
//                                    applied_force
#include "check/scene/read_dropping.hpp"

#include <algorithm>

#include "base/exact_number.hpp"
#include "check/expressions/values.hpp"
#include "check/names/requests.hpp"

namespace elgen {
namespace {

using K = OutputKind;

class DroppingReader {
 public:
  DroppingReader(Context& context, Scene& scene) : context_(context), scene_(scene) {}

  void read(const KeySyntax& key) {
    Dropping dropping;
    dropping.span = key.value.span;
    const auto share = ValueReader(context_, Scope(context_.sizes)).constant(key.value);
    if (!share) return;
    if (!cln::plusp(*share) || *share >= 1 || !is_rational(*share)) {
      refuse(dropping.span, "a share of the largest term is a rational number between 0 and 1");
      return;
    }
    if (!context_.model.rotations.empty() || !context_.model.quadratic) {
      refuse(dropping.span,
             "models with rotations, or not quadratic in the rates, are not reduced");
      return;
    }
    dropping.below = cln::rational(*share);
    for (const OutputRequest& output : scene_.outputs) check_output(output, dropping.span);
    dropping.parts = parts();
    scene_.dropping = std::move(dropping);
  }

 private:
  void refuse(const Span& span, std::string message, std::string hint = {}) {
    context_.report.add(Code::E617, span, std::move(message), std::move(hint));
  }

  void check_output(const OutputRequest& output, const Span& otherwise) {
    // Outputs that no list names have no place of their own.
    const Span& place = output.span.source == nullptr ? otherwise : output.span;
    const OutputRow& row = output_row(output.kind);
    const auto& [mass, potential, forces, inputs] = row.parts;
    const bool is_reduced = mass || potential || forces || inputs || row.repeats;
    if (row.solves || row.differentiates || row.steps) {
      refuse(place,
             in_backticks(output.name) +
                 " solves or differentiates the equations of motion, "
                 "and is not reduced",
             "emit `mass_matrix` and `bias`, and solve M a = B u - bias with them");
    } else if (is_reduced && output.form == Form::recursive) {
      refuse(place, in_backticks(output.name) + " has no terms to drop in its recursive form");
    }
  }

  /// Each output once, those that the model has.
  [[nodiscard]] std::vector<OutputRequest> parts() const {
    Parts parts;
    for (const OutputRequest& output : scene_.outputs) {
      const Parts& own = output_row(output.kind).parts;
      parts = {parts.mass || own.mass, parts.potential || own.potential, parts.forces || own.forces,
               parts.inputs || own.inputs};
    }
    std::vector<OutputRequest> result;
    if (parts.mass) append(result, {K::mass_matrix});
    if (parts.potential) append(result, {K::gravity, K::potential_energy});
    if (parts.forces) append(result, {K::dissipation, K::applied_force});
    if (parts.inputs) append(result, {K::input_matrix});
    return result;
  }

  /// All of them, or none where the model lacks one.
  void append(std::vector<OutputRequest>& to, const std::vector<OutputKind>& kinds) const {
    std::vector<OutputRequest> found;
    for (const OutputKind kind : kinds) {
      auto request = find_request(context_.model, output_row(kind).name);
      if (!request || !is_available(context_.model, *request)) return;
      found.push_back(std::move(*request));
    }
    to.insert(to.end(), found.begin(), found.end());
  }

  Context& context_;
  Scene& scene_;
};

}  // namespace

void read_dropping(Context& context, const FileSyntax* syntax, Scene& scene) {
  const KeySyntax* key = find_key(syntax, "approximate", "drop_below");
  if (key != nullptr) DroppingReader(context, scene).read(*key);
}

}  // namespace elgen
