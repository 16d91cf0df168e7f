// statements: one pass over the instructions, the text of each kept until it is used.
// -(a*b) is written -a * b and (-a)*b likewise: both round to the same number.
#include "statements.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

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

std::vector<std::uint32_t> united(const Term& a, const Term& b) {
  std::vector<std::uint32_t> uses;
  std::set_union(a.uses.begin(), a.uses.end(), b.uses.begin(), b.uses.end(),
                 std::back_inserter(uses));
  return uses;
}

Term binary(const Term& a, const char* sign, const Term& b, Precedence precedence) {
  return {left(a, precedence) + sign + right(b, precedence), precedence, united(a, b)};
}

Term negated(const Term& a) {
  const bool needs_brackets = a.precedence == Precedence::sum || begins_with_minus(a);
  const Precedence precedence = a.precedence == Precedence::product && !needs_brackets
                                    ? Precedence::product
                                    : Precedence::negation;
  return {"-" + (needs_brackets ? bracketed(a.text) : a.text), precedence, a.uses};
}

class Writer {
 public:
  Writer(const Program& program, const Function& function, const Spelling& spelling,
         const std::vector<bool>& is_shared)
      : program_(program), function_(function), spelling_(spelling), is_shared_(is_shared) {
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
      std::vector<Term>& entries = body_.entries.emplace_back();
      for (const std::uint32_t entry : field.entries) entries.push_back(terms_[entry]);
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
        return {spelling_.square_root(terms_[i.a].text), Precedence::primary, terms_[i.a].uses};
      case Opcode::call:
        return call(i);
      default:
        return {spelling_.leaf(i)};
    }
  }

  Term call(const Instruction& i) const {
    const Term& a = terms_[i.a];
    if (operand_count(i) == 1)
      return {spelling_.call(i.function, a.text), Precedence::primary, a.uses};
    const Term& b = terms_[i.b];
    return {spelling_.call(i.function, a.text + ", " + b.text), Precedence::primary, united(a, b)};
  }

  /// A named value becomes a statement.
  Term settled(std::size_t i, Term term) {
    if (names_[i].empty()) return term;
    const auto index = static_cast<std::uint32_t>(body_.statements.size());
    const bool is_shared = index < is_shared_.size() && is_shared_[index];
    const std::string name = is_shared ? spelling_.shared(names_[i]) : names_[i];
    body_.statements.push_back({name, std::move(term)});
    return {name, Precedence::primary, {index}};
  }

  std::string unique(std::string name) {
    while (!taken_.insert(name).second) name += '_';
    return name;
  }

  const Program& program_;
  const Function& function_;
  const Spelling& spelling_;
  const std::vector<bool>& is_shared_;
  std::vector<std::string> names_;
  std::set<std::string> taken_;
  std::vector<Term> terms_;
  FunctionBody body_;
};

}  // namespace

FunctionBody statements(const Program& program, const Function& function, const Spelling& spelling,
                        const std::vector<bool>& is_shared) {
  return Writer(program, function, spelling, is_shared).body();
}

std::set<FunctionId> called_functions(const Function& function) {
  std::set<FunctionId> calls;
  for (const Instruction& instruction : function.instructions) {
    if (instruction.opcode == Opcode::call) calls.insert(instruction.function);
  }
  return calls;
}

}  // namespace elgen
