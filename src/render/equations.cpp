// equations: a function as formulas, with as few brackets as precedence allows.
//
//     definitions  sin_theta = sin(theta)
//     entries      m*l^2, -m*l*sin_theta
//
// An entry of at most 12 operations is written out over the leaves alone; definitions are those the
// others need.

#include <fmt/format.h>

#include "elgen/render.hpp"
#include "render/function_formulas.hpp"
#include "render/named_parts.hpp"
#include "render/symbols.hpp"

namespace elgen {
namespace {

constexpr std::size_t longest_entry = 12;

class ModelLanguage final : public Vocabulary {
 public:
  explicit ModelLanguage(const LeafNames& leaves) : Vocabulary(model_spelling), leaves_(leaves) {}

  [[nodiscard]] std::string leaf(Opcode kind, std::uint32_t number) const override {
    return leaf_text(leaves_, kind, number);
  }

 private:
  const LeafNames& leaves_;
};

class Latex final : public Vocabulary {
 public:
  explicit Latex(const Model& model) : Vocabulary(latex_spelling), symbols_(model) {}

  [[nodiscard]] std::string leaf(Opcode kind, std::uint32_t number) const override {
    return leaf_of(symbols_.leaves(), kind, number);
  }
  [[nodiscard]] std::vector<std::string> definitions(
      std::vector<std::string> names) const override {
    ModelSymbols symbols = symbols_;
    for (std::string& name : names) {
      if (!name.empty()) name = symbols.distinct(latex_symbol(name)).text();
    }
    return names;
  }

 private:
  const ModelSymbols symbols_;
};

/// Entries that are too long to be written out.
std::vector<std::uint32_t> long_entries(const Function& function,
                                        const std::vector<std::size_t>& sizes) {
  std::vector<std::uint32_t> entries = entries_of(function);
  std::erase_if(entries, [&](std::uint32_t entry) { return sizes[entry] <= longest_entry; });
  return entries;
}

/// In formulas, definitions of no more operations are easier to read where they are used than where
/// they are made.
constexpr std::size_t short_definition = 3;

std::vector<std::string> definition_names(std::vector<std::string> names,
                                          const Vocabulary& vocabulary,
                                          const std::vector<std::size_t>& sizes) {
  if (!vocabulary.spelling().is_two_dimensional) return names;
  for (std::size_t at = 0; at < names.size(); ++at) {
    if (sizes[at] <= short_definition) names[at].clear();
  }
  return vocabulary.definitions(std::move(names));
}

/// Definitions and entries by their names. `sizes`: of what is written out over the leaves alone
/// where it is short; empty where nothing is.
FunctionEquations by_names(const Program& program, const Function& function,
                           const Vocabulary& vocabulary, const std::vector<std::string>& names,
                           const std::vector<std::size_t>& sizes) {
  const std::vector<std::string> no_names(names.size());
  const FunctionFormulas with_names(program, function, vocabulary, names);
  const FunctionFormulas over_leaves(program, function, vocabulary, no_names);
  FunctionEquations result;
  for (std::uint32_t at = 0; at < names.size(); ++at) {
    if (names[at].empty()) continue;
    result.definitions.push_back({names[at], with_names.definition(at).text()});
  }
  for (const Field& field : function.fields) {
    std::vector<std::string>& texts = result.entries.emplace_back();
    for (const std::uint32_t entry : field.entries) {
      const bool is_short = !sizes.empty() && sizes[entry] <= longest_entry;
      texts.push_back((is_short ? over_leaves : with_names).entry(entry).text());
    }
  }
  return result;
}

FunctionEquations equations(const Program& program, const Function& function,
                            const Vocabulary& vocabulary, const std::vector<std::string>& told) {
  const std::vector<std::size_t> sizes = written_out_sizes(function, longest_entry);
  std::vector<std::string> names = definition_names(told, vocabulary, sizes);
  const std::vector<bool> needed = needed_for(function, long_entries(function, sizes));
  for (std::size_t at = 0; at < names.size(); ++at) {
    if (!needed[at]) names[at].clear();
  }
  return by_names(program, function, vocabulary, names, sizes);
}

/// In formulas, what has no name of its own is xi_1, xi_2, ….
std::vector<std::string> read_names(const Program& program, const Function& function,
                                    const Vocabulary& vocabulary) {
  std::vector<std::string> names = temporary_names(program, function);
  if (!vocabulary.spelling().is_two_dimensional) return names;
  const std::vector<std::string> own = own_names(program, function);
  const std::vector<std::size_t> sizes = written_out_sizes(function, longest_entry);
  std::size_t number = 0;
  for (std::size_t at = 0; at < names.size(); ++at) {
    const bool is_shown = !names[at].empty() && sizes[at] > short_definition;
    if (is_shown && own[at].empty()) names[at] = fmt::format("xi_{}", ++number);
  }
  return names;
}

/// Entries as they are read: x of x + 0/y and of x + 0*y, by which pivots are no numbers where M_ii
/// is 0. Instructions stay: their names are those of the whole function, as in code.
Function without_guards(const Program& program, Function function) {
  const std::vector<Instruction>& all = function.instructions;
  for (Field& field : function.fields) {
    for (std::uint32_t& entry : field.entries) {
      const Instruction& sum = all[entry];
      if (sum.opcode != Opcode::add) continue;
      const Instruction& guard = all[sum.b];
      const bool scales = guard.opcode == Opcode::divide || guard.opcode == Opcode::multiply;
      if (scales && loads_zero(program, all[guard.a])) entry = sum.a;
    }
  }
  return function;
}

FunctionEquations readable(const Program& program, std::size_t index,
                           const Vocabulary& vocabulary) {
  if (has_readable_form(program, index)) {
    const Function& book = program.readable[index];
    return by_names(program, book, vocabulary, vocabulary.definitions(book.names), {});
  }
  const Function& function = program.functions[index];
  return equations(program, without_guards(program, function), vocabulary,
                   read_names(program, function, vocabulary));
}

}  // namespace

bool has_readable_form(const Program& program, std::size_t index) {
  return index < program.readable.size() && !program.readable[index].fields.empty();
}

ReadFormula first_entry(const Model& model, const Program& program) {
  const Function& function = program.readable.front();
  const auto written = [&](const Vocabulary& vocabulary) {
    const std::vector<std::string> names = vocabulary.definitions(function.names);
    const FunctionFormulas formulas(program, function, vocabulary, names);
    return formulas.entry(function.fields.front().entries.front());
  };
  return {written(ModelLanguage(program.leaves)), written(Latex(model))};
}

FunctionEquations equations(const Program& program, const Function& function) {
  return equations(program, function, temporary_names(program, function));
}

FunctionEquations equations(const Program& program, const Function& function,
                            const std::vector<std::string>& names) {
  return equations(program, function, ModelLanguage(program.leaves), names);
}

FunctionEquations readable_equations(const Program& program, std::size_t index) {
  return readable(program, index, ModelLanguage(program.leaves));
}

FunctionEquations latex_equations(const Model& model, const Program& program, std::size_t index) {
  return readable(program, index, Latex(model));
}

FunctionEquations latex_equations(const Model& model, const Program& program,
                                  const Function& function, const std::vector<std::string>& names) {
  return equations(program, function, Latex(model), names);
}

}  // namespace elgen
