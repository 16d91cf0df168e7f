#include "oracle/contraction.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "elgen/step_methods.hpp"
#include "oracle/samples.hpp"

using namespace elgen;
using namespace elgen::test;
using cln::cl_R;
using Values = std::vector<cl_R>;

namespace {

ModelBuilder everything() {
  ModelBuilder b = rotating_hoop("W*t^2");
  b.coordinate("s").input("u", 1).input("w").T("s_d^2*(1 + th^2) + s_d*th_d + s_d").V("s*th*th_d");
  b.D("s_d^2*th_d^2").force_on(0, "s*w - tanh(s_d)").output({"s*th", "sin(s)", "th^2"});
  return b;
}

/// w.x or w.X y from the entries of a field, of which `first` is the first.
cl_R contracted(const Values& values, std::size_t first, const Contraction& by) {
  cl_R sum = 0;
  for (std::size_t i = 0; i < by.w.size(); ++i) {
    if (by.y.empty()) sum = sum + by.w[i] * values[first + i];
    for (std::size_t j = 0; j < by.y.size(); ++j) {
      sum = sum + by.w[i] * values[first + i * by.y.size() + j] * by.y[j];
    }
  }
  return sum;
}

void check(OutputKind kind, std::size_t first, const Contraction& by) {
  const ModelBuilder b = everything();
  const State state = random_state(b.model, 3);
  OutputRequest request;
  request.kind = kind;
  if (output_row(kind).steps) {  // the method with all fields
    request.user = static_cast<std::uint32_t>(StepMethod::midpoint);
    request.iterations = 2;
  }
  const auto values = oracle_values(b.model, request, state);
  const auto number = oracle_contraction(b.model, request, state, by);
  CAPTURE(static_cast<int>(kind), by.field);
  REQUIRE(values);
  REQUIRE(number);
  // A few operations on 95 digits.
  CHECK(agree(*number, contracted(*values, first, by), 85, 1));
}

int count(Extent extent) {
  switch (extent) {
    case Extent::one:
      return 1;
    case Extent::user:
      return 3;
    case Extent::states:
      return 4;
    default:
      return 2;
  }
}

Contraction directions(const FieldRow& field) {
  Contraction by;
  for (int i = 0; i < count(field.rows); ++i) by.w.push_back(2 * i - 1);
  const int columns = field.columns == Extent::one ? 0 : count(field.columns);
  for (int j = 0; j < columns; ++j) by.y.push_back(3 - 5 * j);
  return by;
}

}  // namespace

TEST_CASE("contractions are the sums over all entries, for every field of every output") {
  for (const OutputRow& row : output_table()) {
    if (row.requirement == Requirement::held) continue;
    std::size_t first = 0;
    for (std::size_t k = 0; k < row.fields.size(); ++k) {
      // The pivots of a solve are no contraction.
      if (row.kind == OutputKind::forward_dynamics && k > 0) break;
      Contraction by = directions(row.fields[k]);
      by.field = k;
      check(row.kind, first, by);
      first += by.w.size() * std::max<std::size_t>(by.y.size(), 1);
    }
  }
}

TEST_CASE("a contraction outside the domain is empty") {
  ModelBuilder b;
  b.coordinate("x").T("x_d^2/2").V("log(x)");
  OutputRequest request;
  request.kind = OutputKind::gravity;
  CHECK_FALSE(oracle_contraction(b.model, request, nominal_state(b.model, {}), {{1}, {}}));
}
