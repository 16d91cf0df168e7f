// Constants as forms: equality and signs.
#include "elgen/constant.hpp"

#include <cln/integer.h>
#include <cln/rational.h>

#include <algorithm>

#include "lower/constants/constant_value.hpp"

namespace elgen {

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
