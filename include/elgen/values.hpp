// Values: outputs at states in decimal digits, for people and for tests of code that others wrote.
// The oracle gives them: they are those of the equations as defined, whatever elgen derives.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elgen/oracle.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

struct ValueField {
  std::string name = {};                  ///< "" in plain outputs
  std::vector<std::string> rows = {};     ///< the names of what they stand for; {""} of numbers
  std::vector<std::string> columns = {};  ///< likewise; {""} of columns
  std::vector<std::string> units = {};    ///< of each entry; "" where it has none
};

/// An output as a function: its arguments of which the model has some, inputs in any case, and its
/// fields.
struct ValueFunction {
  OutputRequest output = {};
  std::vector<Opcode> takes = {};
  std::vector<ValueField> fields = {};
};

/// A function at a state.
struct ValueRecord {
  std::size_t function = 0;            ///< of the table
  std::string place = {};              ///< "start", "rest", "moving", "parameters", "state"
  State state = {};                    ///< all parameters, fixed ones too
  std::vector<cln::cl_R> values = {};  ///< row-major, field after field
  /// The digits of each that the emitted code keeps in double, by a bound of its rounding; a zero
  /// counts those of the largest entry of its field. Test vectors alone have them.
  std::vector<int> digits = {};
};

/// Records, function after function. The model outlives it.
struct ValueTable {
  const Model& model;
  std::string name = {};  ///< of the model and its scene
  int digits = 17;        ///< significant ones, which are right to the last
  std::vector<ValueFunction> functions = {};
  std::vector<ValueRecord> records = {};
  /// The number of states that no Newton step puts onto the constraints; of test vectors alone.
  std::optional<std::size_t> unmet = {};
};

struct StateOptions {
  int digits = 17;       ///< up to most_value_digits
  bool projects = true;  ///< what `--state` does not name moves onto the constraints
};
inline constexpr int most_value_digits = 60;

/// The outputs of a scene at the start of the model and what `--state` says beside it: otherwise
/// accelerations are 0, momenta those of the rates. Inputs are what their laws say. E538; E521 of
/// each output without a value, beside the others. Cost: two evaluations by the oracle, up
/// to six if terms cancel.
[[nodiscard]] Result<ValueTable> state_values(const CheckedModel& checked,
                                              const StateOptions& options);

struct VectorOptions {
  std::size_t samples = 16;  ///< states of each function
  std::uint64_t seed = 1;
};

/// At states of exact doubles: the start of the model, then in turn at rest without inputs, moving
/// inside the ranges, and moving with other parameters. States of a model with constraints are
/// moved onto them, except for outputs that say how far off a state is. A function has no record at
/// a state at which it has no value, or none that can be told. E521 if it has no record at all,
/// E633 if it reads a function left open.
[[nodiscard]] Result<ValueTable> test_vectors(const CheckedModel& checked, const Program& program,
                                              const VectorOptions& options);

/// The state, and matrices with the names of their rows and columns, of a table of one state.
[[nodiscard]] std::string to_text(const ValueTable& table);
[[nodiscard]] std::string to_json(const ValueTable& table);
/// A row for each entry of each record.
[[nodiscard]] std::string to_csv(const ValueTable& table);
/// An array of structs for each function, in C and C++.
[[nodiscard]] std::string to_header(const ValueTable& table);

}  // namespace elgen
