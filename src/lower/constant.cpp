// Constants as forms: equality, signs and text.
#include "elgen/constant.hpp"

#include <cln/integer.h>
#include <cln/rational.h>
#include <fmt/core.h>

#include <algorithm>

#include "base/number_text.hpp"
#include "constant_value.hpp"

namespace elgen {
namespace {

/// How tightly a text holds together, weakest first.
enum class Binding : std::uint8_t { sum, product, power, atom };

struct Text {
  std::string text = {};
  Binding binding = Binding::atom;
};

Text written(const ConstantForm& form);

/// `x` as an operand of what binds at least as tightly as `binding`.
std::string operand(const Text& x, Binding binding) {
  return x.binding < binding ? "(" + x.text + ")" : x.text;
}

Text written_number(const cln::cl_RA& number) {
  const std::string text = number_text(number);
  if (cln::minusp(number)) return {text, Binding::sum};
  const bool is_integer = cln::denominator(number) == 1;
  return {text, is_integer ? Binding::atom : Binding::product};
}

Text written_sum(const std::vector<ConstantPart>& terms) {
  std::string text;
  for (const ConstantPart& term : terms) {
    const bool is_first = text.empty();
    if (term.weight < 0) {
      text += is_first ? "-" : " - ";
    } else if (!is_first) {
      text += " + ";
    }
    const bool stands_alone = is_first && term.form.kind == ConstantKind::rational;
    text += operand(written(term.form), stands_alone ? Binding::sum : Binding::product);
  }
  return {text, Binding::sum};
}

Text written_factor(const ConstantPart& factor) {
  const Text base = written(factor.form);
  if (factor.weight == 1) return base;
  const std::string exponent =
      factor.weight < 0 ? fmt::format("({})", factor.weight) : std::to_string(factor.weight);
  return {operand(base, Binding::atom) + "^" + exponent, Binding::power};
}

/// Only the first factor may be a quotient, or carry a sign, without brackets.
Text written_product(const std::vector<ConstantPart>& factors) {
  const Text first = written_factor(factors.front());
  if (factors.size() == 1) return first;
  std::string text =
      first.binding == Binding::sum && factors.front().form.kind != ConstantKind::rational
          ? operand(first, Binding::product)
          : first.text;
  for (std::size_t i = 1; i < factors.size(); ++i) {
    text += "*" + operand(written_factor(factors[i]), Binding::power);
  }
  return {text, text.front() == '-' ? Binding::sum : Binding::product};
}

Text written_call(std::string_view name, const std::vector<ConstantPart>& arguments) {
  std::string text;
  for (const ConstantPart& argument : arguments) {
    const ConstantForm form = argument.weight < 0 ? negated(argument.form) : argument.form;
    text += (text.empty() ? "" : ", ") + written(form).text;
  }
  return {fmt::format("{}({})", name, text)};
}

Text written(const ConstantForm& form) {
  switch (form.kind) {
    case ConstantKind::rational:
      return written_number(form.number);
    case ConstantKind::pi:
      return {"pi"};
    case ConstantKind::sum:
      return written_sum(form.parts);
    case ConstantKind::product:
      return written_product(form.parts);
    case ConstantKind::square_root:
      return written_call("sqrt", form.parts);
    case ConstantKind::call:
      return written_call(function_row(form.function).name, form.parts);
  }
  return {};
}

}  // namespace

bool operator==(const ConstantForm& x, const ConstantForm& y) {
  return x.kind == y.kind && x.number == y.number && x.function == y.function && x.parts == y.parts;
}

bool operator==(const ConstantPart& x, const ConstantPart& y) {
  return x.weight == y.weight && x.form == y.form;
}

ConstantForm rational_form(const cln::cl_RA& number) { return {.number = number, .parts = {}}; }

ConstantForm negated(ConstantForm x) {
  if (x.kind == ConstantKind::rational) return rational_form(-x.number);
  if (x.kind == ConstantKind::sum) {
    for (ConstantPart& term : x.parts) term.weight = -term.weight;
    const bool is_single = x.parts.size() == 1 && x.parts.front().weight > 0;
    return is_single ? ConstantForm(x.parts.front().form) : x;
  }
  if (x.kind == ConstantKind::product) {
    const auto takes_sign = [](const ConstantPart& factor) {
      const ConstantKind kind = factor.form.kind;
      return factor.weight % 2 != 0 &&
             (kind == ConstantKind::rational || kind == ConstantKind::sum);
    };
    const auto factor = std::find_if(x.parts.begin(), x.parts.end(), takes_sign);
    if (factor != x.parts.end()) {
      factor->form = negated(factor->form);
      return x;
    }
  }
  return {.kind = ConstantKind::sum, .parts = {{std::move(x), -1}}};
}

std::string text_of(const ConstantForm& form) { return written(form).text; }

Constant rational_constant(const cln::cl_RA& number) { return {number, rational_form(number)}; }

std::optional<Constant> constant_of(ConstantForm form) {
  const std::optional<EnclosedNumber> enclosure = enclosure_of(form);
  if (!enclosure) return std::nullopt;
  const bool is_told = sign_of(*enclosure).has_value();
  return Constant{is_told ? enclosure->value : cln::cl_R(0), std::move(form)};
}

bool is_rational(const Constant& constant) { return constant.form.kind == ConstantKind::rational; }

std::uint32_t position_of(const Constant& wanted, std::vector<Constant>& constants) {
  const auto known = std::find_if(constants.begin(), constants.end(), [&](const Constant& one) {
    return one.value == wanted.value && one.form == wanted.form;
  });
  const auto position = static_cast<std::uint32_t>(known - constants.begin());
  if (known == constants.end()) constants.push_back(wanted);
  return position;
}

}  // namespace elgen
