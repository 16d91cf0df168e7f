// equations: a function as formulas, with as few brackets as precedence allows.
//
//     definitions  sin_theta = sin(theta)
//     entries      m*l^2, -m*l*sin_theta
//
// An entry of at most 12 operations is written out over the leaves alone; definitions are those the
// others need.
#include "equations.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace elgen::rendering {
namespace {

constexpr std::size_t longest_entry = 12;

class Walk {
 public:
  /// `names` says which instructions are referred to by name.
  Walk(const Program& program, const Function& function, const Language& language,
       const std::vector<std::string>& names)
      : program_(program), function_(function), language_(language), names_(names) {}

  /// The instruction itself, even where it has a name.
  std::string definition(std::uint32_t at) const { return written_out(at).text(); }

  std::string entry(std::uint32_t at) const { return print(at).text(); }

 private:
  Piece print(std::uint32_t at) const {
    return names_[at].empty() ? written_out(at) : Piece{names_[at]};
  }

  Piece written_out(std::uint32_t at) const {
    const Notation& notation = language_.notation;
    const Instruction& i = function_.instructions[at];
    switch (i.opcode) {
      case Opcode::negate:
        return negation(i.a);
      case Opcode::square_root:
        return square_root(notation, print(i.a));
      case Opcode::multiply:
        return product(notation, factors(at));
      case Opcode::add:
      case Opcode::subtract:
      case Opcode::divide:
        return binary(i);
      case Opcode::call:
        return called(i);
      default:
        return leaf(i);
    }
  }

  Piece negation(std::uint32_t operand) const {
    const Instruction& i = function_.instructions[operand];
    if (i.opcode != Opcode::constant) return negated(language_.notation, print(operand));
    return constant_piece(language_.notation, elgen::negated(program_.constants[i.a].form));
  }

  Piece binary(const Instruction& i) const {
    const Piece left = print(i.a);
    const Piece right = print(i.b);
    if (i.opcode == Opcode::divide) return quotient(language_.notation, left, right);
    return i.opcode == Opcode::add ? sum(language_.notation, left, right)
                                   : difference(language_.notation, left, right);
  }

  Piece called(const Instruction& i) const {
    std::vector<Piece> arguments = {print(i.a)};
    if (operand_count(i) > 1) arguments.push_back(print(i.b));
    return call(language_.notation, i.function, arguments);
  }

  Piece leaf(const Instruction& i) const {
    const auto dotted = [&](std::string_view dots, const Symbol& symbol) {
      return Piece{fmt::format(fmt::runtime(dots), symbol.base) + symbol.scripts};
    };
    const Symbols& symbols = language_.symbols;
    switch (i.opcode) {
      case Opcode::constant:
        return constant_piece(language_.notation, program_.constants[i.a].form);
      case Opcode::parameter:
        return {symbols.parameters[i.a].text()};
      case Opcode::coordinate:
        return {symbols.coordinates[i.a].text()};
      case Opcode::velocity:
        if (symbols.are_own[i.a]) return {symbols.velocities[i.a].text()};
        return dotted(language_.notation.rate, symbols.velocities[i.a]);
      case Opcode::acceleration:
        return dotted(
            symbols.are_own[i.a] ? language_.notation.rate : language_.notation.second_rate,
            symbols.velocities[i.a]);
      case Opcode::input:
        return {symbols.inputs[i.a].text()};
      default:
        return {"t"};
    }
  }

  /// The factors of nested products that are written out, left to right.
  void collect_factors(std::uint32_t at, bool is_root, std::vector<std::uint32_t>& factors) const {
    const Instruction& i = function_.instructions[at];
    if (i.opcode != Opcode::multiply || (!is_root && !names_[at].empty())) {
      factors.push_back(at);
      return;
    }
    collect_factors(i.a, false, factors);
    collect_factors(i.b, false, factors);
  }

  std::vector<Factor> factors(std::uint32_t at) const {
    std::vector<std::uint32_t> all;
    collect_factors(at, true, all);
    std::vector<Factor> different;
    for (auto factor = all.begin(); factor != all.end(); ++factor) {
      if (std::find(all.begin(), factor, *factor) != factor) continue;
      different.push_back({print(*factor), std::count(all.begin(), all.end(), *factor)});
    }
    return different;
  }

  const Program& program_;
  const Function& function_;
  const Language& language_;
  const std::vector<std::string>& names_;
};

/// Operations of each instruction written out over the leaves alone; counted up to just beyond the
/// limit.
std::vector<std::size_t> written_out_sizes(const Function& function) {
  std::vector<std::size_t> sizes;
  for (const Instruction& i : function.instructions) {
    const std::size_t operands = operand_count(i);
    std::size_t size = operands > 0 ? 1 + sizes[i.a] : 0;
    if (operands > 1) size += sizes[i.b];
    sizes.push_back(std::min(size, longest_entry + 1));
  }
  return sizes;
}

/// What entries too long to be written out are made of, as far as it is not written out itself.
std::vector<bool> needed_instructions(const Function& function,
                                      const std::vector<std::size_t>& sizes) {
  std::vector<bool> needed(sizes.size(), false);
  for (const Field& field : function.fields) {
    for (const std::uint32_t entry : field.entries) {
      if (sizes[entry] > longest_entry) needed[entry] = true;
    }
  }
  for (std::size_t at = needed.size(); at-- > 0;) {
    const Instruction& i = function.instructions[at];
    if (needed[at] && operand_count(i) > 0) needed[i.a] = true;
    if (needed[at] && operand_count(i) > 1) needed[i.b] = true;
  }
  return needed;
}

/// In formulas, short definitions are easier to read where they are used than where they are made.
std::vector<std::string> definition_names(const Program& program, const Function& function,
                                          const Notation& notation,
                                          const std::vector<std::size_t>& sizes) {
  constexpr std::size_t short_definition = 3;
  std::vector<std::string> names = temporary_names(program, function);
  if (!notation.is_two_dimensional) return names;
  for (std::size_t at = 0; at < names.size(); ++at) {
    const bool is_named = !names[at].empty() && sizes[at] > short_definition;
    names[at] = is_named ? latex_symbol(names[at]).text() : "";
  }
  return names;
}

}  // namespace

FunctionEquations equations(const Program& program, const Function& function,
                            const Language& language) {
  const std::vector<std::size_t> sizes = written_out_sizes(function);
  const std::vector<std::string> names =
      definition_names(program, function, language.notation, sizes);
  const std::vector<std::string> no_names(names.size());
  const Walk with_names(program, function, language, names);
  const Walk over_leaves(program, function, language, no_names);
  const std::vector<bool> needed = needed_instructions(function, sizes);
  FunctionEquations result;
  for (std::uint32_t at = 0; at < names.size(); ++at) {
    if (needed[at] && !names[at].empty()) {
      result.definitions.push_back({names[at], with_names.definition(at)});
    }
  }
  for (const Field& field : function.fields) {
    std::vector<std::string>& texts = result.entries.emplace_back();
    for (const std::uint32_t entry : field.entries) {
      const Walk& walk = sizes[entry] > longest_entry ? with_names : over_leaves;
      texts.push_back(walk.entry(entry));
    }
  }
  return result;
}

FunctionEquations written_out(const Program& program, const Function& function,
                              const Language& language) {
  const std::vector<std::string> no_names(function.instructions.size());
  const Walk over_leaves(program, function, language, no_names);
  FunctionEquations result;
  for (const Field& field : function.fields) {
    std::vector<std::string>& texts = result.entries.emplace_back();
    for (const std::uint32_t entry : field.entries) texts.push_back(over_leaves.entry(entry));
  }
  return result;
}

}  // namespace elgen::rendering

namespace elgen {
namespace {

FunctionEquations readable(const Program& program, std::size_t index,
                           const rendering::Language& language) {
  const bool is_closed = index < program.readable.size() && !program.readable[index].fields.empty();
  return is_closed ? rendering::written_out(program, program.readable[index], language)
                   : rendering::equations(program, program.functions[index], language);
}

rendering::Language model_language(const Program& program) {
  return {rendering::text_notation(), rendering::text_symbols(program.leaves)};
}

}  // namespace

FunctionEquations equations(const Program& program, const Function& function) {
  return rendering::equations(program, function, model_language(program));
}

FunctionEquations readable_equations(const Program& program, std::size_t index) {
  return readable(program, index, model_language(program));
}

FunctionEquations latex_equations(const Model& model, const Program& program, std::size_t index) {
  return readable(program, index, {rendering::latex_notation(), rendering::latex_symbols(model)});
}

}  // namespace elgen
