// state_text: a state in JSON. Decimal digits are computed in exact arithmetic, because doubles
// have too few digits.
#include "model/state_text.hpp"

#include <fmt/ranges.h>

#include "base/json.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

std::string parameters_json(const Model& model, const std::vector<cln::cl_R>& values, int digits) {
  std::vector<std::string> members;
  for (const ParameterArray& array : model.parameter_arrays) {
    const auto first = values.begin() + array.first;
    const std::string numbers = rounded_decimal_texts({first, first + array.count}, digits);
    members.push_back(fmt::format(fmt::runtime(array.is_array ? "{}: [{}]" : "{}: {}"),
                                  Json(array.name).dump(), numbers));
  }
  return fmt::format("{{{}}}", fmt::join(members, ", "));
}

}  // namespace

std::string rounded_decimal_text(const cln::cl_R& value, int digits) {
  return literal_text(rounded_decimal(value, digits));
}

std::string rounded_decimal_texts(const std::vector<cln::cl_R>& values, int digits) {
  std::vector<std::string> texts;
  for (const cln::cl_R& value : values) texts.push_back(rounded_decimal_text(value, digits));
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string state_json(const Model& model, const LeafValues<cln::cl_R>& state,
                       const std::vector<Opcode>& kinds, int digits) {
  std::vector<std::string> members;
  for (const Opcode kind : kinds) {
    const std::vector<cln::cl_R>* const list = leaf_list(state, kind);
    std::string value;
    if (kind == Opcode::parameter) {
      value = parameters_json(model, state.parameters, digits);
    } else if (list != nullptr) {
      value = fmt::format("[{}]", rounded_decimal_texts(*list, digits));
    } else {
      value = rounded_decimal_text(leaf_of(state, kind, 0), digits);
    }
    members.push_back(fmt::format("\"{}\": {}", leaf_row(kind).symbol, value));
  }
  return fmt::format("{}", fmt::join(members, ", "));
}

}  // namespace elgen
