// compose_outputs: solves for the columns of the derivatives, which AccelerationParts computes at
// the accelerations.
#include "elgen/compose.hpp"

#include <numeric>
#include <utility>

#include "program/steps/composition.hpp"

namespace elgen {
namespace {

InstructionIndices row_of(const ValueMatrix& matrix, std::size_t row) {
  const auto begin = matrix.entries.begin() + static_cast<std::ptrdiff_t>(row * matrix.columns);
  return {begin, begin + static_cast<std::ptrdiff_t>(matrix.columns)};
}

class DerivativeComposer {
 public:
  /// `parts` must outlive this object, and must not be a function of `program`.
  DerivativeComposer(Program& program, const Function& parts)
      : program_(program),
        parts_(parts),
        function_(without_body(parts)),
        compose_(program, function_) {}

  Function operator()() {
    const LeafNames& leaves = program_.leaves;
    CallPoint at{.q = compose_.add_leaves(Opcode::coordinate, leaves.q.size()),
                 .v = compose_.add_leaves(Opcode::velocity, leaves.v.size())};
    if (leaves.uses_time) at.t = compose_.add_leaf(Opcode::time);
    const AccelerationParts dynamics(compose_, program_, parts_, at);
    compose_.name(dynamics.accelerations(), "acceleration_");
    const std::vector<ValueMatrix> rates = dynamics.call({rate_part});
    write_fields(
        solve_responses(dynamics.mass(), dynamics.call({position_part, velocity_part, input_part})),
        rates);
    if (!parts_.sampled_zeros.empty()) {
      function_.sampled_zeros.resize(entry_count(function_));
      std::iota(function_.sampled_zeros.begin(), function_.sampled_zeros.end(), 0U);
    }
    return eliminate_dead_code(function_);
  }

 private:
  /// The matrix M^-1 F for each matrix F in `forces`.
  std::vector<ValueMatrix> solve_responses(const MassFactorisation& mass,
                                           std::vector<ValueMatrix> forces) {
    const std::size_t n = parts_.elimination_order.size();
    std::vector<InstructionIndices> columns;
    std::vector<std::pair<ValueMatrix*, std::size_t>> places;
    for (ValueMatrix& matrix : forces) {
      for (std::size_t j = 0; j < matrix.columns; ++j) {
        InstructionIndices column;
        for (std::size_t i = 0; i < n; ++i)
          column.push_back(matrix.entries[i * matrix.columns + j]);
        columns.push_back(std::move(column));
        places.emplace_back(&matrix, j);
      }
    }
    const std::vector<InstructionIndices> solved = mass.solve_columns(columns);
    for (std::size_t k = 0; k < solved.size(); ++k) {
      const auto& [matrix, j] = places[k];
      for (std::size_t i = 0; i < n; ++i) matrix->entries[i * matrix->columns + j] = solved[k][i];
    }
    return forces;
  }

  /// Writes the fields of the output: each derivative if `rates` is empty, else the matrices
  /// A = [rates; d/dq, d/dv] and B = [0; d/du].
  void write_fields(const std::vector<ValueMatrix>& derivatives,
                    const std::vector<ValueMatrix>& rates) {
    if (rates.empty()) {
      for (const ValueMatrix& matrix : derivatives) add_field(matrix);
      return;
    }
    ValueMatrix a = rates.front();
    for (std::size_t i = 0; i < parts_.elimination_order.size(); ++i) {
      for (std::size_t k = 0; k < 2; ++k) {
        const InstructionIndices row = row_of(derivatives[k], i);
        a.entries.insert(a.entries.end(), row.begin(), row.end());
      }
    }
    add_field(a);
    if (derivatives.size() < 3) return;
    ValueMatrix b = derivatives[2];
    b.entries.insert(b.entries.begin(), b.entries.size(), compose_.add_number(0));
    add_field(b);
  }

  void add_field(const ValueMatrix& matrix) {
    const FieldRow& row = output_row(function_.kind).fields[function_.fields.size()];
    function_.fields.push_back({std::string(row.name),
                                static_cast<std::uint32_t>(matrix.entries.size() / matrix.columns),
                                static_cast<std::uint32_t>(matrix.columns), matrix.entries});
  }

  Program& program_;
  const Function& parts_;
  Function function_;
  Composition compose_;
};

}  // namespace

Program compose_outputs(Program program) {
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    if (program.functions[i].elimination_order.empty()) continue;
    const Function parts = std::move(program.functions[i]);
    program.functions[i] = DerivativeComposer(program, parts)();
  }
  require_invariants(program);
  return program;
}

}  // namespace elgen
