// Textbook systems and random exact states, for the tests of the oracle and of the inspection.
#pragma once

#include <random>

#include "elgen/oracle.hpp"
#include "oracle/model_builder.hpp"

namespace elgen::test {

inline OracleValues value_of(const Model& model, OutputKind kind, const State& state) {
  OutputRequest request;
  request.kind = kind;
  return oracle_values(model, request, state);
}

}  // namespace elgen::test
