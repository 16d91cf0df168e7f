// choose: see choose.hpp. The one place that decides between the two forms.
#include "elgen/choose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "choose/closed_pivots.hpp"
#include "choose/entries.hpp"
#include "choose/finish.hpp"

namespace elgen {
namespace {

/// A closed form whose entries, written out one by one, are this much longer than what the
/// recursive form executes does not become cheaper by sharing, and is not lowered. Ratios from 3 to
/// 12 give the same code for all of models/; with 2 a cheaper form is missed.
constexpr std::size_t hopeless_ratio = 6;
/// Where the recursive form loses digits, a closed one that costs several times as much may be
/// better. The longest that keep them in models/, derivatives of the accelerations of two
/// links, are 12 times as long.
constexpr std::size_t hopeless_ratio_with_losses = 24;
/// Where the recursive form is a few operations, the ratio says nothing: forms up to this length
/// are lowered whatever it is.
constexpr std::size_t always_tried = 400;

/// Digits of solutions are worth any cost; those of other outputs, whose recursive form may leave
/// the noise of rounding in entries that vanish on paper, so many times its own: the mass matrix of
/// ur5 would cost 4.6 times as much, the derivatives of two_body_plane cost 1.4 times.
constexpr std::size_t most_for_digits = 4;

/// Where accuracy is not all that counts, a form is dearer by at most a quarter of the other, and
/// taken where that loses more than a quarter of the digits of double.
constexpr double most_lost = 8192;

bool is_little_dearer(std::size_t cost, std::size_t other) { return 4 * cost <= 5 * other; }

/// Whether a form of this cost is taken in the place of another that loses digits.
bool is_worth_its_digits(OutputKind kind, std::size_t cost, std::size_t other) {
  return output_row(kind).solves || cost <= most_for_digits * other;
}

/// The form the scene asks for; none where the cost decides.
std::optional<Form> wish_for(const Scene& scene, const Function& function) {
  const OutputRequest* request = find_request(scene, function.name);
  return request == nullptr ? std::nullopt : request->form;
}

/// Where the function was asked for.
Span place_of(const Scene& scene, const Function& function) {
  const OutputRequest* request = find_request(scene, function.name);
  return request == nullptr ? Span{} : request->span;
}

class Choosing {
 public:
  Choosing(const Program& recursive, const ClosedForms& forms, const Domain& domain,
           const Scene& scene)
      : recursive_(recursive),
        forms_(forms),
        domain_(domain),
        scene_(scene),
        points_(mixed_points(recursive.leaves)),
        extremes_(prefers_accuracy() ? extreme_points(recursive) : ComparisonPoints{}) {
    result_.program = recursive;
    result_.program.readable.resize(recursive.functions.size());
  }

  Result<Choice> operator()() {
    for (std::size_t i = 0; i < recursive_.functions.size(); ++i) {
      Diagnostics errors = choose_form(i);
      if (!errors.empty()) return errors;
    }
    return std::move(result_);
  }

 private:
  /// `dynamics` is made of the entries of the others; one that was given up leaves it none.
  ReadableEntries& entries_of(std::size_t index) {
    const Function& function = recursive_.functions[index];
    ReadableEntries& entries = entries_[function.name];
    if (!output_row(function.kind).repeats) {
      return entries = read_entries(both_forms(index), points_, text_of(index));
    }
    for (const Field& field : function.fields) {
      const auto member = entries_.find(field.name);
      const bool is_there =
          member != entries_.end() && member->second.size() == field.entries.size();
      if (!is_there) return entries = {};
      entries.insert(entries.end(), member->second.begin(), member->second.end());
    }
    return entries;
  }

  /// Null where digits do not matter.
  const TextErrors* text_of(std::size_t index) {
    if (scene_.numerics.prefer == Preference::speed) return nullptr;
    const auto known = texts_.find(index);
    if (known != texts_.end()) return &known->second;
    const Function& text = recursive_.functions[index];
    ComparisonPoints points = comparison_points(recursive_, text, domain_);
    points.insert(points.end(), extremes_.begin(), extremes_.end());
    return &texts_.try_emplace(index, recursive_, text, std::move(points)).first->second;
  }

  [[nodiscard]] BothForms both_forms(std::size_t index) const {
    return {recursive_, recursive_.functions[index], forms_, forms_.functions[index]};
  }

  Diagnostics choose_form(std::size_t index) {
    const Function function = with_precise_pivots(recursive_.functions[index]);
    ReadableEntries& entries = entries_of(index);
    const std::optional<Form> wish = wish_for(scene_, function);
    const bool wants_closed = wish == Form::closed;
    result_.program.functions[index] = finished(function);
    FormCosts costs{function.name, count_operations(result_.program.functions[index])};
    costs.is_asked_for = wish.has_value();
    Function closed;
    if (is_complete(entries)) {
      if (wants_closed || is_worth_lowering(index, entries, function)) {
        closed = compare(index, function, entries, costs);
        if (wish) costs.chosen = *wish;
        if (costs.chosen == Form::closed) read_as_precisely(entries, points_);
      }
      fill_readable(index, entries);
    } else if (wants_closed) {
      return {{Code::E608, place_of(scene_, function),
               fmt::format("the closed form of `{}` was given up", function.name)}};
    }
    if (costs.chosen == Form::closed) {
      closed.rewritten = rewritten_entries(entries, entry_count(closed));
      result_.program.functions[index] = std::move(closed);
    }
    result_.costs.push_back(std::move(costs));
    return {};
  }

  /// The function as it is emitted in either form: with what algebra would take out again.
  Function finished(Function function) {
    if (function.kind == OutputKind::normalized) normalized_ = function.name;
    const bool repeats = output_row(function.kind).repeats && !normalized_.empty();
    if (repeats || function.kind == OutputKind::normalized) {
      return with_scaled_lengths(std::move(function), normalized_);
    }
    if (!output_row(function.kind).gives_pivots) return function;
    return with_guarded_pivots(std::move(function), result_.program.constants);
  }

  [[nodiscard]] bool is_worth_lowering(std::size_t index, const ReadableEntries& entries,
                                       const Function& recursive) {
    const std::size_t total = length(entries);
    const std::size_t known = cost(count_operations(recursive));
    if (total <= always_tried || total <= hopeless_ratio * known) return true;
    if (!prefers_accuracy() || total > hopeless_ratio_with_losses * known) return false;
    return recursive_loss(index, recursive) > 0;
  }

  /// Of the function that is being chosen, once.
  double recursive_loss(std::size_t index, const Function& recursive) {
    const auto known = recursive_losses_.find(index);
    if (known != recursive_losses_.end()) return known->second;
    const double loss = std::ranges::max(losses_of(index, recursive));
    recursive_losses_[index] = loss;
    return loss;
  }

  /// The guards of pivots are not counted: whichever form is chosen gets them.
  static std::size_t cost_of(const Function& form) {
    const bool has_pivots = output_row(form.kind).gives_pivots;
    return cost(count_operations(has_pivots ? without_diagonal(form) : form));
  }

  /// `recursive` with its pivots by their closed forms, where those keep digits that it loses.
  Function with_precise_pivots(const Function& recursive) {
    if (!prefers_accuracy() || !output_row(recursive.kind).solves) return recursive;
    const auto pivots = std::ranges::find_if(
        recursive_.functions, [](const Function& f) { return output_row(f.kind).gives_pivots; });
    if (pivots == recursive_.functions.end()) return recursive;
    const auto index = static_cast<std::size_t>(pivots - recursive_.functions.begin());
    if (!closed_pivots_) {
      closed_pivots_ =
          closed_pivots(recursive_, *pivots, forms_, forms_.functions[index], points_of(index));
    }
    return with_closed_pivots(recursive, *pivots, *closed_pivots_, result_.program);
  }

  [[nodiscard]] bool prefers_accuracy() const {
    return scene_.numerics.prefer == Preference::accuracy;
  }

  [[nodiscard]] Scale scale() const { return prefers_accuracy() ? Scale::entry : Scale::field; }

  /// Where float is the only scalar, losses that double stands take most of its digits.
  [[nodiscard]] double tolerated() const {
    const std::vector<ScalarKind>& scalars = scene_.numerics.scalars;
    const bool is_float = scalars.size() == 1 && scalars.front() == ScalarKind::single_precision;
    return prefers_accuracy() || is_float ? tolerated_loss : most_lost;
  }

  Function compare(std::size_t index, const Function& recursive, ReadableEntries& entries,
                   FormCosts& costs) {
    Function closed = lowered(index, recursive, entries, costs);
    if (scene_.numerics.prefer != Preference::speed && !costs.harmed) {
      closed = prefers_accuracy()
                   ? keep_digits(index, recursive, entries, std::move(closed), costs)
                   : keep_most_digits(index, recursive, entries, std::move(closed), costs);
    }
    closed = finished(std::move(closed));
    costs.closed = count_operations(closed);
    return closed;
  }

  /// The entries as one function, and the form that follows from its cost and from what it harms.
  Function lowered(std::size_t index, const Function& recursive, const ReadableEntries& entries,
                   FormCosts& costs) {
    Lowered closed =
        lowered_together(entries, recursive, result_.program, splits_of(recursive), text_of(index));
    costs.harmed = closed.harmed;
    choose_by_cost(closed.function, recursive, costs);
    return std::move(closed.function);
  }

  static void choose_by_cost(const Function& closed, const Function& recursive, FormCosts& costs) {
    const bool is_closed = !costs.harmed && cost_of(closed) <= cost_of(recursive);
    costs.chosen = is_closed ? Form::closed : Form::recursive;
  }

  /// In what solves, small differences of angles divide what they are made of.
  [[nodiscard]] Splits splits_of(const Function& function) const {
    const bool is_whole = prefers_accuracy() && output_row(function.kind).solves;
    return is_whole ? Splits::sums : Splits::sums_and_differences;
  }

  /// The closed form with the entries that lose digits written in another way, and the choice
  /// between the forms where one of them loses more.
  Function keep_digits(std::size_t index, const Function& recursive, ReadableEntries& entries,
                       Function closed, FormCosts& costs) {
    std::vector<double> losses = losses_of(index, closed);
    // Those of `dynamics` are those of the functions before it.
    const bool repeats = output_row(recursive.kind).repeats;
    const Judgement judgement{.points = points_of(index), .prefers_short = true};
    ReadableEntries others = entries;
    if (!repeats && rewrite(others, losses, both_forms(index), judgement)) {
      FormCosts other_costs = costs;
      Function other = lowered(index, recursive, others, other_costs);
      if (!other_costs.harmed) {
        entries = std::move(others);
        closed = std::move(other);
        losses = losses_of(index, closed);
        costs = other_costs;
      }
    }
    costs.closed_loss = std::ranges::max(losses);
    if (costs.chosen == Form::closed && costs.closed_loss == 0) return closed;
    costs.recursive_loss = recursive_loss(index, recursive);
    if (loses_more(*costs.closed_loss, *costs.recursive_loss)) costs.chosen = Form::recursive;
    if (is_worth_its_digits(recursive.kind, cost_of(closed), cost_of(recursive)) &&
        loses_more(*costs.recursive_loss, *costs.closed_loss)) {
      costs.chosen = Form::closed;
    }
    return closed;
  }

  /// The closed form with its entries written in other ways where that is free, or a little dearer
  /// and worth it, and the choice between the forms by the same rule.
  Function keep_most_digits(std::size_t index, const Function& recursive, ReadableEntries& entries,
                            Function closed, FormCosts& costs) {
    costs.closed_loss = std::ranges::max(losses_of(index, closed));
    // Those of `dynamics` are those of the functions before it.
    if (*costs.closed_loss > 0 && !output_row(recursive.kind).repeats) {
      const std::size_t cheapest = std::min(cost_of(closed), cost_of(recursive));
      for (const double limit : {tolerated(), std::numeric_limits<double>::infinity()}) {
        if (try_ways(index, {limit, cheapest}, entries, closed, costs)) break;
      }
    }
    const std::size_t own = cost_of(closed);
    const std::size_t other = cost_of(recursive);
    choose_by_cost(closed, recursive, costs);
    if (!is_little_dearer(std::max(own, other), std::min(own, other))) return closed;
    if (costs.chosen == Form::closed && *costs.closed_loss <= tolerated()) return closed;
    costs.recursive_loss = recursive_loss(index, recursive);
    if (loses_more(*costs.closed_loss, *costs.recursive_loss, tolerated())) {
      costs.chosen = Form::recursive;
    } else if (loses_more(*costs.recursive_loss, *costs.closed_loss, tolerated())) {
      costs.chosen = Form::closed;
    }
    return closed;
  }

  /// Above the loss `limit` entries may be written in longer ways, for which the function may cost
  /// a little more than `cheapest`.
  struct Allowance {
    double limit;
    std::size_t cheapest;
  };

  /// Whether the ways together are free, or worth their cost: then they are taken.
  bool try_ways(std::size_t index, const Allowance& allowance, ReadableEntries& entries,
                Function& closed, FormCosts& costs) {
    const BothForms both = both_forms(index);
    const ComparisonPoints& points = points_of(index);
    const Judgement judgement{points, allowance.limit,
                              magnitudes_of(result_.program, closed, points, Scale::field)};
    ReadableEntries others = entries;
    if (!rewrite(others, losses_of(index, closed), both, judgement)) return false;
    FormCosts way_costs = costs;
    Function way = lowered(index, both.function, others, way_costs);
    if (way_costs.harmed) return false;
    const double loss = std::ranges::max(losses_of(index, way));
    const bool is_free = cost_of(way) <= cost_of(closed) && loss <= *costs.closed_loss;
    const bool is_worth = is_little_dearer(cost_of(way), allowance.cheapest) &&
                          loses_more(*costs.closed_loss, loss, tolerated());
    if (!is_free && !is_worth) return false;
    entries = std::move(others);
    closed = std::move(way);
    costs.closed_loss = loss;
    return true;
  }

  /// Of the function with this index, in any form. Not for speed.
  [[nodiscard]] std::vector<double> losses_of(std::size_t index, const Function& form) {
    return possible_losses(result_.program, form, points_of(index), scale());
  }

  const ComparisonPoints& points_of(std::size_t index) { return text_of(index)->points(); }

  void fill_readable(std::size_t index, const ReadableEntries& entries) {
    const Function& function = recursive_.functions[index];
    if (output_row(function.kind).repeats) return;
    Function readable = lowered_one_by_one(entries, function, result_.program);
    const bool has_pivots = output_row(function.kind).gives_pivots;
    result_.program.readable[index] = has_pivots ? without_diagonal(std::move(readable)) : readable;
  }

  const Program& recursive_;
  const ClosedForms& forms_;
  const Domain& domain_;
  const Scene& scene_;
  MixedPoints points_;
  ComparisonPoints extremes_;  ///< where accuracy counts
  std::map<std::string, ReadableEntries> entries_;
  std::map<std::size_t, TextErrors> texts_;  ///< by function
  std::string normalized_;                   ///< name of the function of that kind
  std::optional<std::vector<ClosedPivot>> closed_pivots_;
  std::map<std::size_t, double> recursive_losses_;
  Choice result_;
};

}  // namespace

Result<Choice> choose(const Program& recursive, const ClosedForms& forms, const Domain& domain,
                      const Scene& scene) {
  Result<Choice> choice = Choosing(recursive, forms, domain, scene)();
  if (!choice) return choice;
  for (Function& function : choice->program.functions) function = trigonometry_first(function);
  return choice;
}

}  // namespace elgen
