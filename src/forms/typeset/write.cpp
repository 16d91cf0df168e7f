// write: see write.hpp. Rates and functions follow a quotient, as in g/l sin x, unless the
// numerator would be empty or the denominator has a rate or function.
#include "forms/typeset/write.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "forms/present/polynomial.hpp"

namespace elgen {
namespace {

using cln::cl_RA;

/// Powers are written as repeated factors. A power above this exponent is too long for a page.
constexpr std::int32_t highest_exponent = 1000;

/// Shared divisors of fewer factors than this get no name.
constexpr std::size_t fewest_named_factors = 3;

/// The operands of a quotient, and the factors after it.
struct QuotientSides {
  cl_RA number = 1;  ///< in front of the quotient
  cl_RA number_above = 1;
  cl_RA number_below = 1;
  std::vector<TextbookFactor> above;
  std::vector<TextbookFactor> below;
  std::vector<TextbookFactor> behind;
};

bool follows_quotient(const TextbookFactor& factor) {
  return factor.place.group >= FactorGroup::rate;
}

/// Replaces sin x / cos x by tan x, and cos x / sin x by 1/tan x.
std::vector<TextbookFactor> merge_tangents(std::vector<TextbookFactor> factors) {
  for (std::size_t i = 0; i + 1 < factors.size(); ++i) {
    TextbookFactor& sine = factors[i];
    const TextbookFactor& cosine = factors[i + 1];
    const bool are_opposite = sine.kind == TextbookFactorKind::sine &&
                              cosine.kind == TextbookFactorKind::cosine &&
                              sine.angle == cosine.angle && sine.exponent == -cosine.exponent;
    if (!are_opposite) continue;
    sine.kind = TextbookFactorKind::tangent;
    factors.erase(factors.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }
  return factors;
}

QuotientSides split_product(const TextbookProduct& product) {
  QuotientSides sides;
  const cl_RA number = cln::abs(product.number);
  for (TextbookFactor factor : merge_tangents(product.factors)) {
    const bool is_above = factor.exponent > 0;
    factor.exponent = std::abs(factor.exponent);
    (is_above ? sides.above : sides.below).push_back(std::move(factor));
  }
  sides.number = number;
  if (sides.below.empty()) return sides;
  sides.number = 1;
  sides.number_above = cln::numerator(number);
  sides.number_below = cln::denominator(number);
  if (std::ranges::any_of(sides.below, follows_quotient)) return sides;
  const bool has_other =
      sides.number_above != 1 || !std::ranges::all_of(sides.above, follows_quotient);
  if (!has_other) return sides;
  const auto first =
      std::stable_partition(sides.above.begin(), sides.above.end(),
                            [](const TextbookFactor& factor) { return !follows_quotient(factor); });
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

std::uint32_t TextbookWriter::operator()(const TextbookSum& sum) {
  if (sum.terms.empty()) return write_number(0);
  std::uint32_t total = write_product(sum.terms.front());
  if (cln::minusp(sum.terms.front().number)) total = instructions_.add(Opcode::negate, total);
  for (std::size_t i = 1; i < sum.terms.size(); ++i) {
    const bool is_negative = cln::minusp(sum.terms[i].number);
    total = instructions_.add(is_negative ? Opcode::subtract : Opcode::add, total,
                              write_product(sum.terms[i]));
  }
  return total;
}

std::uint32_t TextbookWriter::copy_instruction(const Function& function,
                                               std::uint32_t instruction) {
  std::vector<std::uint32_t> copies(function.instructions.size());
  const std::vector<bool> needed = needed_instructions(function, {instruction});
  for (std::uint32_t at = 0; at <= instruction; ++at) {
    if (!needed[at]) continue;
    copies[at] = instructions_.add(renumber_operands(function.instructions[at], copies));
  }
  return copies[instruction];
}

void TextbookWriter::name_shared_divisors() {
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
std::uint32_t TextbookWriter::write_product(const TextbookProduct& product) {
  if (cln::zerop(product.number)) return write_number(0);
  const QuotientSides sides = split_product(product);
  const auto multiplied = [this](std::optional<std::uint32_t> result,
                                 const std::vector<TextbookFactor>& factors) {
    for (const TextbookFactor& each : factors) {
      if (each.exponent > highest_exponent) throw TextbookLengthError();
      const std::uint32_t base = write_factor(each);
      for (std::int32_t i = 0; i < each.exponent; ++i) {
        result = result ? instructions_.add(Opcode::multiply, *result, base) : base;
      }
    }
    return result;
  };
  const auto of_number = [this](const cl_RA& value) -> std::optional<std::uint32_t> {
    if (value == 1) return std::nullopt;
    return write_number(value);
  };
  const cl_RA above = sides.number * sides.number_above;
  std::optional<std::uint32_t> result = multiplied(of_number(above), sides.above);
  const std::optional<std::uint32_t> below = multiplied(of_number(sides.number_below), sides.below);
  for (const TextbookFactor& each : sides.below) {
    if (each.kind != TextbookFactorKind::sum ||
        count_written_factors(each.sum) < fewest_named_factors)
      continue;
    ++divisors_[write_factor(each)];
  }
  if (below) result = instructions_.add(Opcode::divide, result ? *result : write_number(1), *below);
  result = multiplied(result, sides.behind);
  return result ? *result : write_number(1);
}

std::uint32_t TextbookWriter::write_factor(const TextbookFactor& factor) {
  switch (factor.kind) {
    case TextbookFactorKind::atom:
      return write_atom(factor.atom);
    case TextbookFactorKind::sine:
      return write_circular_call(FunctionId::sin, factor.angle);
    case TextbookFactorKind::cosine:
      return write_circular_call(FunctionId::cos, factor.angle);
    case TextbookFactorKind::tangent:
      return write_circular_call(FunctionId::tan, factor.angle);
    case TextbookFactorKind::sum:
      return (*this)(factor.sum);
    case TextbookFactorKind::name:
    case TextbookFactorKind::prescribed: {
      const bool is_definition = factor.kind == TextbookFactorKind::name;
      const auto& named = is_definition ? model_.definitions : model_.prescribed;
      const std::uint32_t value = (*this)(factor.sum);
      function_.names[value] = named[factor.definition].identifier;
      return value;
    }
  }
  return 0;
}

std::uint32_t TextbookWriter::write_circular_call(FunctionId function, const Monomial& angle) {
  return instructions_.add(
      {.opcode = Opcode::call, .function = function, .a = this->write_angle(angle)});
}

/// Writes an angle: the sum of exponent/divisor * argument over the exponentials in `parts`.
std::uint32_t TextbookWriter::write_angle(const Monomial& parts) {
  const auto known = angles_.find(parts);
  if (known != angles_.end()) return known->second;
  TextbookSum sum;
  for (const AtomPower& part : parts) {
    const Atom& exponential = algebra_.atoms[part.atom];
    for (TextbookProduct& term : arrange_angle(exponential.arguments[0]).terms) {
      term.number = term.number * part.exponent / exponential.divisor;
      sum.terms.push_back(std::move(term));
    }
  }
  return angles_.emplace(parts, (*this)(move_positive_first(std::move(sum)))).first->second;
}

/// The argument of an exponential; a multiple of a prescribed function is written by name.
TextbookSum TextbookWriter::arrange_angle(const Fraction& argument) {
  for (std::uint32_t i = 0; i < typed_.prescribed_values.size(); ++i) {
    const Polynomial& value = typed_.prescribed_values[i];
    if (value.empty() || !argument.denominator.empty()) continue;
    const auto ratio = ratio_of(argument.numerator, value);
    if (!ratio) continue;
    TextbookFactor name{.kind = TextbookFactorKind::prescribed,
                        .sum = arranger.factor_out({value, {}}),
                        .definition = i};
    return {{TextbookProduct{*ratio, {std::move(name)}}}};
  }
  return arranger.factor_out(argument);
}

std::uint32_t TextbookWriter::write_atom(AtomId id) {
  const auto known = atoms_.find(id);
  if (known != atoms_.end()) return known->second;
  return atoms_.emplace(id, write_new_atom(id)).first->second;
}

std::uint32_t TextbookWriter::write_new_atom(AtomId id) {
  const Atom& atom = algebra_.atoms[id];
  if (atom.kind == AtomKind::leaf) return instructions_.add(atom.leaf, atom.index);
  if (atom.kind == AtomKind::pi) {
    const std::optional<Constant> pi = make_constant({ConstantKind::pi, 0, {}, {}});
    return instructions_.add(Opcode::constant, intern_constant(*pi, program_.constants));
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

std::uint32_t TextbookWriter::write_number(const cl_RA& value) {
  return instructions_.add(Opcode::constant,
                           intern_constant(rational_constant(value), program_.constants));
}

}  // namespace elgen
