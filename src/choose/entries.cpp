// entries: writes all entries of a function in the order of its fields.
#include "choose/entries.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "elgen/choose.hpp"
#include "forms/write/kept_digits.hpp"
#include "program/network/cheapest.hpp"
#include "program/network/linearise.hpp"

namespace elgen {
namespace {

/// The largest number of terms of all entries of a function together. Longer closed forms are given
/// up, because they are neither readable nor cheaper. Ten times as many terms, here and per entry
/// (most_terms), take 1.7 times as long for the arms and chains of models/, and give the same code.
constexpr std::size_t max_total_terms = 3'000;

std::size_t term_count(const ClosedFunction& closed) {
  std::size_t count = 0;
  for (const ClosedField& field : closed.fields) {
    for (const auto& entry : field.entries) count += entry ? entry->numerator.size() : 0;
  }
  return count;
}

/// All rewritings of one entry.
struct EntryRewritings {
  std::vector<Expressions> shortest_first = {};
  bool is_limited = false;  ///< rewrite_to_keep_digits() reached its limit
};

/// The rewritings of `derived` at places where its sums vanish.
std::vector<Expressions> rewritings_at_places(const Expressions& derived,
                                              std::span<const ExactPlace> places,
                                              const LeafNames& leaves) {
  std::vector<Expressions> rewritings;
  for (const ExactPlace& place : places) {
    for (const DifferenceForm form : {DifferenceForm::plain, DifferenceForm::ratio}) {
      std::optional<Expressions> rewriting = rewrite_at_place(derived, place, leaves, form);
      if (rewriting) rewritings.push_back(std::move(*rewriting));
    }
  }
  return rewritings;
}

/// The rewritings of the closed form of an entry, `precise`, `derived` unless it is null,
/// `at_places`, and the results of rewrite_to_keep_digits().
EntryRewritings all_rewritings(Rewritings of_form, std::vector<CollectedForm> precise,
                               const DerivedEntry* derived, std::vector<Expressions> at_places) {
  EntryRewritings result;
  std::vector<Expressions>& rewritings = result.shortest_first;
  for (auto* some : {&of_form.collected, &precise}) {
    for (CollectedForm& rewriting : *some) rewritings.push_back(std::move(rewriting.expressions));
  }
  if (derived != nullptr) {
    rewritings.push_back(derived->collected.expressions);
    rewritings.push_back(derived->unexpanded);
  }
  // One grouping is enough: rewrite_to_keep_digits expands brackets that hide cancelling terms.
  std::vector<Expressions> sources = std::move(of_form.plain);
  if (!rewritings.empty()) sources.push_back(rewritings.front());
  if (!at_places.empty()) sources.push_back(at_places.front());
  std::ranges::move(at_places, std::back_inserter(rewritings));
  if (derived != nullptr) {
    sources.push_back(derived->collected.expressions);
    sources.push_back(derived->unexpanded);
  }
  for (const Expressions& source : sources) {
    KeptDigits kept = rewrite_to_keep_digits(source, SquareHandling::unfactored);
    KeptDigits apart =
        rewrite_to_keep_digits(kept.rewriting.value_or(source), SquareHandling::factored);
    for (KeptDigits* made : {&kept, &apart}) {
      result.is_limited = result.is_limited || made->is_limited;
      if (!made->rewriting) continue;
      if (auto fewer = replace_redundant_calls(*made->rewriting))
        rewritings.push_back(std::move(*fewer));
      rewritings.push_back(std::move(*made->rewriting));
    }
  }
  std::ranges::stable_sort(rewritings, {},
                           [](const Expressions& rewriting) { return written_length(rewriting); });
  return result;
}

/// The cost of one entry, computed alone.
std::size_t cost_of(const Expressions& entry) {
  return cost(count_operations(LinearisedNetwork(make_network(entry)).function));
}

/// Compares the errors of the rewritings of one entry with the errors of its recursive form.
class EntryJudge {
 public:
  /// `derived`: the entry as derived; may be null.
  EntryJudge(ReadableForm& known, std::size_t entry, FormErrors& text, const Expressions* derived)
      : form_(known), entry_(entry), text_(text), derived_(derived) {}

  /// Makes `compact` accurate if a rewriting is accurate, and cheaper if only it keeps digits. Sets
  /// `precise` to a rewriting that keeps the digits which `compact` loses. rewritings() returns all
  /// rewritings.
  template <class Rewriting>
  void operator()(const Rewriting& rewritings) {
    std::optional<ErrorsAtPoints> errors = text_.errors_if_accurate(form_.compact, entry_);
    if (errors) text_.add_rewriting(*errors, entry_);
    const bool is_dear = errors && is_too_dear();
    if (!errors || is_dear || text_.may_lose_digits(*errors, entry_))
      keep_accurate_rewritings(rewritings());
    if (!errors) {
      if (rewritings_.empty()) return;
      form_.compact = rewritings_.front();
      form_.is_rewritten = true;
      errors = errors_.front();
    } else if (!form_.is_shortest) {
      form_.is_rewritten = !text_.errors_if_accurate(form_.readable, entry_);
    }
    for (const ErrorsAtPoints& rewriting : errors_) text_.add_rewriting(rewriting, entry_);
    form_.loss = text_.loss_of(*errors, entry_);
    if (is_dear || form_.loss > tolerated_loss) choose_precise_rewriting();
  }

 private:
  void keep_accurate_rewritings(EntryRewritings rewritings) {
    form_.is_limited = rewritings.is_limited;
    for (Expressions& rewriting : rewritings.shortest_first) {
      auto errors = text_.errors_if_accurate(rewriting, entry_);
      if (!errors) continue;
      rewritings_.push_back(std::move(rewriting));
      errors_.push_back(std::move(*errors));
    }
  }

  /// True if the derived entry loses digits, but costs so much less that it would be emitted.
  /// Rewritings may then be cheaper: one fraction of k/(l - x)^2 - k/(l + x)^2 + c x has the long
  /// numerator of all three terms.
  [[nodiscard]] bool is_too_dear() const {
    return derived_ != nullptr &&
           !is_affordable(cost_of(form_.compact), cost_of(*derived_), quarters_for_balance) &&
           text_.loss_of(text_.errors_of(*derived_), entry_) > tolerated_loss;
  }

  /// Keeps the cheapest rewriting without loss; without one, the rewriting with the least loss. If
  /// `compact` has no loss, a cheaper rewriting without loss replaces it.
  void choose_precise_rewriting() {
    double least = form_.loss;
    std::size_t least_cost = cost_of(form_.compact);
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < rewritings_.size(); ++i) {
      const double loss = text_.loss_of(errors_[i], entry_);
      if (std::max(loss, tolerated_loss) > std::max(least, tolerated_loss)) continue;
      const std::size_t cost = cost_of(rewritings_[i]);
      const bool is_as_good = std::max(least, loss) <= tolerated_loss;
      const bool is_better = is_as_good ? cost < least_cost : loss < least;
      if (!is_better) continue;
      least = loss;
      least_cost = cost;
      best = i;
    }
    if (!best) return;
    if (loses_more(form_.loss, least)) {
      form_.precise = std::move(rewritings_[*best]);
    } else if (form_.loss <= tolerated_loss) {
      form_.compact = std::move(rewritings_[*best]);
      form_.is_rewritten = true;
      form_.loss = least;
    }
  }

  ReadableForm& form_;
  std::size_t entry_;
  FormErrors& text_;
  const Expressions* derived_;
  std::vector<Expressions> rewritings_ = {};  ///< only accurate rewritings
  std::vector<ErrorsAtPoints> errors_ = {};
};

/// Finds the cheapest accurate form with a tolerated loss. Forms must be added in order of cost.
class CheapestForm {
 public:
  CheapestForm(const Function& shape, Program& program, const LoweringRequirements& aim)
      : shape_(shape), program_(program), aim_(aim) {}

  /// Adds a form; true if no later form can be better.
  bool try_form(const CostedNetwork& costed) {
    const bool is_dearer = form_ && !is_affordable(costed.cost, cost_, aim_.most_quarters);
    if (is_dearer && !form_->first_inaccurate) return true;
    LoweredEntries form{without_instructions(shape_)};
    form.function.form = Form::closed;
    linearise(costed.network, program_, form.function);
    if (aim_.text != nullptr) {
      form.first_inaccurate = aim_.text->first_inaccurate_entry(program_, form.function);
    }
    if (form_ && form.first_inaccurate) return false;
    const double loss = aim_.text == nullptr || form.first_inaccurate
                            ? 0
                            : aim_.text->worst_loss(program_, form.function);
    const bool is_first = !form_ || form_->first_inaccurate;
    if (!is_first && loss > aim_.max_loss) return false;
    form_ = std::move(form);
    cost_ = costed.cost;
    return !form_->first_inaccurate && loss <= aim_.max_loss;
  }

  LoweredEntries take_form() && { return std::move(*form_); }

 private:
  const Function& shape_;
  Program& program_;
  const LoweringRequirements& aim_;
  std::optional<LoweredEntries> form_ = {};
  std::size_t cost_ = 0;
};

}  // namespace

bool is_affordable(std::size_t cost, std::size_t other, std::size_t quarters) {
  constexpr std::size_t division = 4;
  return 4 * cost <= quarters * other + 4 * division;
}

bool has_closed_form(const ClosedFunction& closed) {
  return term_count(closed) <= max_total_terms &&
         std::ranges::all_of(closed.fields, [](const ClosedField& field) {
           return std::ranges::all_of(field.entries, [](const auto& form) { return !!form; });
         });
}

ReadableEntries read_entries(const Program& program, const ClosedForms& forms, std::size_t index,
                             const Points& points, AccuracySearch search) {
  const Function& function = program.functions[index];
  const ClosedFunction& closed = forms.functions[index];
  ReadableEntries entries;
  if (term_count(closed) > max_total_terms) return entries;
  for (std::size_t f = 0; f < closed.fields.size(); ++f) {
    for (std::size_t e = 0; e < closed.fields[f].entries.size(); ++e) {
      const std::optional<Fraction>& form = closed.fields[f].entries[e];
      auto& entry = entries.emplace_back();
      if (!form) continue;
      const auto derived = derived_entry(program, function, function.fields[f].entries[e]);
      Rewritings rewritings = rewritings_of(forms.algebra, *form);
      entry = choose_readable_form(rewritings.collected, derived ? &derived->collected : nullptr,
                                   points);
      if (!entry || search.text == nullptr) continue;
      EntryJudge judge(*entry, entries.size() - 1, *search.text,
                       derived ? &derived->unexpanded : nullptr);
      judge([&] {
        std::vector<Expressions> at_places;
        if (derived)
          at_places = rewritings_at_places(derived->unexpanded, search.places, program.leaves);
        return all_rewritings(std::move(rewritings), precise_rewritings(forms.algebra, *form),
                              derived ? &*derived : nullptr, std::move(at_places));
      });
    }
  }
  return entries;
}

bool is_complete(const ReadableEntries& entries) {
  return !entries.empty() && std::all_of(entries.begin(), entries.end(),
                                         [](const auto& entry) { return entry.has_value(); });
}

std::size_t total_length(const ReadableEntries& entries) {
  std::size_t total = 0;
  for (const auto& entry : entries) total += entry->length;
  return total;
}

std::vector<std::uint32_t> rewritten_entries(const ReadableEntries& entries, std::size_t count) {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (entries[i]->is_rewritten) numbers.push_back(i);
  }
  return numbers;
}

std::optional<std::size_t> first_limited_entry(const ReadableEntries& entries) {
  const auto found =
      std::ranges::find_if(entries, [](const auto& entry) { return entry && entry->is_limited; });
  if (found == entries.end()) return std::nullopt;
  return static_cast<std::size_t>(found - entries.begin());
}

std::optional<ReadableEntries> replace_lossy_entries(const ReadableEntries& entries, double limit) {
  ReadableEntries others = entries;
  bool is_changed = false;
  for (auto& entry : others) {
    if (!entry->precise || entry->loss <= limit) continue;
    entry->compact = std::move(*entry->precise);
    entry->precise.reset();
    entry->is_rewritten = true;
    is_changed = true;
  }
  if (!is_changed) return std::nullopt;
  return others;
}

void show_computed_forms(ReadableEntries& entries, const Points& points) {
  for (auto& entry : entries) {
    if (!entry->is_rewritten) continue;
    if (is_as_precise(entry->compact, entry->readable, points, LeafRounding::exact)) continue;
    entry->readable = entry->compact;
  }
}

LoweredEntries lower_jointly(const ReadableEntries& entries, const Function& shape,
                             Program& program, const LoweringRequirements& aim) {
  Expressions readable;
  Expressions compact;
  for (const auto& entry : entries) {
    const Expressions& read = entry->is_rewritten ? entry->compact : entry->readable;
    readable.values.push_back(copy_value(readable.graph, read));
    compact.values.push_back(copy_value(compact.graph, entry->compact));
  }
  CheapestForm cheapest(shape, program, aim);
  for (const ExpandedAngles which : {aim.splits, ExpandedAngles::sums}) {
    std::vector<CostedNetwork> networks =
        networks_by_cost(readable, without_instructions(shape), which);
    std::ranges::move(networks_by_cost(compact, without_instructions(shape), which),
                      std::back_inserter(networks));
    std::ranges::stable_sort(networks, {}, &CostedNetwork::cost);
    for (const CostedNetwork& costed : networks) {
      if (cheapest.try_form(costed)) return std::move(cheapest).take_form();
    }
  }
  return std::move(cheapest).take_form();
}

Program with_closed_forms(Program program, Audience reader, const ClosedFormBudget& budget) {
  const ClosedForms forms = present(program, budget);
  const Points points = mixed_magnitude_points(program.leaves);
  program.readable.resize(program.functions.size());
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    const ReadableEntries entries = read_entries(program, forms, i, points);
    if (!is_complete(entries)) continue;
    Function& function = program.functions[i];
    if (reader == Audience::code) {
      function = lower_jointly(entries, function, program, {}).function;
    } else {
      program.readable[i] = lower_separately(entries, function, program);
    }
  }
  return program;
}

}  // namespace elgen
