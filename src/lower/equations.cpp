// equations: a function as text in the model language, with as few brackets as precedence allows.
//
//     definitions  sin_theta = sin(theta)
//     entries      m*l^2, -m*l*sin_theta
//
// An entry of at most 12 operations is written out over the leaves alone; definitions are those the
// others need.
#include <fmt/format.h>

#include <algorithm>

#include "elgen/program.hpp"
#include "program_text.hpp"

namespace elgen {
namespace {

constexpr std::size_t longest_entry = 12;

enum class Precedence : std::uint8_t { sum, product, power, atom };

struct Text {
  std::string text;
  Precedence precedence = Precedence::atom;
};

std::string bracketed(const Text& text, Precedence least) {
  return text.precedence < least ? fmt::format("({})", text.text) : text.text;
}

/// A constant may be a sum or product of its own: "1/2", "1 + pi".
Precedence constant_precedence(const std::string& text) {
  int depth = 0;
  Precedence lowest = Precedence::atom;
  for (const char c : text) {
    depth += (c == '(') - (c == ')');
    if (depth > 0) continue;
    if (c == ' ') lowest = std::min(lowest, Precedence::sum);
    if (c == '/' || c == '*') lowest = std::min(lowest, Precedence::product);
    if (c == '^') lowest = std::min(lowest, Precedence::power);
  }
  return lowest;
}

class Printer {
 public:
  /// `names` says which instructions are referred to by name.
  Printer(const Program& program, const Function& function, const std::vector<std::string>& names)
      : program_(program), function_(function), names_(names) {}

  /// The instruction itself, even where it has a name.
  std::string definition(std::uint32_t at) const { return written_out(at).text; }

  std::string entry(std::uint32_t at) const { return print(at).text; }

 private:
  Text print(std::uint32_t at) const {
    return names_[at].empty() ? written_out(at) : Text{names_[at], Precedence::atom};
  }

  Text written_out(std::uint32_t at) const {
    const Instruction& i = function_.instructions[at];
    switch (i.opcode) {
      case Opcode::negate:
        return {fmt::format("-{}", bracketed(print(i.a), Precedence::product)), Precedence::sum};
      case Opcode::add:
        return {print(i.a).text + " + " + bracketed(print(i.b), Precedence::product),
                Precedence::sum};
      case Opcode::subtract:
        return {print(i.a).text + " - " + bracketed(print(i.b), Precedence::product),
                Precedence::sum};
      case Opcode::multiply:
        return product(at);
      case Opcode::divide:
        return {bracketed(print(i.a), Precedence::product) + "/" +
                    bracketed(print(i.b), Precedence::power),
                Precedence::product};
      case Opcode::square_root:
        return {fmt::format("sqrt({})", print(i.a).text)};
      case Opcode::call:
        return call(i);
      default:
        return leaf(i);
    }
  }

  Text leaf(const Instruction& i) const {
    if (i.opcode == Opcode::time) return {"t"};
    if (i.opcode == Opcode::constant) {
      const std::string& text = program_.constants[i.a].text;
      return {text, constant_precedence(text)};
    }
    const std::string& name = (*leaf_spellings(program_.leaves, i.opcode))[i.a];
    if (i.opcode == Opcode::velocity) return {fmt::format("dot({})", name)};
    if (i.opcode == Opcode::acceleration) return {fmt::format("dot(dot({}))", name)};
    return {name};
  }

  Text call(const Instruction& i) const {
    const FunctionRow& row = function_row(i.function);
    const std::string first = print(i.a).text;
    if (row.arity == 1) return {fmt::format("{}({})", row.name, first)};
    return {fmt::format("{}({}, {})", row.name, first, print(i.b).text)};
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

  Text product(std::uint32_t at) const {
    std::vector<std::uint32_t> factors;
    collect_factors(at, true, factors);
    std::string text;
    std::size_t bases = 0;
    for (auto factor = factors.begin(); factor != factors.end(); ++factor) {
      if (std::find(factors.begin(), factor, *factor) != factor) continue;
      const auto exponent = std::count(factors.begin(), factors.end(), *factor);
      // Only the first factor may be a quotient without brackets.
      const Precedence least = exponent > 1   ? Precedence::atom
                               : text.empty() ? Precedence::product
                                              : Precedence::power;
      if (!text.empty()) text += '*';
      text += bracketed(print(*factor), least);
      if (exponent > 1) text += fmt::format("^{}", exponent);
      ++bases;
    }
    return {text, bases > 1 ? Precedence::product : Precedence::power};
  }

  const Program& program_;
  const Function& function_;
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

}  // namespace

FunctionEquations equations(const Program& program, const Function& function) {
  const std::vector<std::string> names = temporary_names(program, function);
  const std::vector<std::string> no_names(names.size());
  const Printer with_names(program, function, names);
  const Printer over_leaves(program, function, no_names);
  const std::vector<std::size_t> sizes = written_out_sizes(function);
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
      const Printer& printer = sizes[entry] > longest_entry ? with_names : over_leaves;
      texts.push_back(printer.entry(entry));
    }
  }
  return result;
}

FunctionEquations readable_equations(const Program& program, std::size_t index) {
  const bool is_closed = index < program.readable.size() && !program.readable[index].fields.empty();
  if (!is_closed) return equations(program, program.functions[index]);
  const Function& function = program.readable[index];
  const std::vector<std::string> no_names(function.instructions.size());
  const Printer over_leaves(program, function, no_names);
  FunctionEquations result;
  for (const Field& field : function.fields) {
    std::vector<std::string>& texts = result.entries.emplace_back();
    for (const std::uint32_t entry : field.entries) texts.push_back(over_leaves.entry(entry));
  }
  return result;
}

}  // namespace elgen
