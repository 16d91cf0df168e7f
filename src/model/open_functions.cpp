// The numbers of open values: few, so that they are looked for.
#include "elgen/open_functions.hpp"

#include <algorithm>
#include <utility>

#include "elgen/model.hpp"

namespace elgen {

std::optional<std::uint32_t> open_value(const Model& model, std::uint32_t function,
                                        std::vector<std::uint32_t> by) {
  std::sort(by.begin(), by.end());
  for (std::uint32_t i = 0; i < model.open_values.size(); ++i) {
    const OpenValue& value = model.open_values[i];
    if (value.function == function && value.by == by) return i;
  }
  return std::nullopt;
}

std::optional<std::uint32_t> derivative_of(const Model& model, std::uint32_t value,
                                           std::uint32_t argument) {
  std::vector<std::uint32_t> by = model.open_values[value].by;
  by.push_back(argument);
  return open_value(model, model.open_values[value].function, std::move(by));
}

}  // namespace elgen
