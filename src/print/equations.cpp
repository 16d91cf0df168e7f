// equations: instructions of a function -> readable formulas. Repeated factors become powers, and
// definitions keep their names.
//
//     2 = multiply 0 0; 3 = multiply 1 2; 4 = cos 3        cos(m*x^2)
//
// An entry of at most 12 operations is written out over the leaves. Only definitions that longer
// entries need are listed.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "elgen/fold.hpp"
#include "elgen/page.hpp"
#include "model/symbols.hpp"
#include "print/sections.hpp"

namespace elgen {
namespace {

constexpr std::size_t longest_entry = 12;

bool is_negation(const Formula& formula) {
  switch (formula.kind) {
    case FormulaKind::negative:
      return true;
    case FormulaKind::number:
      return cln::minusp(formula.number);
    case FormulaKind::product:
    case FormulaKind::quotient:
      return is_negation(formula.parts.front());
    default:
      return false;
  }
}

/// Prints a function over the leaves and the names of some instructions.
class FunctionPrinter {
 public:
  FunctionPrinter(const Program& program, const Function& function,
                  const LeafValues<Formula>& leaves, const Formulas& names)
      : program_(program), function_(function), leaves_(leaves), names_(names) {}

  /// The formula of an instruction, even if it has a name.
  [[nodiscard]] Formula definition_formula(std::uint32_t at) const {
    return fold_instruction(*this, program_, function_.instructions[at], *this);
  }
  /// The name of an instruction, or its formula if it has no name.
  [[nodiscard]] Formula entry_formula(std::uint32_t at) const {
    return is_named(at) ? names_[at] : definition_formula(at);
  }

  // The rules of fold.hpp. Operands are indices of instructions.

  [[nodiscard]] std::uint32_t operator[](std::uint32_t operand) const { return operand; }
  [[nodiscard]] Formula constant(const Constant& constant) const {
    return constant_formula(constant.form);
  }
  [[nodiscard]] Formula leaf(Opcode kind, std::uint32_t number) const {
    return leaf_of(leaves_, kind, number);
  }
  [[nodiscard]] Formula add(std::uint32_t x, std::uint32_t y) const {
    return with_term(entry_formula(x), entry_formula(y));
  }
  [[nodiscard]] Formula subtract(std::uint32_t x, std::uint32_t y) const {
    return with_term(entry_formula(x), negative_of(entry_formula(y)));
  }
  [[nodiscard]] Formula divide(std::uint32_t x, std::uint32_t y) const {
    return quotient_of(entry_formula(x), entry_formula(y));
  }
  [[nodiscard]] Formula square_root(std::uint32_t x) const { return root_of(entry_formula(x)); }
  [[nodiscard]] Formula call(FunctionId function, std::uint32_t x, std::uint32_t y) const {
    Formulas arguments = {entry_formula(x)};
    if (function == FunctionId::stumpff) {
      arguments.push_back(number_formula(stumpff_order(program_, function_, y)));
    } else if (function_row(function).arity > 1) {
      arguments.push_back(entry_formula(y));
    }
    return call_of(function, std::move(arguments));
  }
  /// Negates a formula. A constant keeps its sign in the number: -2, not -(2).
  [[nodiscard]] Formula negate(std::uint32_t x) const {
    const Instruction& i = function_.instructions[x];
    if (i.opcode != Opcode::constant) return negative_of(entry_formula(x));
    return constant_formula(negated_form(program_.constants[i.a].form));
  }
  [[nodiscard]] Formula multiply(std::uint32_t x, std::uint32_t y) const {
    std::vector<std::uint32_t> factors;
    collect_factors(x, factors);
    collect_factors(y, factors);
    return product_of_powers(factors);
  }

 private:
  [[nodiscard]] bool is_named(std::uint32_t at) const { return !names_[at].is_empty(); }

  /// Collects the factors of nested products without names, left to right.
  void collect_factors(std::uint32_t at, std::vector<std::uint32_t>& factors) const {
    const Instruction& i = function_.instructions[at];
    if (i.opcode != Opcode::multiply || is_named(at)) {
      factors.push_back(at);
      return;
    }
    collect_factors(i.a, factors);
    collect_factors(i.b, factors);
  }

  [[nodiscard]] Formula product_of_powers(const std::vector<std::uint32_t>& all) const {
    Formulas different;
    for (auto factor = all.begin(); factor != all.end(); ++factor) {
      if (std::find(all.begin(), factor, *factor) != factor) continue;
      Formula base = entry_formula(*factor);
      if (is_negation(base)) base = group(std::move(base));
      const long exponent = std::count(all.begin(), all.end(), *factor);
      different.push_back(exponent == 1 ? std::move(base)
                                        : power_of(std::move(base), number_formula(exponent)));
    }
    return product_of(std::move(different));
  }

  const Program& program_;
  const Function& function_;
  const LeafValues<Formula>& leaves_;
  const Formulas& names_;
};

/// Entries that are too long to be written out over the leaves.
std::vector<std::uint32_t> long_entries(const Function& function,
                                        const std::vector<std::size_t>& sizes) {
  std::vector<std::uint32_t> entries = entries_of(function);
  std::erase_if(entries, [&](std::uint32_t entry) { return sizes[entry] <= longest_entry; });
  return entries;
}

/// A definition of at most this many operations is easier to read where it is used.
constexpr std::size_t short_definition = 3;

/// formula_of(name) for each name; an empty formula for an empty name.
template <class F>
Formulas formulas_of(const std::vector<std::string>& names, const F& formula_of) {
  Formulas formulas;
  for (const std::string& name : names) {
    formulas.push_back(name.empty() ? Formula{} : formula_of(name));
  }
  return formulas;
}

LeafValues<Formula> leaf_formulas(const LeafNames& leaves) {
  const auto nothing = [](const std::string&) { return Formula{}; };
  LeafValues<Formula> formulas = map_leaves(nothing, leaves);
  for_each_leaf([&](Opcode kind, std::uint32_t i, const std::string&,
                    Formula& formula) { formula = name_formula(leaf_text(leaves, kind, i)); },
                leaves, formulas);
  return formulas;
}

/// Symbols for names, distinct from the symbols of the model.
Formulas symbols_of(const std::vector<std::string>& names, ModelSymbols symbols) {
  return formulas_of(names, [&symbols](const std::string& name) {
    return symbol_formula(name, symbols.make_distinct(symbol_of_name(name)));
  });
}

/// Prints definitions and entries by name. `sizes`: the number of operations of each formula over
/// the leaves, which decides if an entry is written out. If `sizes` is empty, no entry is written
/// out.
FunctionEquations named_equations(const Program& program, const Function& function,
                                  const LeafValues<Formula>& leaves, const Formulas& names,
                                  const std::vector<std::size_t>& sizes) {
  const Formulas no_names(names.size());
  const FunctionPrinter with_names(program, function, leaves, names);
  const FunctionPrinter over_leaves(program, function, leaves, no_names);
  FunctionEquations result;
  for (std::uint32_t at = 0; at < names.size(); ++at) {
    if (names[at].is_empty()) continue;
    result.definitions.push_back({names[at], with_names.definition_formula(at)});
  }
  for (const Field& field : function.fields) {
    Formulas& formulas = result.entries.emplace_back();
    for (const std::uint32_t entry : field.entries) {
      const bool is_short = !sizes.empty() && sizes[entry] <= longest_entry;
      formulas.push_back((is_short ? over_leaves : with_names).entry_formula(entry));
    }
  }
  return result;
}

FunctionEquations needed_equations(const Program& program, const Function& function,
                                   const LeafValues<Formula>& leaves, Formulas names,
                                   const std::vector<std::size_t>& sizes) {
  const std::vector<bool> needed = needed_instructions(function, long_entries(function, sizes));
  for (std::size_t at = 0; at < names.size(); ++at) {
    if (!needed[at]) names[at] = {};
  }
  return named_equations(program, function, leaves, names, sizes);
}

/// Removes the names of short definitions. Other definitions that the model does not name become
/// xi_1, xi_2, ….
std::vector<std::string> readable_names(const Program& program, const Function& function,
                                        const std::vector<std::size_t>& sizes) {
  std::vector<std::string> names = temporary_names(program, function);
  const std::vector<std::string> own = context_free_names(program, function);
  std::size_t number = 0;
  for (std::size_t at = 0; at < names.size(); ++at) {
    if (sizes[at] <= short_definition) names[at].clear();
    if (!names[at].empty() && own[at].empty()) names[at] = fmt::format("xi_{}", ++number);
  }
  return names;
}

/// `function` with x in place of each entry x + 0/y or x + 0*y, which guards a pivot against
/// M_ii = 0. The instructions remain, so that names are the same as in code.
Function remove_pivot_guards(const Program& program, Function function) {
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

/// The equations of a function that has no readable form.
FunctionEquations unread_equations(const Program& program, const Function& function,
                                   const ModelSymbols& symbols) {
  const std::vector<std::size_t> sizes = expanded_sizes(function, longest_entry);
  return needed_equations(program, remove_pivot_guards(program, function), symbols.leaf_symbols(),
                          symbols_of(readable_names(program, function, sizes), symbols), sizes);
}

}  // namespace

bool has_readable_form(const Program& program, std::size_t index) {
  return index < program.readable.size() && !program.readable[index].fields.empty();
}

FunctionEquations function_equations(const Program& program, const Function& function,
                                     const std::vector<std::string>& names) {
  return needed_equations(program, function, leaf_formulas(program.leaves),
                          formulas_of(names, name_formula),
                          expanded_sizes(function, longest_entry));
}

FunctionEquations equations(const Program& program, std::size_t index) {
  const Function& function = program.functions[index];
  if (!has_readable_form(program, index)) {
    return function_equations(program, remove_pivot_guards(program, function),
                              temporary_names(program, function));
  }
  const Function& book = program.readable[index];
  return named_equations(program, book, leaf_formulas(program.leaves),
                         formulas_of(book.names, name_formula), {});
}

FunctionEquations equations(const Model& model, const Program& program, std::size_t index) {
  const ModelSymbols symbols(model, program.leaves);
  if (!has_readable_form(program, index)) {
    return unread_equations(program, program.functions[index], symbols);
  }
  const Function& book = program.readable[index];
  FunctionEquations result =
      named_equations(program, book, symbols.leaf_symbols(), symbols_of(book.names, symbols), {});
  // Fields that are too long for a book keep the definitions of the derivation.
  Function rest = program.functions[index];
  for (std::size_t i = 0; i < book.fields.size(); ++i) {
    if (!book.fields[i].entries.empty()) rest.fields[i].entries.clear();
  }
  if (entries_of(rest).empty()) return result;
  FunctionEquations added = unread_equations(program, rest, symbols);
  for (std::size_t i = 0; i < book.fields.size(); ++i) {
    if (book.fields[i].entries.empty()) result.entries[i] = std::move(added.entries[i]);
  }
  std::ranges::move(added.definitions, std::back_inserter(result.definitions));
  return result;
}

Formula first_entry_formula(const Model& model, const Program& program) {
  const ModelSymbols symbols(model, program.leaves);
  const Function& function = program.readable.front();
  return FunctionPrinter(program, function, symbols.leaf_symbols(),
                         symbols_of(function.names, symbols))
      .entry_formula(function.fields.front().entries.front());
}

}  // namespace elgen
