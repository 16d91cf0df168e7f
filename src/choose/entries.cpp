// entries: all entries of a function, in the order of its fields.
#include "choose/entries.hpp"

#include <algorithm>
#include <iterator>

#include "choose/precise.hpp"
#include "choose/ways.hpp"
#include "lower/network/cheapest.hpp"
#include "lower/network/linearise.hpp"
#include "lower/network/turn_signs.hpp"

namespace elgen {
namespace {

/// The terms of all entries of a function beyond which its closed form is given up: it is neither
/// read nor cheaper. Ten times as many, here and of one entry (most_terms), take 1.7 times as long
/// for the arms and chains of models/, and emit the same code.
constexpr std::size_t most_terms_together = 3'000;

std::size_t term_count(const ClosedFunction& closed) {
  std::size_t count = 0;
  for (const ClosedField& field : closed.fields) {
    for (const auto& entry : field.entries) count += entry ? entry->numerator.size() : 0;
  }
  return count;
}

std::vector<const std::optional<Fraction>*> forms_of(const ClosedFunction& closed) {
  std::vector<const std::optional<Fraction>*> forms;
  for (const ClosedField& field : closed.fields) {
    for (const std::optional<Fraction>& form : field.entries) forms.push_back(&form);
  }
  return forms;
}

LossyEntry lossy_entry(std::size_t i, double loss, const ReadableForm& known,
                       const Judgement& judgement) {
  LossyEntry entry{.loss = loss};
  for (const std::vector<double>& at_point : judgement.magnitudes) {
    entry.beside.push_back(at_point[i]);
  }
  if (loss <= judgement.tolerated) {
    entry.longest = written_length(known.compact);
  } else {
    entry.tolerated = judgement.tolerated;
  }
  return entry;
}

/// Writes the entry so that it is not harmed, where a way does that.
void protect(ReadableForm& known, std::size_t entry, const BothForms& both, const Fraction& form,
             const DerivedEntry* derived, const TextErrors& text) {
  const bool is_harmed = text.are_passed_by(known.compact, entry);
  if (!is_harmed && !text.are_passed_by(known.readable, entry)) return;
  if (is_harmed) {
    auto way = harmless_way(both.forms.algebra, form, derived, text, entry);
    if (!way) return;
    known.compact = std::move(*way);
  }
  known.is_rewritten = true;
}

void append_entry(Function& to, Field& field, const Function& one) {
  const auto offset = static_cast<std::uint32_t>(to.instructions.size());
  for (Instruction i : one.instructions) {
    if (operand_count(i) > 0) i.a += offset;
    if (operand_count(i) > 1) i.b += offset;
    to.instructions.push_back(i);
  }
  to.names.resize(to.instructions.size());
  field.entries.push_back(one.fields[0].entries[0] + offset);
}

}  // namespace

ReadableEntries read_entries(const BothForms& both, const MixedPoints& points,
                             const TextErrors* text) {
  const auto& [program, function, forms, closed] = both;
  ReadableEntries entries;
  if (term_count(closed) > most_terms_together) return entries;
  for (std::size_t f = 0; f < closed.fields.size(); ++f) {
    for (std::size_t e = 0; e < closed.fields[f].entries.size(); ++e) {
      const std::optional<Fraction>& form = closed.fields[f].entries[e];
      auto& entry = entries.emplace_back();
      if (!form) continue;
      const auto derived = as_derived(program, function, function.fields[f].entries[e]);
      entry = shortest(forms.algebra, *form, derived ? &derived->written_out : nullptr, points);
      if (!entry || text == nullptr) continue;
      protect(*entry, entries.size() - 1, both, *form, derived ? &*derived : nullptr, *text);
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

bool rewrite(ReadableEntries& entries, const std::vector<double>& losses, const BothForms& both,
             const Judgement& judgement) {
  const Algebra& algebra = both.forms.algebra;
  const std::vector<const std::optional<Fraction>*> all = forms_of(both.closed);
  const std::vector<std::uint32_t> instructions = entries_of(both.function);
  const bool solves = output_row(both.function.kind).solves;
  const auto better = [&](std::size_t i) -> std::optional<Expressions> {
    if (losses[i] > tolerated_loss) {
      const auto derived = as_derived(both.program, both.function, instructions[i]);
      return more_precise(algebra, **all[i], derived ? &*derived : nullptr,
                          lossy_entry(i, losses[i], *entries[i], judgement), judgement.points);
    }
    if (!solves || !judgement.prefers_short) return std::nullopt;
    return shorter_precise(algebra, **all[i], entries[i]->compact, judgement.points);
  };
  bool is_rewritten = false;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    std::optional<Expressions> way = entries[i] ? better(i) : std::nullopt;
    if (!way) continue;
    is_rewritten = true;
    entries[i]->is_rewritten = true;
    entries[i]->compact = std::move(*way);
  }
  return is_rewritten;
}

void read_as_precisely(ReadableEntries& entries, const MixedPoints& points) {
  for (auto& entry : entries) {
    if (!entry->is_rewritten) continue;
    if (is_as_precise(entry->compact, entry->readable, points, Leaves::exact)) continue;
    entry->readable = entry->compact;
  }
}

Lowered lowered_together(const ReadableEntries& entries, const Function& shape, Program& program,
                         Splits splits, const TextErrors* text) {
  Expressions readable;
  Expressions compact;
  for (const auto& entry : entries) {
    const Expressions& read = entry->is_rewritten ? entry->compact : entry->readable;
    readable.values.push_back(copied(readable.graph, read));
    compact.values.push_back(copied(compact.graph, entry->compact));
  }
  std::optional<Lowered> cheapest;
  for (const Splits which : {splits, Splits::sums}) {
    std::vector<CostedNetwork> networks = networks_by_cost(readable, unfilled(shape), which);
    std::ranges::move(networks_by_cost(compact, unfilled(shape), which),
                      std::back_inserter(networks));
    std::ranges::stable_sort(networks, {}, &CostedNetwork::cost);
    for (const CostedNetwork& costed : networks) {
      Lowered form{unfilled(shape)};
      form.function.form = Form::closed;
      linearise(costed.network, program, form.function);
      if (text != nullptr) form.harmed = text->harmed_entry(program, form.function);
      if (!form.harmed) return form;
      if (!cheapest) cheapest = std::move(form);
    }
  }
  return std::move(*cheapest);
}

Function lowered_one_by_one(const ReadableEntries& entries, const Function& shape,
                            Program& program) {
  Function readable{
      .kind = shape.kind, .user = shape.user, .name = shape.name, .form = Form::closed};
  std::size_t next = 0;
  for (const Field& field : shape.fields) {
    Field& filled = readable.fields.emplace_back(Field{field.name, field.rows, field.columns, {}});
    for (std::size_t i = 0; i < field.entries.size(); ++i) {
      Function one;
      one.fields = {Field{"", 1, 1, {0}}};
      Network network = make_network(entries[next++]->readable);
      turn_signs(network);
      linearise(network, program, one);
      append_entry(readable, filled, one);
    }
  }
  return readable;
}

}  // namespace elgen
