// function_formulas: a fold over one instruction, whose operands stand as formulas or by their
// names.
#include "render/function_formulas.hpp"

#include <algorithm>

#include "elgen/fold.hpp"
#include "program/constants/constants.hpp"

namespace elgen {

Formula Vocabulary::constant(const Constant& constant) const {
  return constant_formula(spelling_, constant.form);
}

Formula Vocabulary::square_root(const Formula& radicand) const {
  return elgen::square_root(spelling_, radicand);
}

Formula Vocabulary::call(FunctionId function, const std::vector<Formula>& arguments) const {
  return elgen::call(spelling_, function, arguments);
}

/// The rules of fold.hpp, on operands by their numbers.
class FunctionFormulas::Rules {
 public:
  Rules(const FunctionFormulas& all, std::uint32_t at)
      : all_(all), at_(at), vocabulary_(all.vocabulary_of(at)), spelling_(vocabulary_.spelling()) {}

  [[nodiscard]] std::uint32_t operator[](std::uint32_t operand) const { return operand; }

  [[nodiscard]] Formula constant(const Constant& constant) const {
    return vocabulary_.constant(constant);
  }
  /// A power of V'(r) has brackets.
  [[nodiscard]] Formula leaf(Opcode kind, std::uint32_t number) const {
    const bool is_long = kind == Opcode::open_value && spelling_.is_two_dimensional;
    return {vocabulary_.leaf(kind, number), is_long ? Binding::product : Binding::atom};
  }
  [[nodiscard]] Formula add(std::uint32_t x, std::uint32_t y) const {
    return sum(spelling_, {{entry(x)}, {entry(y)}});
  }
  [[nodiscard]] Formula subtract(std::uint32_t x, std::uint32_t y) const {
    return sum(spelling_, {{entry(x)}, {entry(y), true}});
  }
  /// Stacked, a fraction of integers stands in front: 3/4 g/l.
  [[nodiscard]] Formula divide(std::uint32_t x, std::uint32_t y) const {
    std::vector<std::uint32_t> above;
    if (spelling_.is_two_dimensional) collect_factors(x, above);
    if (above.size() < 2 || !is_fraction(above.front())) {
      return quotient(spelling_, entry(x), entry(y));
    }
    const std::uint32_t number = above.front();
    above.erase(above.begin());
    const Formula rest = quotient(spelling_, product_of_powers(above), entry(y));
    return product(spelling_, {entry(number), rest});
  }
  [[nodiscard]] Formula square_root(std::uint32_t x) const {
    return vocabulary_.square_root(entry(x));
  }
  /// The k of stumpff(x, k) is a whole number in all languages.
  [[nodiscard]] Formula call(FunctionId function, std::uint32_t x, std::uint32_t y) const {
    std::vector<Formula> arguments = {entry(x)};
    if (function == FunctionId::stumpff) {
      arguments.push_back(number(spelling_, order_at(all_.program_, all_.function_, y)));
    } else if (function_row(function).arity > 1) {
      arguments.push_back(entry(y));
    }
    return vocabulary_.call(function, arguments);
  }

  /// As read, the sign of a constant is its own.
  [[nodiscard]] Formula negate(std::uint32_t x) const {
    const Instruction& i = all_.function_.instructions[x];
    const bool is_constant = i.opcode == Opcode::constant && spelling_.has_powers();
    if (!is_constant) return negated(spelling_, entry(x));
    const Constant& constant = all_.program_.constants[i.a];
    return vocabulary_.constant({-constant.value, elgen::negated(constant.form)});
  }

  [[nodiscard]] Formula multiply(std::uint32_t x, std::uint32_t y) const {
    if (!spelling_.has_powers()) return product(spelling_, {entry(x), entry(y)});
    std::vector<std::uint32_t> factors;
    collect_factors(x, factors);
    collect_factors(y, factors);
    return product_of_powers(factors);
  }

 private:
  [[nodiscard]] Formula entry(std::uint32_t at) const { return all_.operand(at_, at); }

  [[nodiscard]] bool is_fraction(std::uint32_t at) const {
    const Instruction& i = all_.function_.instructions[at];
    if (i.opcode != Opcode::constant) return false;
    const Constant& constant = all_.program_.constants[i.a];
    return is_rational(constant) && cln::denominator(cln::rational(constant.value)) != 1;
  }

  /// The factors of nested products that are written out, left to right.
  void collect_factors(std::uint32_t at, std::vector<std::uint32_t>& factors) const {
    const Instruction& i = all_.function_.instructions[at];
    if (i.opcode != Opcode::multiply || !all_.names_[at].empty()) {
      factors.push_back(at);
      return;
    }
    collect_factors(i.a, factors);
    collect_factors(i.b, factors);
  }

  [[nodiscard]] Formula product_of_powers(const std::vector<std::uint32_t>& all) const {
    std::vector<Formula> different;
    for (auto factor = all.begin(); factor != all.end(); ++factor) {
      if (std::find(all.begin(), factor, *factor) != factor) continue;
      Formula base = entry(*factor);
      if (base.binding == Binding::negation) base = at_least(spelling_, base, Binding::product);
      const long exponent = std::count(all.begin(), all.end(), *factor);
      different.push_back(exponent == 1 ? base
                                        : power(spelling_, base, number(spelling_, exponent)));
    }
    return product(spelling_, different);
  }

  const FunctionFormulas& all_;
  std::uint32_t at_;
  const Vocabulary& vocabulary_;
  const Spelling& spelling_;
};

Formula FunctionFormulas::entry(std::uint32_t at) const {
  return names_[at].empty() ? definition(at) : Formula{names_[at]};
}

Formula FunctionFormulas::operand(std::uint32_t user, std::uint32_t at) const {
  const Vocabulary& words = vocabulary_of(user);
  const Instruction& i = function_.instructions[at];
  if (i.opcode == Opcode::constant && names_[at].empty()) {
    return words.constant(program_.constants[i.a]);
  }
  return &words == &vocabulary_of(at) ? entry(at) : words.converted(entry(at));
}

const Vocabulary& FunctionFormulas::vocabulary_of(std::uint32_t at) const {
  const bool is_inner = function_.instructions[at].is_inner && vocabulary_.inner() != nullptr;
  return is_inner ? *vocabulary_.inner() : vocabulary_;
}

Formula FunctionFormulas::definition(std::uint32_t at) const {
  const Rules rules(*this, at);
  return folded(rules, program_, function_.instructions[at], rules);
}

}  // namespace elgen
