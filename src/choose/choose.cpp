// choose: see choose.hpp. Only this file decides between the closed and the recursive form.
#include "elgen/choose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "choose/energy_sum.hpp"
#include "choose/entries.hpp"
#include "choose/finish.hpp"

namespace elgen {
namespace {

/// A closed form is not lowered if its entries, without common subexpressions, have this many times
/// the operations of the recursive form: sharing would not make it cheaper. Ratios from 3 to 12
/// give the same code for all of models/; with 2 a cheaper form is missed.
constexpr std::size_t max_length_ratio = 6;
/// Closed forms up to this length are always lowered, because the ratio means nothing if the
/// recursive form has only a few operations.
constexpr std::size_t always_lowered_length = 400;

/// The largest tolerated loss in double: 13 bits, a quarter of its digits. To avoid a larger loss,
/// a form may cost a quarter more than the cheapest form.
constexpr double tolerated_loss_in_double = 8192;

/// The largest cost of a form of V that keeps digits, in quarters of the cost of the cheapest form:
/// V costs little compared with the functions that contain it.
constexpr std::size_t quarters_for_digits = 16;

bool is_float_only(const Scene& scene) {
  const std::vector<ScalarKind>& scalars = scene.numerics.scalars;
  return scalars.size() == 1 && scalars.front() == ScalarKind::single_precision;
}

/// The loss to tolerate and the cost to accept. If float is the only scalar, a loss that is
/// tolerated in double would be most of the digits of float.
LoweringRequirements make_aim(const Scene& scene, bool has_zeros) {
  if (has_zeros) return {.max_loss = tolerated_loss, .most_quarters = quarters_for_digits};
  return {.max_loss = is_float_only(scene) ? tolerated_loss : tolerated_loss_in_double,
          .most_quarters = quarters_for_balance};
}

/// The sums of angles that may be split. Solvers in float do not split sin(a - b) into sines and
/// cosines of a and b: solvers divide by small differences, and the split form cancels.
ExpandedAngles allowed_splits(const Scene& scene, const Function& function) {
  const bool matters = is_float_only(scene) && scene.numerics.prefer != Preference::speed;
  const bool is_whole = matters && output_row(function.kind).solves_mass_matrix;
  return is_whole ? ExpandedAngles::sums : ExpandedAngles::sums_and_differences;
}

bool is_worth_lowering(const ReadableEntries& entries, const Function& recursive) {
  const std::size_t total = total_length(entries);
  return total <= always_lowered_length ||
         total <= max_length_ratio * cost(count_operations(recursive));
}

/// The cost of a form without the guards of its pivots, because both forms get guards.
std::size_t cost_without_guards(const Function& form) {
  return cost(count_operations(without_diagonal(form)));
}

void choose_by_cost(const Function& closed, const Function& recursive, FormCosts& costs) {
  const bool is_closed =
      !costs.inaccurate_entry && cost_without_guards(closed) <= cost_without_guards(recursive);
  costs.chosen_form = is_closed ? Form::closed : Form::recursive;
}

struct FormCandidate {
  const Function& function;
  const FormCosts& costs;
};

/// True if a rewriting costs no more and loses no more digits than the closed form. Also true if
/// the closed form is inaccurate or loses far more digits, and the cost of the rewriting is
/// affordable.
bool is_worthwhile(const LoweringRequirements& aim, const Function& recursive,
                   const FormCandidate& closed, const FormCandidate& rewriting) {
  const std::size_t cost = cost_without_guards(rewriting.function);
  const double loss = *rewriting.costs.closed_loss;
  const double known = *closed.costs.closed_loss;
  const std::size_t cheapest =
      std::min(cost_without_guards(closed.function), cost_without_guards(recursive));
  const bool is_free = cost <= cost_without_guards(closed.function) && loss <= known;
  const bool is_better = closed.costs.inaccurate_entry || loses_more(known, loss, aim.max_loss);
  return is_free || (is_better && is_affordable(cost, cheapest, aim.most_quarters));
}

/// The recursive forms and, unless the scene prefers speed, the errors of the functions.
class RecursiveForms {
 public:
  /// `zeros`: states near which forms are also compared.
  RecursiveForms(const Program& recursive, const Program& chosen, const Domain& domain,
                 const Scene& scene, SumZeros zeros)
      : recursive_(recursive),
        chosen_(chosen),
        domain_(domain),
        scene_(scene),
        zeros_(std::move(zeros)) {}

  /// The recursive form of a function. The form of the total energy is energy_sum() if possible.
  const Function& form(std::size_t index) {
    const auto known = energy_sums_.find(index);
    if (known != energy_sums_.end()) return known->second;
    const bool matters = scene_.numerics.prefer != Preference::speed;
    auto sum = matters ? energy_sum(recursive_, chosen_, index) : std::nullopt;
    if (!sum) return recursive_.functions[index];
    return energy_sums_.emplace(index, std::move(*sum)).first->second;
  }

  /// The errors of all forms of a function; null if the scene prefers speed.
  FormErrors* errors_of(std::size_t index) {
    if (scene_.numerics.prefer == Preference::speed) return nullptr;
    const auto known = errors_.find(index);
    if (known != errors_.end()) return &known->second;
    const Function& text = form(index);
    Points points = comparison_points(recursive_, recursive_.functions[index], domain_, zeros_);
    const auto scope =
        is_potential_or_gravity(text) ? MagnitudeScope::entry : MagnitudeScope::field;
    return &errors_.try_emplace(index, chosen_, text, std::move(points), scope).first->second;
  }

 private:
  const Program& recursive_;
  const Program& chosen_;  ///< contains the functions chosen so far
  const Domain& domain_;
  const Scene& scene_;
  std::map<std::size_t, Function> energy_sums_ = {};  ///< forms of total_energy, by index
  std::map<std::size_t, FormErrors> errors_ = {};     ///< by index of the function
  SumZeros zeros_;
};

/// Runs the passes of finish.hpp on a form. `normalized`: the name of the function of kind
/// OutputKind::normalized; set here if `function` is of this kind.
Function run_last_passes(Function function, Program& program, std::string& normalized) {
  // This branch on a kind is needed: no other output divides quaternions by their lengths.
  if (function.kind == OutputKind::normalized) normalized = function.name;
  const bool has_lengths = output_row(function.kind).is_summary || function.name == normalized;
  if (has_lengths && !normalized.empty()) {
    return with_scaled_lengths(std::move(function), normalized);
  }
  return with_guarded_pivots(std::move(function), program.constants);
}

void fill_readable_form(Program& program, std::size_t index, const Function& function,
                        const ReadableEntries& entries) {
  if (output_row(function.kind).is_summary) return;
  program.readable[index] = without_diagonal(lower_separately(entries, function, program));
}

class FormChooser {
 public:
  FormChooser(const Program& recursive, const ClosedForms& forms, const Domain& domain,
              const Scene& scene, const SumZeros* zeros)
      : recursive_(recursive),
        forms_(forms),
        scene_(scene),
        aim_(make_aim(scene, zeros != nullptr)),
        points_(mixed_magnitude_points(recursive.leaves)),
        places_(exact_places(domain)),
        recursive_forms_(recursive, result_.program, domain, scene,
                         zeros != nullptr ? *zeros : SumZeros{}) {
    result_.program = recursive;
    result_.program.readable.resize(recursive.functions.size());
  }

  Result<FormChoice> operator()() {
    for (std::size_t i = 0; i < recursive_.functions.size(); ++i) {
      Diagnostics errors = choose_form(i);
      if (!errors.empty()) return errors;
    }
    return std::move(result_);
  }

 private:
  /// The entries of a function. `dynamics` reuses the entries of other functions; the list of
  /// `dynamics` is empty if one of these functions has no entries.
  ReadableEntries& read_function_entries(std::size_t index) {
    const Function& function = recursive_.functions[index];
    ReadableEntries& entries = entries_[function.name];
    if (!output_row(function.kind).is_summary) {
      const bool is_compared = has_closed_form(forms_.functions[index]);
      FormErrors* const text = is_compared ? recursive_forms_.errors_of(index) : nullptr;
      return entries = read_entries(recursive_, forms_, index, points_, {text, places_});
    }
    for (const Field& field : function.fields) {
      const auto member = entries_.find(field.name);
      const bool is_there =
          member != entries_.end() && member->second.size() == field.entries.size();
      if (!is_there) return entries = {};
      entries.insert(entries.end(), member->second.begin(), member->second.end());
    }
    if (FormErrors* text = is_complete(entries) ? recursive_forms_.errors_of(index) : nullptr) {
      for (std::size_t i = 0; i < entries.size(); ++i) {
        entries[i]->precise.reset();  // the function of the entry has already chosen
        text->add_rewriting(text->errors_of(entries[i]->compact), i);
      }
    }
    return entries;
  }

  Diagnostics choose_form(std::size_t index) {
    const Function& function = recursive_forms_.form(index);
    ReadableEntries& entries = read_function_entries(index);
    const OutputRequest* const found = find_request(scene_, function.name);
    const OutputRequest request = found == nullptr ? OutputRequest{} : *found;
    const bool wants_closed = request.form == Form::closed;
    result_.program.functions[index] = run_last_passes(function, result_.program, normalized_);
    FormCosts costs{function.name, count_operations(result_.program.functions[index])};
    costs.is_demanded = request.form.has_value();
    costs.limited_entry = first_limited_entry(entries);
    Function closed;
    if (is_complete(entries)) {
      if (wants_closed || is_worth_lowering(entries, function)) {
        closed = compare_forms(index, function, entries, costs);
        costs.chosen_form = request.form.value_or(costs.chosen_form);
        if (costs.chosen_form == Form::closed) show_computed_forms(entries, points_);
      }
      fill_readable_form(result_.program, index, recursive_.functions[index], entries);
    } else if (wants_closed) {
      return {{Code::E608, request.span,
               fmt::format("the closed form of `{}` exceeds its limit", function.name)}};
    }
    if (costs.chosen_form == Form::closed) {
      closed.rewritten = rewritten_entries(entries, entry_count(closed));
      result_.program.functions[index] = std::move(closed);
    }
    result_.costs.push_back(std::move(costs));
    return {};
  }

  Function compare_forms(std::size_t index, const Function& recursive, ReadableEntries& entries,
                         FormCosts& costs) {
    Function closed = lower_closed_form(index, recursive, entries, costs);
    if (scene_.numerics.prefer != Preference::speed) {
      keep_digits(index, entries, closed, costs);
      choose_by_losses(index, closed, recursive, costs);
    }
    closed = run_last_passes(std::move(closed), result_.program, normalized_);
    costs.closed = count_operations(closed);
    return closed;
  }

  /// V and gravity must lose no digits. Neither must small solutions: light links cost double only
  /// a fifth of its digits, but float loses half of its digits in the same code.
  [[nodiscard]] LoweringRequirements aim_of(const Function& function) const {
    LoweringRequirements aim = aim_;
    if (is_potential_or_gravity(function) || is_small_solution(recursive_, function))
      aim.max_loss = tolerated_loss;
    return aim;
  }

  /// The entries, lowered as one function. Sets `costs.chosen_form` to closed if all entries are
  /// accurate and this function is not dearer than `recursive`, else to recursive.
  Function lower_closed_form(std::size_t index, const Function& recursive,
                             const ReadableEntries& entries, FormCosts& costs) {
    LoweringRequirements aim = aim_of(recursive);
    aim.splits = allowed_splits(scene_, recursive);
    aim.text = recursive_forms_.errors_of(index);
    LoweredEntries closed = lower_jointly(entries, recursive, result_.program, aim);
    costs.inaccurate_entry = closed.first_inaccurate;
    choose_by_cost(closed.function, recursive, costs);
    return std::move(closed.function);
  }

  /// Replaces entries by rewritings that keep digits, if these are free or worth their cost. First
  /// tries the entries that lose more than `max_loss` of the aim, then all entries that lose more
  /// than `tolerated_loss`.
  void keep_digits(std::size_t index, ReadableEntries& entries, Function& closed,
                   FormCosts& costs) {
    const Function& recursive = recursive_forms_.form(index);
    const FormErrors& text = *recursive_forms_.errors_of(index);
    const LoweringRequirements aim = aim_of(recursive);
    costs.closed_loss = text.worst_loss(result_.program, closed);
    for (const double limit : {aim.max_loss, tolerated_loss}) {
      std::optional<ReadableEntries> others = replace_lossy_entries(entries, limit);
      if (!others) continue;
      FormCosts rewriting_costs = costs;
      Function rewriting = lower_closed_form(index, recursive, *others, rewriting_costs);
      if (rewriting_costs.inaccurate_entry) continue;
      rewriting_costs.closed_loss = text.worst_loss(result_.program, rewriting);
      if (!is_worthwhile(aim, recursive, {closed, costs}, {rewriting, rewriting_costs})) continue;
      entries = std::move(*others);
      closed = std::move(rewriting);
      costs = rewriting_costs;
    }
  }

  /// Chooses the dearer form if the cheaper loses far more digits and the dearer is affordable.
  void choose_by_losses(std::size_t index, const Function& closed, const Function& recursive,
                        FormCosts& costs) {
    const bool is_closed = costs.chosen_form == Form::closed;
    const LoweringRequirements aim = aim_of(recursive);
    if (costs.inaccurate_entry || (is_closed && *costs.closed_loss <= aim.max_loss)) return;
    costs.recursive_loss =
        recursive_forms_.errors_of(index)->worst_loss(result_.program, recursive);
    const double own = is_closed ? *costs.closed_loss : *costs.recursive_loss;
    const double other = is_closed ? *costs.recursive_loss : *costs.closed_loss;
    const Function& dearer = is_closed ? recursive : closed;
    const Function& cheaper = is_closed ? closed : recursive;
    if (!loses_more(own, other, aim.max_loss)) return;
    if (!is_affordable(cost_without_guards(dearer), cost_without_guards(cheaper),
                       aim.most_quarters))
      return;
    costs.chosen_form = is_closed ? Form::recursive : Form::closed;
  }

  const Program& recursive_;
  const ClosedForms& forms_;
  const Scene& scene_;
  LoweringRequirements aim_;  ///< common to all functions
  Points points_;
  std::vector<ExactPlace> places_;  ///< minima of V
  FormChoice result_ = {};
  RecursiveForms recursive_forms_;
  std::map<std::string, ReadableEntries> entries_;
  std::string normalized_;  ///< name of the function of kind OutputKind::normalized
};

}  // namespace

Result<FormChoice> choose(const Program& recursive, const ClosedForms& forms, const Domain& domain,
                          const Scene& scene, const SumZeros* zeros) {
  Result<FormChoice> choice = FormChooser(recursive, forms, domain, scene, zeros)();
  if (!choice) return choice;
  for (Function& function : choice->program.functions) function = with_trigonometry_first(function);
  return choice;
}

}  // namespace elgen
