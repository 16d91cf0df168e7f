// drop: see drop.hpp. First the small terms of every part are found, then every output loses what
// follows from them.
#include "elgen/drop.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drop/bounds.hpp"
#include "drop/consequences.hpp"
#include "drop/definiteness.hpp"
#include "drop/term_text.hpp"
#include "evaluate/subject.hpp"
#include "present/rates.hpp"

namespace elgen {

using cln::cl_RA;

namespace {

using K = OutputKind;

bool are_known(const Values& values) {
  return std::all_of(values.begin(), values.end(), [](const Value& x) { return x.has_value(); });
}

/// Of one of the program's functions.
const ClosedFunction& form_of(const Function& function, const Program& program,
                              const ClosedForms& forms) {
  return forms.functions[static_cast<std::size_t>(&function - program.functions.data())];
}

class Drop {
 public:
  Drop(const Program& program, ClosedForms forms, const Model& model, const Dropping& dropping)
      : program_(program),
        model_(model),
        dropping_(dropping),
        forms_(std::move(forms)),
        bounds_(forms_.algebra, model),
        arithmetic_(forms_.algebra) {
    reduction_.below = dropping.below;
  }

  Result<ReducedForms> operator()() {
    find_small_terms();
    if (!error_) take_away();
    if (error_) return *error_;
    return ReducedForms{std::move(forms_), std::move(reduction_)};
  }

 private:
  /// The first one is told.
  void fail(Diagnostic error) {
    if (error_) return;
    if (error.span.source == nullptr) error.span = dropping_.span;
    error_ = std::move(error);
  }

  void fail_given_up(const std::string& name) {
    fail({Code::E608, {}, fmt::format("the closed form of `{}` was given up", name)});
  }

  [[nodiscard]] bool is_part(OutputKind kind) const {
    return std::ranges::count(dropping_.parts, kind, &OutputRequest::kind) > 0;
  }

  /// The closed entries of a part; empty where it is none, or was given up.
  Values exact(OutputKind kind) {
    if (!is_part(kind)) return {};
    const Function* function = find_function(program_, kind);
    if (function == nullptr) return {};
    const Values& entries = form_of(*function, program_, forms_).fields.at(0).entries;
    if (are_known(entries)) return entries;
    fail_given_up(function->name);
    return {};
  }

  void find_small_terms() {
    keep(K::mass_matrix, small_terms_of_mass());
    keep(K::potential_energy, small_terms_of_potential());
    keep(K::dissipation, small_terms(K::dissipation, 1));
    keep(K::applied_force, small_terms(K::applied_force, 1));
    keep(K::input_matrix, small_terms(K::input_matrix, model_.inputs.size()));
  }

  void keep(OutputKind part, Values dropped) {
    if (!dropped.empty()) dropped_[part] = std::move(dropped);
  }

  TermBounds bounds_of(const Fraction& x) {
    const std::optional<TermBounds> bounds = bounds_.of_terms(x);
    if (!bounds) fail(bounds_.missing());
    return bounds.value_or(TermBounds{});
  }

  bool is_small(const Fraction& x, const cl_RA& largest) {
    return bounds_of(x).together < dropping_.below * largest;
  }

  /// Those that may be dropped: a single term is its own largest.
  std::vector<Fraction> several_terms(const Fraction& entry) const {
    std::vector<Fraction> terms = terms_of(forms_.algebra, entry);
    if (terms.size() < 2) terms.clear();
    return terms;
  }

  void drop(const Fraction& term, Value& dropped, OutputKind output, std::size_t entry,
            std::size_t columns) {
    reduction_.terms.push_back({output, static_cast<std::uint32_t>(entry / columns),
                                static_cast<std::uint32_t>(entry % columns),
                                term_text(forms_.algebra, program_.leaves, term),
                                bounds_of(term).together});
    dropped = arithmetic_.add(dropped, term);
  }

  Value small_terms(const Fraction& form, OutputKind output, std::size_t entry,
                    std::size_t columns) {
    Value dropped = Fraction{};
    const std::vector<Fraction> terms = several_terms(form);
    const cl_RA largest = terms.empty() ? cl_RA(0) : bounds_of(form).largest;
    for (const Fraction& term : terms) {
      if (is_small(term, largest) && !error_) drop(term, dropped, output, entry, columns);
    }
    return dropped;
  }

  Values small_terms(OutputKind output, std::size_t columns) {
    Values dropped;
    for (const Value& entry : exact(output)) {
      dropped.push_back(small_terms(*entry, output, dropped.size(), columns));
    }
    return dropped;
  }

  /// The upper triangle, mirrored.
  Values small_terms_of_mass() {
    const Values entries = exact(K::mass_matrix);
    const std::size_t n = model_.velocities.size();
    Values dropped(entries.size());
    for (std::size_t index = 0; index < entries.size(); ++index) {
      const std::size_t mirror = index % n * n + index / n;
      dropped[index] =
          mirror < index ? dropped[mirror] : small_terms(*entries[index], K::mass_matrix, index, n);
    }
    return dropped;
  }

  /// Whether what the term gives to every entry of g is small there, and some of it is not 0.
  bool is_small_in_gravity(const Fraction& term, const std::vector<cl_RA>& largest) {
    bool acts = false;
    const std::size_t n = largest.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Value force = rate(arithmetic_, forms_.algebra, term, along_coordinate(i, n));
      if (!force) fail_given_up("gravity");
      if (!force || force->numerator.empty()) continue;
      acts = true;
      if (!is_small(*force, largest[i])) return false;
    }
    return acts && !error_;
  }

  Values small_terms_of_potential() {
    const Values potential = exact(K::potential_energy);
    const Values gravity = exact(K::gravity);
    if (potential.empty() || gravity.empty()) return {};
    Value dropped = Fraction{};
    const std::vector<Fraction> terms = several_terms(*potential[0]);
    if (terms.empty()) return {dropped};
    std::vector<cl_RA> largest;
    for (const Value& entry : gravity) largest.push_back(bounds_of(*entry).largest);
    for (const Fraction& term : terms) {
      if (is_small_in_gravity(term, largest)) drop(term, dropped, K::potential_energy, 0, 1);
    }
    return {dropped};
  }

  void take_away() {
    Consequences consequences(arithmetic_, forms_.algebra, model_.velocities.size(), dropped_);
    for (std::size_t i = 0; i < program_.functions.size(); ++i) {
      const Function& function = program_.functions[i];
      const Values& lost = consequences.of(function.kind);
      if (!are_known(lost)) fail_given_up(function.name);
      const bool loses = std::any_of(lost.begin(), lost.end(), [](const Value& x) {
        return x.has_value() && !x->numerator.empty();
      });
      if (error_ || !loses) continue;
      reduction_.outputs.push_back(
          errors_of(function, forms_.functions[i].fields[0], consequences));
      subtract(function, forms_.functions[i], lost);
    }
  }

  void subtract(const Function& function, ClosedFunction& closed, const Values& lost) {
    closed.is_reduced = true;
    Values& entries = closed.fields[0].entries;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      entries[i] = arithmetic_.subtract(entries[i], lost[i]);
      if (!entries[i]) fail_given_up(function.name);
    }
  }

  ReducedOutput errors_of(const Function& function, const ClosedField& field,
                          Consequences& consequences) {
    ReducedOutput output{function.kind, function.fields[0].columns, {}};
    const bool takes_acceleration = output_row(function.kind).takes.has_any(Opcode::acceleration);
    const Values& without_acceleration =
        consequences.of(takes_acceleration ? K::bias : function.kind);
    for (std::size_t i = 0; i < without_acceleration.size(); ++i) {
      EntryError error;
      error.constant = bounds_of(*without_acceleration[i]).together;
      const std::size_t n = takes_acceleration ? model_.velocities.size() : 0;
      for (std::size_t j = 0; j < n && dropped_.count(K::mass_matrix) > 0; ++j) {
        error.by_acceleration.push_back(bounds_of(*dropped_[K::mass_matrix][i * n + j]).together);
      }
      const auto known =
          n == 0 && field.entries[i] ? bounds_.of_terms(*field.entries[i]) : std::nullopt;
      if (known) error.largest = known->largest;
      output.errors.push_back(std::move(error));
    }
    return output;
  }

  const Program& program_;
  const Model& model_;
  const Dropping& dropping_;
  ClosedForms forms_;
  RangeBounds bounds_;
  Arithmetic arithmetic_;
  DroppedParts dropped_;
  Reduction reduction_;
  std::optional<Diagnostic> error_;
};

/// The forms of `program`'s functions out of those of a program that has more.
std::vector<ClosedFunction> selected(const Program& program, const Program& whole,
                                     const ClosedForms& forms) {
  std::vector<ClosedFunction> result;
  for (const Function& function : program.functions) {
    const Function* known = find_function(whole, function.kind, function.user);
    result.push_back(known == nullptr ? ClosedFunction{} : form_of(*known, whole, forms));
  }
  return result;
}

}  // namespace

std::vector<OutputRequest> with_parts(const Scene& scene) {
  std::vector<OutputRequest> all;
  for (const OutputRequest& output : scene.outputs) {
    if (!output_row(output.kind).repeats) all.push_back(output);
  }
  for (const OutputRequest& part : scene.dropping->parts) {
    if (std::ranges::count(all, part.kind, &OutputRequest::kind) == 0) all.push_back(part);
  }
  return all;
}

Result<ReducedForms> drop_terms(const Program& program, const Program& whole, ClosedForms forms,
                                const CheckedModel& checked) {
  const auto& [model, scene] = checked;
  Result<ReducedForms> reduced = Drop(whole, std::move(forms), model, *scene.dropping)();
  if (!reduced) return reduced;
  Diagnostics refused = check_definiteness(model, scene, reduced->reduction);
  if (!refused.empty()) return refused;
  reduced->forms.functions = selected(program, whole, reduced->forms);
  return reduced;
}

}  // namespace elgen
