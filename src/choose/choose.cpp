// choose: see choose.hpp. The one place that decides between the two forms.
#include "elgen/choose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "choose/guarded_pivots.hpp"
#include "choose/readable.hpp"
#include "choose/scaled_length.hpp"
#include "lower/network/cheapest.hpp"
#include "lower/network/linearise.hpp"
#include "lower/network/turn_signs.hpp"

namespace elgen {
namespace {

/// A closed form whose entries, written out one by one, are this much longer than what the
/// recursive form executes does not become cheaper by sharing, and is not lowered. Ratios from 3 to
/// 12 give the same code for all of models/; with 2 a cheaper form is missed.
constexpr std::size_t hopeless_ratio = 6;
/// Where the recursive form is a few operations, the ratio says nothing: forms up to this length
/// are lowered whatever it is.
constexpr std::size_t always_tried = 400;

/// The terms of all entries of a function beyond which its closed form is given up: it is neither
/// read nor cheaper. Ten times as many, here and of one entry (most_terms), take 1.7 times as long
/// for the arms and chains of models/, and emit the same code.
constexpr std::size_t most_terms_together = 3'000;

using ReadableEntries = std::vector<std::optional<ReadableForm>>;  ///< of all fields

std::size_t term_count(const ClosedFunction& closed) {
  std::size_t count = 0;
  for (const ClosedField& field : closed.fields) {
    for (const auto& entry : field.entries) count += entry ? entry->numerator.size() : 0;
  }
  return count;
}

ReadableEntries read_entries(const Program& program, const Function& function,
                             const ClosedForms& forms, const ClosedFunction& closed,
                             const MixedPoints& points) {
  ReadableEntries entries;
  if (term_count(closed) > most_terms_together) return entries;
  for (std::size_t f = 0; f < closed.fields.size(); ++f) {
    for (std::size_t e = 0; e < closed.fields[f].entries.size(); ++e) {
      const std::optional<Fraction>& form = closed.fields[f].entries[e];
      auto& entry = entries.emplace_back();
      if (!form) continue;
      const auto derived = closed.is_reduced
                               ? std::nullopt
                               : as_derived(program, function, function.fields[f].entries[e]);
      entry = shortest(forms.algebra, *form, derived ? &*derived : nullptr, points);
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

Function lowered(const Expressions& together, const Function& shape, Program& program) {
  Function function = unfilled(shape);
  function.form = Form::closed;
  linearise(cheapest_network(together, function), program, function);
  return function;
}

/// All entries over one graph, as they are read or in their shortest forms, whichever is cheaper.
Function lowered_together(const ReadableEntries& entries, const Function& shape, Program& program) {
  Expressions readable;
  Expressions compact;
  for (const auto& entry : entries) {
    readable.values.push_back(copied(readable.graph, entry->readable));
    compact.values.push_back(copied(compact.graph, entry->compact));
  }
  Function first = lowered(readable, shape, program);
  Function second = lowered(compact, shape, program);
  const bool is_second = cost(count_operations(second)) < cost(count_operations(first));
  return is_second ? second : first;
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

/// Entry by entry, so that nothing is taken apart for what another entry shares.
Function lowered_one_by_one(const ReadableEntries& entries, const Function& shape,
                            Program& program) {
  Function readable{shape.kind, shape.user, shape.name, Form::closed};
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

/// The form the scene asks for; none where the cost decides.
std::optional<Form> wish_for(const Scene& scene, const Function& function) {
  const OutputRequest* request = find_request(scene, function.name);
  return request == nullptr ? std::nullopt : request->form;
}

/// Where the function was asked for.
Span place_of(const Scene& scene, const Function& function) {
  const OutputRequest* request = find_request(scene, function.name);
  if (request != nullptr && request->span.source != nullptr) return request->span;
  return scene.dropping ? scene.dropping->span : Span{};
}

class Choosing {
 public:
  Choosing(const Program& recursive, const ClosedForms& forms, const Scene& scene)
      : recursive_(recursive),
        forms_(forms),
        scene_(scene),
        points_(mixed_points(recursive.leaves)) {
    result_.program = recursive;
    result_.program.readable.resize(recursive.functions.size());
  }

  Result<Choice> operator()() {
    for (std::size_t i = 0; i < recursive_.functions.size(); ++i) {
      Diagnostics errors = choose_form(i);
      if (!errors.empty()) return errors;
    }
    known_.program.leaves = recursive_.leaves;
    known_.program.constants = result_.program.constants;
    result_.ways.push_back(std::move(known_));
    return std::move(result_);
  }

 private:
  /// `dynamics` is made of the entries of the others; one that was given up leaves it none.
  const ReadableEntries& entries_of(std::size_t index) {
    const Function& function = recursive_.functions[index];
    ReadableEntries& entries = entries_[function.name];
    if (!output_row(function.kind).repeats) {
      entries = read_entries(recursive_, function, forms_, forms_.functions[index], points_);
      if (forms_.functions[index].is_reduced) reduced_.insert(function.name);
      return entries;
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

  /// Whether terms were dropped from it: the recursive form has them all.
  [[nodiscard]] bool is_reduced(const Function& function) const {
    if (!output_row(function.kind).repeats) return reduced_.count(function.name) > 0;
    return std::any_of(function.fields.begin(), function.fields.end(),
                       [&](const Field& field) { return reduced_.count(field.name) > 0; });
  }

  Diagnostics choose_form(std::size_t index) {
    const Function& function = recursive_.functions[index];
    const ReadableEntries& entries = entries_of(index);
    const std::optional<Form> wish =
        is_reduced(function) ? Form::closed : wish_for(scene_, function);
    const bool wants_closed = wish == Form::closed;
    result_.program.functions[index] = finished(function);
    if (!is_reduced(function)) known_.program.functions.push_back(result_.program.functions[index]);
    FormCosts costs{function.name, count_operations(result_.program.functions[index])};
    costs.is_asked_for = wish_for(scene_, function).has_value();
    Function closed;
    if (is_complete(entries)) {
      fill_readable(index, entries);
      if (wants_closed || is_worth_lowering(entries, cost(costs.recursive))) {
        closed = compare(index, entries, costs);
        if (wish) costs.chosen = *wish;
      }
    } else if (wants_closed) {
      return {{Code::E608, place_of(scene_, function),
               fmt::format("the closed form of `{}` was given up", function.name)}};
    }
    if (costs.chosen == Form::closed) result_.program.functions[index] = std::move(closed);
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

  static bool is_worth_lowering(const ReadableEntries& entries, std::size_t recursive) {
    const std::size_t total = length(entries);
    return total <= always_tried || total <= hopeless_ratio * recursive;
  }

  /// The guards of pivots are not counted: whichever form is chosen gets them.
  static std::size_t cost_of(const Function& form) {
    const bool has_pivots = output_row(form.kind).gives_pivots;
    return cost(count_operations(has_pivots ? without_diagonal(form) : form));
  }

  Function compare(std::size_t index, const ReadableEntries& entries, FormCosts& costs) {
    Function closed = lowered_together(entries, recursive_.functions[index], result_.program);
    const bool is_cheaper = cost_of(closed) <= cost_of(recursive_.functions[index]);
    closed = finished(std::move(closed));
    costs.closed = count_operations(closed);
    costs.chosen = is_cheaper ? Form::closed : Form::recursive;
    return closed;
  }

  void fill_readable(std::size_t index, const ReadableEntries& entries) {
    const Function& function = recursive_.functions[index];
    if (output_row(function.kind).repeats) return;
    Function readable = lowered_one_by_one(entries, function, result_.program);
    const bool has_pivots = output_row(function.kind).gives_pivots;
    result_.program.readable[index] = has_pivots ? without_diagonal(std::move(readable)) : readable;
  }

  const Program& recursive_;
  const ClosedForms& forms_;
  const Scene& scene_;
  MixedPoints points_;
  std::map<std::string, ReadableEntries> entries_;
  std::set<std::string> reduced_;  ///< names of functions
  std::string normalized_;         ///< name of the function of that kind
  Way known_{"recursive form", {}};
  Choice result_;
};

std::string counts_text(const OperationCounts& n) {
  return fmt::format("add {} mul {} div {} sqrt {} sincos {} other {}, cost {}", n.add, n.mul,
                     n.div, n.sqrt, n.sincos, n.other, cost(n));
}

}  // namespace

Result<Choice> choose(const Program& recursive, const ClosedForms& forms, const Scene& scene) {
  return Choosing(recursive, forms, scene)();
}

std::string dump(const Choice& choice) {
  std::string text;
  for (const FormCosts& costs : choice.costs) {
    text += fmt::format("{}: {}{}\n  recursive {}\n", costs.function, name_of(costs.chosen),
                        costs.is_asked_for ? " (asked for)" : "", counts_text(costs.recursive));
    if (costs.closed) text += fmt::format("  closed    {}\n", counts_text(*costs.closed));
  }
  return text;
}

}  // namespace elgen
