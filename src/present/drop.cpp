// drop: see drop.hpp. First the small terms of every part are found, then every output loses what
// follows from them.
#include "elgen/drop.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "present/bounds.hpp"
#include "present/consequences.hpp"
#include "present/rates.hpp"
#include "present/term_text.hpp"

namespace elgen {

using cln::cl_RA;

namespace {

using K = OutputKind;

class Drop {
 public:
  Drop(const Program& program, ClosedForms forms, const Model& model, const Dropping& dropping)
      : program_(program),
        model_(model),
        dropping_(dropping),
        forms_(std::move(forms)),
        bounds_(forms_.algebra, model),
        arithmetic_(forms_.algebra, work_, PresentBudget{}.terms) {
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
    return std::any_of(dropping_.parts.begin(), dropping_.parts.end(),
                       [&](const OutputRequest& part) { return part.kind == kind; });
  }

  /// The closed entries of a part; empty where it is none, or was given up.
  Values exact(OutputKind kind) {
    if (!is_part(kind)) return {};
    for (std::size_t i = 0; i < program_.functions.size(); ++i) {
      if (program_.functions[i].kind != kind) continue;
      const Values& entries = forms_.functions[i].fields.at(0).entries;
      if (std::all_of(entries.begin(), entries.end(), [](const Value& x) { return x.has_value(); }))
        return entries;
      fail_given_up(program_.functions[i].name);
    }
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

  void note(OutputKind output, std::size_t entry, std::size_t columns, const Fraction& term) {
    const auto bound = bounds_.all_terms(term);
    reduction_.terms.push_back({output, static_cast<std::uint32_t>(entry / columns),
                                static_cast<std::uint32_t>(entry % columns),
                                term_text(forms_.algebra, program_.leaves, term),
                                bound.value_or(0)});
  }

  /// Whether every term of `x` is below the share of `largest`.
  bool is_small(const Fraction& x, const cl_RA& largest) {
    const auto bound = bounds_.all_terms(x);
    if (!bound) fail(bounds_.missing());
    return bound && *bound < dropping_.below * largest;
  }

  cl_RA largest_term(const Fraction& x) {
    const auto bound = bounds_.largest_term(x);
    if (!bound) fail(bounds_.missing());
    return bound.value_or(0);
  }

  /// One entry; a single term is its own largest.
  Value small_terms(const Fraction& entry, OutputKind output, std::size_t index,
                    std::size_t columns) {
    Value dropped = Fraction{};
    const std::vector<Fraction> terms = terms_of(forms_.algebra, entry);
    if (terms.size() < 2) return dropped;
    const cl_RA largest = largest_term(entry);
    for (const Fraction& term : terms) {
      if (error_ || !is_small(term, largest)) continue;
      note(output, index, columns, term);
      dropped = arithmetic_.add(dropped, term);
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
      const Value force = elgen::rate(arithmetic_, forms_.algebra, term, along_coordinate(i, n));
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
    const std::vector<Fraction> terms = terms_of(forms_.algebra, *potential[0]);
    Value dropped = Fraction{};
    if (terms.size() < 2) return {dropped};
    std::vector<cl_RA> largest;
    for (const Value& entry : gravity) largest.push_back(largest_term(*entry));
    for (const Fraction& term : terms) {
      if (error_ || !is_small_in_gravity(term, largest)) continue;
      note(K::potential_energy, 0, 1, term);
      dropped = arithmetic_.add(dropped, term);
    }
    return {dropped};
  }

  void take_away() {
    Consequences consequences(arithmetic_, forms_.algebra, model_.velocities.size(), dropped_);
    for (std::size_t i = 0; i < program_.functions.size(); ++i) {
      const Function& function = program_.functions[i];
      const Values& lost = consequences.of(function.kind);
      if (!std::all_of(lost.begin(), lost.end(), [](const Value& x) { return x.has_value(); })) {
        fail_given_up(function.name);
      }
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

  cl_RA error_bound(const Value& lost) {
    const auto bound = bounds_.all_terms(*lost);
    if (!bound) fail(bounds_.missing());
    return bound.value_or(0);
  }

  ReducedOutput errors_of(const Function& function, const ClosedField& field,
                          Consequences& consequences) {
    ReducedOutput output{function.kind, function.fields[0].columns, {}};
    const bool takes_acceleration = output_row(function.kind).takes_acceleration;
    const Values& without_acceleration =
        consequences.of(takes_acceleration ? K::bias : function.kind);
    for (std::size_t i = 0; i < without_acceleration.size(); ++i) {
      EntryError error;
      error.constant = error_bound(without_acceleration[i]);
      const std::size_t n = takes_acceleration ? model_.velocities.size() : 0;
      for (std::size_t j = 0; j < n && dropped_.count(K::mass_matrix) > 0; ++j) {
        error.by_acceleration.push_back(error_bound(dropped_[K::mass_matrix][i * n + j]));
      }
      if (n == 0 && field.entries[i]) error.largest = bounds_.largest_term(*field.entries[i]);
      output.errors.push_back(std::move(error));
    }
    return output;
  }

  const Program& program_;
  const Model& model_;
  const Dropping& dropping_;
  ClosedForms forms_;
  TermBounds bounds_;
  std::size_t work_ = PresentBudget{}.products;
  Arithmetic arithmetic_;
  DroppedParts dropped_;
  Reduction reduction_;
  std::optional<Diagnostic> error_;
};

}  // namespace

Result<ReducedForms> drop_terms(const Program& program, ClosedForms forms, const Model& model,
                                const Dropping& dropping) {
  return Drop(program, std::move(forms), model, dropping)();
}

}  // namespace elgen
