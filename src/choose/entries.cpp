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

/// Closed forms with more terms in all entries together are given up: they are neither readable nor
/// cheaper. Ten times as many terms, here and per entry (most_terms), take 1.7 times as long for
/// the arms and chains of models/, and give the same code.
constexpr std::size_t most_terms_together = 3'000;

std::size_t term_count(const ClosedFunction& closed) {
  std::size_t count = 0;
  for (const ClosedField& field : closed.fields) {
    for (const auto& entry : field.entries) count += entry ? entry->numerator.size() : 0;
  }
  return count;
}

/// All rewritings of an entry, shortest first: the rewritings of its closed form, precise
/// rewritings, and the derived entry unless it is null.
std::vector<Expressions> all_rewritings(Rewritings of_form, std::vector<Collected> precise,
                                        const DerivedEntry* derived) {
  std::vector<Expressions> rewritings;
  for (auto* some : {&of_form.collected, &precise}) {
    for (Collected& rewriting : *some) rewritings.push_back(std::move(rewriting.expressions));
  }
  if (derived != nullptr) {
    rewritings.push_back(derived->collected.expressions);
    rewritings.push_back(derived->unexpanded);
  }
  // One grouping is enough: rewrite_to_keep_digits expands brackets that hide cancelling terms.
  std::vector<Expressions> sources = std::move(of_form.plain);
  if (!rewritings.empty()) sources.push_back(rewritings.front());
  if (derived != nullptr) {
    sources.push_back(derived->collected.expressions);
    sources.push_back(derived->unexpanded);
  }
  for (const Expressions& source : sources) {
    auto kept = rewrite_to_keep_digits(source, Squares::whole);
    auto apart = rewrite_to_keep_digits(kept ? *kept : source, Squares::factored);
    for (auto* rewriting : {&kept, &apart}) {
      if (!*rewriting) continue;
      if (auto fewer = with_fewer_calls(**rewriting)) rewritings.push_back(std::move(*fewer));
      rewritings.push_back(std::move(**rewriting));
    }
  }
  std::ranges::stable_sort(rewritings, {},
                           [](const Expressions& rewriting) { return written_length(rewriting); });
  return rewritings;
}

/// Compares the errors of the rewritings of one entry with the errors of its recursive form.
class EntryJudge {
 public:
  EntryJudge(ReadableForm& known, std::size_t entry, TextErrors& text)
      : known_(known), entry_(entry), text_(text) {}

  /// Makes `compact` accurate if a rewriting is accurate, and sets `kept` to a rewriting that keeps
  /// the digits which `compact` loses. rewritings() returns all rewritings.
  template <class Rewriting>
  void operator()(const Rewriting& rewritings) {
    std::optional<ErrorsAtPoints> errors = text_.accurate_errors(known_.compact, entry_);
    if (!errors || text_.may_lose(*errors, entry_)) keep_accurate(rewritings());
    if (!errors) {
      if (rewritings_.empty()) return;
      known_.compact = rewritings_.front();
      known_.is_rewritten = true;
      errors = errors_.front();
    } else if (!known_.is_shortest) {
      known_.is_rewritten = !text_.accurate_errors(known_.readable, entry_);
    }
    text_.add_rewriting(*errors, entry_);
    for (const ErrorsAtPoints& rewriting : errors_) text_.add_rewriting(rewriting, entry_);
    known_.loss = text_.loss_of(*errors, entry_);
    if (known_.loss > tolerated_loss) choose_kept();
  }

 private:
  void keep_accurate(std::vector<Expressions> rewritings) {
    for (Expressions& rewriting : rewritings) {
      auto errors = text_.accurate_errors(rewriting, entry_);
      if (!errors) continue;
      rewritings_.push_back(std::move(rewriting));
      errors_.push_back(std::move(*errors));
    }
  }

  /// Keeps the cheapest rewriting without loss; without one, the rewriting with the least loss.
  void choose_kept() {
    double least = known_.loss;
    std::size_t least_cost = 0;
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < rewritings_.size(); ++i) {
      const double loss = text_.loss_of(errors_[i], entry_);
      if (std::max(loss, tolerated_loss) > std::max(least, tolerated_loss)) continue;
      const Linearised rewriting(make_network(rewritings_[i]));
      const std::size_t cost = elgen::cost(count_operations(rewriting.function));
      const bool is_as_good = best && std::max(least, loss) <= tolerated_loss;
      const bool is_better = is_as_good ? cost < least_cost : loss < least;
      if (!is_better) continue;
      least = loss;
      least_cost = cost;
      best = i;
    }
    if (best && loses_more(known_.loss, least)) known_.kept = std::move(rewritings_[*best]);
  }

  ReadableForm& known_;
  std::size_t entry_;
  TextErrors& text_;
  std::vector<Expressions> rewritings_ = {};  ///< only accurate rewritings
  std::vector<ErrorsAtPoints> errors_ = {};
};

/// Finds the cheapest accurate form with a tolerated loss. Forms must be added in order of cost.
class Cheapest {
 public:
  Cheapest(const Function& shape, Program& program, const LoweringAim& aim)
      : shape_(shape), program_(program), aim_(aim) {}

  /// Adds a form; true if no later form can be better.
  bool add(const CostedNetwork& costed) {
    const bool is_dearer = form_ && !is_affordable(costed.cost, cost_, aim_.most_quarters);
    if (is_dearer && !form_->inaccurate) return true;
    Lowered form{without_instructions(shape_)};
    form.function.form = Form::closed;
    linearise(costed.network, program_, form.function);
    if (aim_.text != nullptr) {
      form.inaccurate = aim_.text->inaccurate_entry(program_, form.function);
    }
    if (form_ && form.inaccurate) return false;
    const double loss = aim_.text == nullptr || form.inaccurate
                            ? 0
                            : aim_.text->worst_loss(program_, form.function);
    const bool is_first = !form_ || form_->inaccurate;
    if (!is_first && loss > aim_.tolerated) return false;
    form_ = std::move(form);
    cost_ = costed.cost;
    return !form_->inaccurate && loss <= aim_.tolerated;
  }

  Lowered form() && { return std::move(*form_); }

 private:
  const Function& shape_;
  Program& program_;
  const LoweringAim& aim_;
  std::optional<Lowered> form_ = {};
  std::size_t cost_ = 0;
};

}  // namespace

bool is_affordable(std::size_t cost, std::size_t other, std::size_t quarters) {
  constexpr std::size_t division = 4;
  return 4 * cost <= quarters * other + 4 * division;
}

bool has_closed_form(const ClosedFunction& closed) {
  return term_count(closed) <= most_terms_together &&
         std::ranges::all_of(closed.fields, [](const ClosedField& field) {
           return std::ranges::all_of(field.entries, [](const auto& form) { return !!form; });
         });
}

ReadableEntries read_entries(const Program& program, const ClosedForms& forms, std::size_t index,
                             const Points& points, TextErrors* text) {
  const Function& function = program.functions[index];
  const ClosedFunction& closed = forms.functions[index];
  ReadableEntries entries;
  if (term_count(closed) > most_terms_together) return entries;
  for (std::size_t f = 0; f < closed.fields.size(); ++f) {
    for (std::size_t e = 0; e < closed.fields[f].entries.size(); ++e) {
      const std::optional<Fraction>& form = closed.fields[f].entries[e];
      auto& entry = entries.emplace_back();
      if (!form) continue;
      const auto derived = derived_entry(program, function, function.fields[f].entries[e]);
      Rewritings rewritings = rewritings_of(forms.algebra, *form);
      entry = shortest(rewritings.collected, derived ? &derived->collected : nullptr, points);
      if (!entry || text == nullptr) continue;
      EntryJudge judge(*entry, entries.size() - 1, *text);
      judge([&] {
        return all_rewritings(std::move(rewritings), precise_rewritings(forms.algebra, *form),
                              derived ? &*derived : nullptr);
      });
    }
  }
  return entries;
}

bool is_complete(const ReadableEntries& entries) {
  return !entries.empty() && std::all_of(entries.begin(), entries.end(),
                                         [](const auto& entry) { return entry.has_value(); });
}

std::size_t length(const ReadableEntries& entries) {
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

std::optional<ReadableEntries> replace_lossy_entries(const ReadableEntries& entries, double limit) {
  ReadableEntries others = entries;
  bool is_changed = false;
  for (auto& entry : others) {
    if (!entry->kept || entry->loss <= limit) continue;
    entry->compact = std::move(*entry->kept);
    entry->kept.reset();
    entry->is_rewritten = true;
    is_changed = true;
  }
  if (!is_changed) return std::nullopt;
  return others;
}

void show_computed_forms(ReadableEntries& entries, const Points& points) {
  for (auto& entry : entries) {
    if (!entry->is_rewritten) continue;
    if (is_as_precise(entry->compact, entry->readable, points, Leaves::exact)) continue;
    entry->readable = entry->compact;
  }
}

Lowered lower_jointly(const ReadableEntries& entries, const Function& shape, Program& program,
                      const LoweringAim& aim) {
  Expressions readable;
  Expressions compact;
  for (const auto& entry : entries) {
    const Expressions& read = entry->is_rewritten ? entry->compact : entry->readable;
    readable.values.push_back(copy_value(readable.graph, read));
    compact.values.push_back(copy_value(compact.graph, entry->compact));
  }
  Cheapest cheapest(shape, program, aim);
  for (const Splits which : {aim.splits, Splits::sums}) {
    std::vector<CostedNetwork> networks =
        networks_by_cost(readable, without_instructions(shape), which);
    std::ranges::move(networks_by_cost(compact, without_instructions(shape), which),
                      std::back_inserter(networks));
    std::ranges::stable_sort(networks, {}, &CostedNetwork::cost);
    for (const CostedNetwork& costed : networks) {
      if (cheapest.add(costed)) return std::move(cheapest).form();
    }
  }
  return std::move(cheapest).form();
}

Program with_closed_forms(Program program, Reader reader, const PresentBudget& budget) {
  const ClosedForms forms = present(program, budget);
  const Points points = mixed_points(program.leaves);
  program.readable.resize(program.functions.size());
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    const ReadableEntries entries = read_entries(program, forms, i, points);
    if (!is_complete(entries)) continue;
    Function& function = program.functions[i];
    if (reader == Reader::code) {
      function = lower_jointly(entries, function, program, {}).function;
    } else {
      program.readable[i] = lower_separately(entries, function, program);
    }
  }
  return program;
}

}  // namespace elgen
