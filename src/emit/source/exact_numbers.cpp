// exact_numbers: adds the constants of functions first, then the values of parameters.
#include "emit/source/exact_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "elgen/real.hpp"
#include "emit/interface/code_interface.hpp"
#include "emit/source/source_dialect.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

constexpr int digits_of_decimals = 60;

/// The factor of pi, if the form is pi or a rational number times pi.
std::optional<cln::cl_RA> factor_of_pi(const ConstantForm& form) {
  if (form.kind == ConstantKind::pi) return cln::cl_RA(1);
  if (form.kind != ConstantKind::product || form.operands.size() != 2) return std::nullopt;
  const ConstantOperand& first = form.operands[0];
  const ConstantOperand& second = form.operands[1];
  const bool is_multiple = first.weight == 1 && second.weight == 1 &&
                           first.form.kind == ConstantKind::rational &&
                           second.form.kind == ConstantKind::pi;
  return is_multiple ? std::optional(first.form.number) : std::nullopt;
}

/// "(1, 10)" or "(1, 2, True)". Integers are written without exponents: with an exponent, the
/// language would read a float.
std::string fraction_text(const cln::cl_RA& number, const char* more) {
  return fmt::format("({}, {}{})", integer_text(cln::numerator(number)),
                     integer_text(cln::denominator(number)), more);
}

double magnitude_as_double(const cln::cl_R& value) { return to_double(cln::abs(value)); }

std::string magnitude_digits(const cln::cl_R& value) {
  return literal_text(rounded_decimal(cln::abs(value), digits_of_decimals));
}

/// (1, 10) for 1/10, (1, 2, True) for pi/2, "0.8660…" for sqrt(3)/2; "" if the number is a double.
std::string entry_text(const Constant& constant) {
  const cln::cl_R magnitude = cln::abs(constant.value);
  if (is_rational(constant)) {
    const bool is_double = exact_value(magnitude_as_double(magnitude)) == magnitude;
    return is_double ? "" : fraction_text(cln::rational(magnitude), "");
  }
  const auto factor = factor_of_pi(constant.form);
  if (factor) return fraction_text(cln::abs(*factor), ", True");
  return fmt::format("\"{}\"", magnitude_digits(magnitude));
}

/// A parameter value as a Constant. The form of an irrational value is unknown: a sum is assumed.
Constant make_constant(const cln::cl_R& value) {
  if (is_rational(value)) return rational_constant(cln::rational(value));
  Constant constant{value};
  constant.form.kind = ConstantKind::sum;
  return constant;
}

/// The non-zero constant that an instruction loads or negates; null for other instructions.
const Constant* literal_at(const Program& program, const Function& function, std::uint32_t place) {
  const Instruction& i = function.instructions[place];
  if (i.opcode == Opcode::negate) return literal_at(program, function, i.a);
  if (i.opcode != Opcode::constant || cln::zerop(program.constants[i.a].value)) return nullptr;
  return &program.constants[i.a];
}

std::string dictionary_entry(const std::string& key, const std::string& text) {
  return fmt::format("{}: {}", key, text);
}

}  // namespace

ExactNumbers::ExactNumbers(const Model& model, const Program& program,
                           const SourceSpelling& spelling) {
  if (spelling.named_number.empty()) return;
  const std::vector<ParameterArray> parameters = emitted_parameters(model, program);
  for (const Constant& constant : executed_constants(program)) add(constant, true);
  for (const ParameterArray& array : parameters) {
    for (const cln::cl_R& value : element_values(model, array)) add(make_constant(value), false);
  }
  mark_folded_constants(program);
  name_numbers(spelling);
  for (const ParameterArray& array : parameters) {
    const std::string name = "p." + name_in_language(spelling.language, array.name);
    std::size_t number = 0;
    for (const cln::cl_R& value : element_values(model, array)) {
      add_parameter(array.is_array ? fmt::format("{}[{}]", name, ++number) : name, value);
    }
  }
}

std::string ExactNumbers::name_of(const Constant& constant) const {
  const auto group = numbers_.find(magnitude_as_double(constant.value));
  if (group == numbers_.end()) return {};
  const auto number =
      std::ranges::find(group->second, magnitude_digits(constant.value), &Number::digits);
  return number == group->second.end() ? std::string() : number->name;
}

void ExactNumbers::add(const Constant& constant, bool is_executed) {
  if (cln::zerop(constant.value)) return;
  std::vector<Number>& group = numbers_[magnitude_as_double(constant.value)];
  std::string text = entry_text(constant);
  const std::string digits = magnitude_digits(constant.value);
  auto known = std::ranges::find(group, digits, &Number::digits);
  if (known == group.end()) known = group.insert(known, Number{digits, text});
  known->is_constant = known->is_constant || is_executed;
  if (known->text.starts_with('"')) known->text = std::move(text);
  if (known->text.empty()) std::rotate(group.begin(), known, known + 1);
}

void ExactNumbers::mark_folded_constants(const Program& program) {
  for (const Function& function : program.functions) {
    for (const Instruction& i : function.instructions) {
      if (operand_count(i) != 2 || i.opcode == Opcode::call) continue;
      const Constant* const second = literal_at(program, function, i.b);
      if (second == nullptr || literal_at(program, function, i.a) == nullptr) continue;
      std::vector<Number>& group = numbers_.at(magnitude_as_double(second->value));
      std::ranges::find(group, magnitude_digits(second->value), &Number::digits)->is_folded = true;
    }
  }
}

void ExactNumbers::name_numbers(const SourceSpelling& spelling) {
  for (auto& [nearest, group] : numbers_) {
    const std::string literal = source_literal(exact_value(nearest));
    if (!group.front().text.empty())
      entries_.push_back(dictionary_entry(literal, group.front().text));
    for (Number& number : group) {
      const bool is_literal = &number == &group.front() && !number.is_folded;
      if (is_literal || !number.is_constant) continue;
      const std::string& text = number.text;
      number.name = fmt::format(fmt::runtime(spelling.named_number), named_numbers_.size() + 1);
      named_numbers_.emplace_back(number.name, nearest);
      entries_.push_back(
          dictionary_entry(fmt::format("\"{}\"", number.name),
                           text.empty() ? fraction_text(exact_value(nearest), "") : text));
    }
  }
}

void ExactNumbers::add_parameter(const std::string& name, const cln::cl_R& value) {
  if (cln::zerop(value)) return;
  const std::vector<Number>& group = numbers_.at(magnitude_as_double(value));
  const auto number = std::ranges::find(group, magnitude_digits(value), &Number::digits);
  if (number == group.begin()) return;
  entries_.push_back(dictionary_entry(fmt::format("\"{}\"", name), number->text));
}

}  // namespace elgen
