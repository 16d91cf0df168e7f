// Tables with costs and errors that are made up, so that nothing in the tests is measured.
#pragma once

#include "elgen/tradeoff.hpp"

namespace elgen::test {

/// Quartiles 5 % to either side of the cost.
inline TradeoffRow row_of(std::vector<std::string> values, double cost, double error) {
  return {.values = std::move(values),
          .cost = {cost, 0.95 * cost, 1.05 * cost},
          .error = {error, error / 4}};
}

inline TradeoffRow failed_row(std::vector<std::string> values, std::string why) {
  return {.values = std::move(values), .failure = std::move(why)};
}

/// Of two scalars, in packs or not, measured in the order of a plan.
inline TradeoffTable sample_table() {
  return {.model = "arm",
          .subject = "gravity",
          .cost = "ns per state",
          .error = "errors, relative",
          .dimensions = {"scalar", "batch"},
          .rows = {row_of({"double", "1"}, 40, 1e-16), row_of({"double", "packs"}, 8, 2e-16),
                   row_of({"float", "1"}, 40.5, 1e-7), row_of({"float", "packs"}, 4, 2e-7),
                    failed_row({"half", "1"}, "E709: \"c++\" exits 1")},
          .machine = {.compiler = "g++ 12", .processor = "a processor"}};
}

}  // namespace elgen::test
