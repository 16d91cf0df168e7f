// Values: the values of outputs at states, in decimal digits, for people and for tests of foreign
// code. The oracle computes or confirms them from the defining equations, independently of the
// derivation.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "elgen/oracle.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

struct ValueField {
  std::string name = {};                  ///< "" for outputs of one field
  std::vector<std::string> rows = {};     ///< names of the rows; {""} for a number
  std::vector<std::string> columns = {};  ///< names of the columns; {""} for a column vector
  std::vector<std::string> units = {};    ///< unit of each entry, row-major; "" if unknown
};

/// An output as a function. `takes` are the kinds of its arguments. Kinds without a leaf in the
/// model are omitted, except inputs.
struct ValueFunction {
  OutputRequest output = {};
  std::vector<Opcode> takes = {};
  std::vector<ValueField> fields = {};
};

/// The values of a function at a state.
struct ValueRecord {
  std::size_t function = 0;            ///< index in ValueTable::functions
  std::string state_name = {};         ///< "start", "rest", "moving", "parameters", "state"
  State state = {};                    ///< contains all parameters, also fixed parameters
  std::vector<cln::cl_R> values = {};  ///< entries of each field in turn, row-major
  /// For each value, the number of digits that emitted code in double computes correctly, by a
  /// bound of the rounding error. For a value 0, the error is relative to the largest entry of the
  /// field. Empty except for test vectors.
  std::vector<int> digits = {};
};

/// The values of several functions. The records are sorted by function. Refers to the model.
struct ValueTable {
  const Model& model;
  std::string name = {};  ///< name of the model and its scene
  int digits = 17;        ///< number of significant digits of each value, all correct
  std::vector<ValueFunction> functions = {};
  std::vector<ValueRecord> records = {};
  /// The number of states from which Newton's method found no point on the constraints. None unless
  /// the table has test vectors of a model with constraints.
  std::optional<std::size_t> skipped_states = {};
};

struct StateOptions {
  int digits = 17;       ///< significant digits of each value, at most max_value_digits
  bool projects = true;  ///< true: move variables that `--state` does not set onto the constraints
};
inline constexpr int max_value_digits = 60;

/// The values of the outputs of a scene at the start of the model, changed by `--state`. Unless
/// `--state` sets them, accelerations are 0, momenta are computed from the rates, and inputs from
/// their laws. E538: the constraints cannot be satisfied. E521 for each output without a value;
/// all other outputs are returned. Cost: two evaluations by the oracle, up to six if terms cancel.
[[nodiscard]] Result<ValueTable> state_values(const CheckedModel& checked,
                                              const StateOptions& options);

struct TestVectorOptions {
  std::size_t samples = 16;  ///< number of states, common to all functions
  std::uint64_t seed = 1;
  /// Called before each value, with a text: "gravity, state 3 of 16".
  std::function<void(const std::string&)> on_step = {};
};

/// The values of each function at several states, whose numbers are doubles: the start of the
/// model; then in turn states at rest without inputs, in motion inside the ranges, and in motion
/// with other parameters. With constraints, states are moved onto them, except for outputs that
/// measure the violation of constraints. A function has no record at a state at which its value is
/// undefined or not known to enough digits. E521: a function has no record. E633: a function
/// contains an open function.
///
/// The functions of `program` compute the values in 64 digits, and the oracle confirms every field
/// by a random projection. The oracle computes the values that are not confirmed.
[[nodiscard]] Result<ValueTable> test_vectors(const CheckedModel& checked, const Program& program,
                                              const TestVectorOptions& options);

/// A table of one state: the state, and the matrices with names of rows and columns.
[[nodiscard]] std::string to_text(const ValueTable& table);
[[nodiscard]] std::string to_json(const ValueTable& table);
/// One row per entry of each record.
[[nodiscard]] std::string to_csv(const ValueTable& table);
/// A header for C and C++ with an array of structs per function.
[[nodiscard]] std::string to_header(const ValueTable& table);

}  // namespace elgen
