// drop_below: which outputs it reduces, and the parts those are made of. A part is what terms are
// dropped from; the rest follows, so that the outputs stay those of one system.
//
//     [outputs] bias = true    ->    parts mass_matrix, gravity, potential_energy, dissipation,
//                                    applied_force
#include "read_dropping.hpp"

#include <cln/rational_ring.h>

#include <algorithm>

#include "requests.hpp"
#include "values.hpp"

namespace elgen::checking {
namespace {

using K = OutputKind;

/// An output that is reduced, and what it is made of.
struct ReducedRow {
  OutputKind output;
  bool has_mass;
  bool has_potential;
  bool has_forces;  ///< dissipation and applied forces
};

constexpr std::array<ReducedRow, 14> reduced_rows{{
    {K::mass_matrix, true, false, false},
    {K::coriolis_matrix, true, false, false},
    {K::velocity_force, true, false, false},
    {K::gravity, false, true, false},
    {K::potential_energy, false, true, false},
    {K::drift, true, false, false},
    {K::dissipation, false, false, true},
    {K::applied_force, false, false, true},
    {K::bias, true, true, true},
    {K::momentum, true, false, false},
    {K::kinetic_energy, true, false, false},
    {K::total_energy, true, true, false},
    {K::energy_function, true, true, false},
    {K::inverse_dynamics, true, true, true},
}};

const ReducedRow* find_row(OutputKind kind) {
  const auto row = std::find_if(reduced_rows.begin(), reduced_rows.end(),
                                [&](const ReducedRow& known) { return known.output == kind; });
  return row == reduced_rows.end() ? nullptr : &*row;
}

bool has_no_terms(OutputKind kind) {
  return output_row(kind).solves || output_row(kind).differentiates;
}

class DroppingReader {
 public:
  DroppingReader(Context& context, Scene& scene) : context_(context), scene_(scene) {}

  void read(const KeySyntax& key) {
    Dropping dropping;
    dropping.span = key.value.span;
    const auto share = ValueReader(context_, Scope(context_.sizes)).constant(key.value);
    if (!share) return;
    if (!cln::plusp(*share) || *share >= 1 || !cln:: instanceof (*share, cln::cl_RA_ring)) {
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
    const bool is_reduced = find_row(output.kind) != nullptr || output.kind == K::input_matrix ||
                            output.kind == K::dynamics;
    if (has_no_terms(output.kind)) {
      refuse(place,
             quoted(output.name) +
                 " solves or differentiates the equations of motion, "
                 "and is not reduced",
             "emit `mass_matrix` and `bias`, and solve M a = B u - bias with them");
    } else if (is_reduced && output.form == Form::recursive) {
      refuse(place, quoted(output.name) + " has no terms to drop in its recursive form");
    }
  }

  /// Each output once, those that the model has.
  [[nodiscard]] std::vector<OutputRequest> parts() const {
    bool has_mass = false;
    bool has_potential = false;
    bool has_forces = false;
    bool has_inputs = false;
    for (const OutputRequest& output : scene_.outputs) {
      has_inputs = has_inputs || output.kind == K::input_matrix;
      const ReducedRow* row = find_row(output.kind);
      if (row == nullptr) continue;
      has_mass = has_mass || row->has_mass;
      has_potential = has_potential || row->has_potential;
      has_forces = has_forces || row->has_forces;
    }
    std::vector<OutputRequest> result;
    if (has_mass) append(result, {K::mass_matrix});
    if (has_potential) append(result, {K::gravity, K::potential_energy});
    if (has_forces) append(result, {K::dissipation, K::applied_force});
    if (has_inputs) append(result, {K::input_matrix});
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

void read_dropping(Context& context, const EntrySyntax& approximate, Scene& scene) {
  const KeySyntax* key = approximate.find("drop_below");
  if (key != nullptr) DroppingReader(context, scene).read(*key);
}

}  // namespace elgen::checking
