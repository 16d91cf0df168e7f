// write: see write.hpp. Rates and functions follow a quotient, as in g/l sin x, unless the
// numerator would be empty or the denominator has a rate or function.
#include "forms/typeset/write.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "forms/present/polynomial.hpp"

namespace elgen {
namespace {

using cln::cl_RA;

/// Powers are written as repeated factors. A higher power is too long for a page.
constexpr std::int32_t highest_exponent = 1000;

/// Shared divisors with fewer factors get no name.
constexpr std::size_t shortest_shared = 3;

/// The operands of a quotient, and the factors after it.
struct QuotientSides {
  cl_RA number = 1;  ///< in front of the quotient
  cl_RA number_above = 1;
  cl_RA number_below = 1;
  std::vector<BookFactor> above;
  std::vector<BookFactor> below;
  std::vector<BookFactor> behind;
};

bool is_behind(const BookFactor& factor) { return factor.place.group >= FactorGroup::rate; }

/// Replaces sin x / cos x by tan x, and cos x / sin x by 1/tan x.
std::vector<BookFactor> with_tangents(std::vector<BookFactor> factors) {
  for (std::size_t i = 0; i + 1 < factors.size(); ++i) {
    BookFactor& sine = factors[i];
    const BookFactor& cosine = factors[i + 1];
    const bool are_opposite = sine.kind == BookFactorKind::sine &&
                              cosine.kind == BookFactorKind::cosine && sine.angle == cosine.angle &&
                              sine.exponent == -cosine.exponent;
    if (!are_opposite) continue;
    sine.kind = BookFactorKind::tangent;
    factors.erase(factors.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }
  return factors;
}

QuotientSides sides_of(const BookProduct& product) {
  QuotientSides sides;
  const cl_RA number = cln::abs(product.number);
  for (BookFactor factor : with_tangents(product.factors)) {
    const bool is_above = factor.exponent > 0;
    factor.exponent = std::abs(factor.exponent);
    (is_above ? sides.above : sides.below).push_back(std::move(factor));
  }
  sides.number = number;
  if (sides.below.empty()) return sides;
  sides.number = 1;
  sides.number_above = cln::numerator(number);
  sides.number_below = cln::denominator(number);
  if (std::ranges::any_of(sides.below, is_behind)) return sides;
  const bool has_other = sides.number_above != 1 || !std::ranges::all_of(sides.above, is_behind);
  if (!has_other) return sides;
  const auto first =
      std::stable_partition(sides.above.begin(), sides.above.end(),
                            [](const BookFactor& factor) { return !is_behind(factor); });
  sides.behind.assign(first, sides.above.end());
  sides.above.erase(first, sides.above.end());
  if (!sides.behind.empty() && !sides.above.empty() && sides.number_below != 1) {
    sides.number_above = 1;
    sides.number_below = 1;
    sides.number = number;
  }
  return sides;
}

}  // namespace

std::uint32_t BookWriter::operator()(const BookSum& sum) {
  if (sum.terms.empty()) return number(0);
  std::uint32_t total = write_product(sum.terms.front());
  if (cln::minusp(sum.terms.front().number)) total = instructions_.add(Opcode::negate, total);
  for (std::size_t i = 1; i < sum.terms.size(); ++i) {
    const bool is_negative = cln::minusp(sum.terms[i].number);
    total = instructions_.add(is_negative ? Opcode::subtract : Opcode::add, total,
                              write_product(sum.terms[i]));
  }
  return total;
}

std::uint32_t BookWriter::copied(const Function& function, std::uint32_t instruction) {
  std::vector<std::uint32_t> copies(function.instructions.size());
  const std::vector<bool> needed = needed_instructions(function, {instruction});
  for (std::uint32_t at = 0; at <= instruction; ++at) {
    if (!needed[at]) continue;
    copies[at] = instructions_.add(renumber_operands(function.instructions[at], copies));
  }
  return copies[instruction];
}

void BookWriter::name_shared_divisors() {
  std::erase_if(divisors_, [](const auto& divisor) { return divisor.second < 2; });
  std::string letter = "Delta";
  while (std::ranges::count(program_.leaves.parameters, letter) +
             std::ranges::count(program_.leaves.q, letter) >
         0) {
    letter += "_";
  }
  std::size_t number = 0;
  for (const auto& [divisor, count] : divisors_) {
    function_.names[divisor] =
        divisors_.size() == 1 ? letter : fmt::format("{}_{}", letter, ++number);
  }
}

/// Writes a product without its sign.
std::uint32_t BookWriter::write_product(const BookProduct& product) {
  if (cln::zerop(product.number)) return number(0);
  const QuotientSides sides = sides_of(product);
  const auto multiplied = [this](std::optional<std::uint32_t> result,
                                 const std::vector<BookFactor>& factors) {
    for (const BookFactor& each : factors) {
      if (each.exponent > highest_exponent) throw TooLongForABook();
      const std::uint32_t base = factor(each);
      for (std::int32_t i = 0; i < each.exponent; ++i) {
        result = result ? instructions_.add(Opcode::multiply, *result, base) : base;
      }
    }
    return result;
  };
  const auto of_number = [this](const cl_RA& value) -> std::optional<std::uint32_t> {
    if (value == 1) return std::nullopt;
    return number(value);
  };
  const cl_RA above = sides.number * sides.number_above;
  std::optional<std::uint32_t> result = multiplied(of_number(above), sides.above);
  const std::optional<std::uint32_t> below = multiplied(of_number(sides.number_below), sides.below);
  for (const BookFactor& each : sides.below) {
    if (each.kind != BookFactorKind::sum || written_factors(each.sum) < shortest_shared) continue;
    ++divisors_[factor(each)];
  }
  if (below) result = instructions_.add(Opcode::divide, result ? *result : number(1), *below);
  result = multiplied(result, sides.behind);
  return result ? *result : number(1);
}

std::uint32_t BookWriter::factor(const BookFactor& factor) {
  switch (factor.kind) {
    case BookFactorKind::atom:
      return atom(factor.atom);
    case BookFactorKind::sine:
      return trigonometric(FunctionId::sin, factor.angle);
    case BookFactorKind::cosine:
      return trigonometric(FunctionId::cos, factor.angle);
    case BookFactorKind::tangent:
      return trigonometric(FunctionId::tan, factor.angle);
    case BookFactorKind::sum:
      return (*this)(factor.sum);
    case BookFactorKind::name:
    case BookFactorKind::prescribed: {
      const bool is_definition = factor.kind == BookFactorKind::name;
      const auto& named = is_definition ? model_.definitions : model_.prescribed;
      const std::uint32_t value = (*this)(factor.sum);
      function_.names[value] = named[factor.definition].identifier;
      return value;
    }
  }
  return 0;
}

std::uint32_t BookWriter::trigonometric(FunctionId function, const Monomial& angle) {
  return instructions_.add({.opcode = Opcode::call, .function = function, .a = this->angle(angle)});
}

/// Writes the angle of a monomial: the sum of exponent/divisor * argument over its exponentials.
std::uint32_t BookWriter::angle(const Monomial& parts) {
  const auto known = angles_.find(parts);
  if (known != angles_.end()) return known->second;
  BookSum sum;
  for (const AtomPower& part : parts) {
    const Atom& exponential = algebra_.atoms[part.atom];
    for (BookProduct& term : angle_term(exponential.arguments[0]).terms) {
      term.number = term.number * part.exponent / exponential.divisor;
      sum.terms.push_back(std::move(term));
    }
  }
  return angles_.emplace(parts, (*this)(positive_first(std::move(sum)))).first->second;
}

/// The argument of an exponential; a multiple of a prescribed function is written by name.
BookSum BookWriter::angle_term(const Fraction& argument) {
  for (std::uint32_t i = 0; i < typed_.prescribed.size(); ++i) {
    const Polynomial& value = typed_.prescribed[i];
    if (value.empty() || !argument.denominator.empty()) continue;
    const auto ratio = ratio_of(argument.numerator, value);
    if (!ratio) continue;
    BookFactor name{.kind = BookFactorKind::prescribed,
                    .sum = arranger.factor_out({value, {}}),
                    .definition = i};
    return {{BookProduct{*ratio, {std::move(name)}}}};
  }
  return arranger.factor_out(argument);
}

std::uint32_t BookWriter::atom(AtomId id) {
  const auto known = atoms_.find(id);
  if (known != atoms_.end()) return known->second;
  return atoms_.emplace(id, new_atom(id)).first->second;
}

std::uint32_t BookWriter::new_atom(AtomId id) {
  const Atom& atom = algebra_.atoms[id];
  if (atom.kind == AtomKind::leaf) return instructions_.add(atom.leaf, atom.index);
  if (atom.kind == AtomKind::pi) {
    const std::optional<Constant> pi = constant_of({ConstantKind::pi, 0, {}, {}});
    return instructions_.add(Opcode::constant, position_of(*pi, program_.constants));
  }
  std::vector<std::uint32_t> arguments;
  for (const Fraction& argument : atom.arguments) {
    arguments.push_back((*this)(arranger.factor_out(argument)));
  }
  if (atom.kind == AtomKind::root) return instructions_.add(Opcode::square_root, arguments[0]);
  Instruction call{.opcode = Opcode::call, .function = atom.function, .a = arguments[0]};
  if (arguments.size() > 1) call.b = arguments[1];
  return instructions_.add(call);
}

std::uint32_t BookWriter::number(const cl_RA& value) {
  return instructions_.add(Opcode::constant,
                           position_of(rational_constant(value), program_.constants));
}

}  // namespace elgen
