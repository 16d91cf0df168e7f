// statements: one pass over the instructions, the text of each kept until it is used.
// -(a*b) is written -a * b and (-a)*b likewise: both round to the same number.
#include "statements.hpp"

#include <utility>

#include "stamp.hpp"

namespace elgen {
namespace {

bool begins_with_minus(const Term& term) { return !term.text.empty() && term.text[0] == '-'; }

std::string bracketed(const std::string& text) { return "(" + text + ")"; }

/// A first operand: nothing stands before it.
std::string left(const Term& term, Precedence precedence) {
  return term.precedence < precedence ? bracketed(term.text) : term.text;
}

/// A second operand: evaluated before the operator, so an equal precedence needs brackets.
std::string right(const Term& term, Precedence precedence) {
  const bool binds_tighter = term.precedence > precedence;
  return binds_tighter && !begins_with_minus(term) ? term.text : bracketed(term.text);
}

Term binary(const Term& a, const char* sign, const Term& b, Precedence precedence) {
  return {left(a, precedence) + sign + right(b, precedence), precedence};
}

Term negated(const Term& a) {
  const bool needs_brackets = a.precedence == Precedence::sum || begins_with_minus(a);
  const Precedence precedence =
      a.precedence == Precedence::product && !needs_brackets ? Precedence::product
                                                             : Precedence::negation;
  return {"-" + (needs_brackets ? bracketed(a.text) : a.text), precedence};
}

class Writer {
 public:
  Writer(const Program& program, const Function& function, const Spelling& spelling)
      : program_(program), function_(function), spelling_(spelling) {
    names_ = temporary_names(program, function);
    for (std::string& name : names_) {
      if (!name.empty()) name = unique(spelling.temporary(name));
    }
  }

  FunctionBody body() {
    for (std::size_t i = 0; i < function_.instructions.size(); ++i) {
      terms_.push_back(settled(i, term(function_.instructions[i])));
    }
    for (const Field& field : function_.fields) {
      std::vector<std::string>& entries = body_.entries.emplace_back();
      for (const std::uint32_t entry : field.entries) entries.push_back(terms_[entry].text);
    }
    return std::move(body_);
  }

 private:
  Term term(const Instruction& i) const {
    switch (i.opcode) {
      case Opcode::constant:
        return spelling_.constant(program_.constants[i.a]);
      case Opcode::negate:
        return negated(terms_[i.a]);
      case Opcode::add:
        return binary(terms_[i.a], " + ", terms_[i.b], Precedence::sum);
      case Opcode::subtract:
        return binary(terms_[i.a], " - ", terms_[i.b], Precedence::sum);
      case Opcode::multiply:
        return binary(terms_[i.a], " * ", terms_[i.b], Precedence::product);
      case Opcode::divide:
        return binary(terms_[i.a], " / ", terms_[i.b], Precedence::product);
      case Opcode::square_root:
        return {spelling_.square_root(terms_[i.a].text)};
      case Opcode::call:
        return {spelling_.call(i.function, arguments(i))};
      default:
        return {spelling_.leaf(i)};
    }
  }

  std::string arguments(const Instruction& i) const {
    const bool has_two = operand_count(i) == 2;
    return has_two ? terms_[i.a].text + ", " + terms_[i.b].text : terms_[i.a].text;
  }

  /// A named value becomes a statement, and so does one too long to be written out.
  Term settled(std::size_t i, Term term) {
    std::string name = names_[i];
    if (name.empty() && term.text.size() > longest_expression) {
      name = unique("x_" + short_hash(term.text));
    }
    if (name.empty()) return term;
    body_.statements.push_back({name, std::move(term.text)});
    return {name};
  }

  std::string unique(std::string name) {
    while (!taken_.insert(name).second) name += '_';
    return name;
  }

  const Program& program_;
  const Function& function_;
  const Spelling& spelling_;
  std::vector<std::string> names_;
  std::set<std::string> taken_;
  std::vector<Term> terms_;
  FunctionBody body_;
};

}  // namespace

FunctionBody statements(const Program& program, const Function& function, const Spelling& spelling) {
  return Writer(program, function, spelling).body();
}

Usage usage(const Function& function) {
  Usage used;
  for (const Instruction& instruction : function.instructions) {
    used.opcodes.insert(instruction.opcode);
    if (instruction.opcode == Opcode::call) used.calls.insert(instruction.function);
  }
  return used;
}

}  // namespace elgen
