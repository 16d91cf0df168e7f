// Program: one straight-line function per output, without GiNaC, in elgen's own order.
//
// A Function is a list of instructions in single-assignment form. Operands precede their users, no
// value is computed twice except in repetitions, and no code is dead (find_invariant_violation).
// Text form, one instruction per line:
//
//     function mass_matrix(q)
//       0 = parameter m             ; leaves are named as in the model
//       1 = parameter l
//       2 = multiply 1 1
//       3 = multiply 0 2            ; inertia
//       result 1 1 = 3              ; rows columns = entries, row-major;
//                                   ; of a struct: "result acceleration 2 1 = …"
//       repeated 2 16               ; the last 32 instructions are 16 repetitions of 2 (Repetition)
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/constant.hpp"
#include "elgen/diagnostic.hpp"
#include "elgen/functions.hpp"
#include "elgen/leaf_names.hpp"
#include "elgen/leaves.hpp"
#include "elgen/outputs.hpp"
#include "elgen/step_methods.hpp"

namespace elgen {

struct Instruction {
  Opcode opcode = Opcode::constant;
  FunctionId function = FunctionId::sin;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  /// True if the instruction belongs to the accelerations that a `step` evaluates.
  /// InnerScalar::single_precision applies only to such instructions.
  bool is_inner = false;
  friend bool operator==(const Instruction&, const Instruction&) = default;
};

/// A hash of instructions for value numbering: equal instructions compute the same value.
struct InstructionHash {
  [[nodiscard]] std::size_t operator()(const Instruction& i) const;
};

/// Number of operands that are instructions (0, 1 or 2).
[[nodiscard]] std::size_t operand_count(const Instruction& instruction);

[[nodiscard]] inline bool is_sum(const Instruction& instruction) {
  return instruction.opcode == Opcode::add || instruction.opcode == Opcode::subtract;
}

/// `instruction` with places[k] in place of every operand k that is an instruction.
[[nodiscard]] Instruction renumber_operands(Instruction instruction,
                                            const std::vector<std::uint32_t>& places);

/// The prefix of names that the derivation gives to intermediate values: "~moment_link5_y". Names
/// of temporaries may contain such a name without the prefix.
inline constexpr char intermediate_mark = '~';

/// Sets `known` to `name` if `known` is empty, or if `known` has intermediate_mark and `name` does
/// not. An empty `name` changes nothing.
void merge_name(std::string& known, const std::string& name);

struct Field {
  std::string name = {};  ///< "" if the output has only one field
  std::uint32_t rows = 1;
  std::uint32_t columns = 1;
  std::vector<std::uint32_t> entries = {};  ///< index of the instruction of each entry, row-major
};

/// The last `length * count` instructions are `count` repetitions of the same `length` instructions
/// with other operands; emitted code has a loop. An operand is in the same repetition, or precedes
/// all repetitions. A preceding operand is either the same instruction for all repetitions, or
/// another instruction for each repetition.
///
///     5 = multiply 0 1     6 = subtract 2 5     7 = multiply 0 3     8 = subtract 4 7
///     length 2, count 2; operands 1 and 2 in the first repetition, 3 and 4 in the second
struct Repetition {
  std::uint32_t length = 0;
  std::uint32_t count = 0;
};

struct Function {
  OutputKind kind = {};
  std::uint32_t user = 0;                       ///< index in Model::outputs, for the user_* kinds
  std::optional<StepSpec> step = {};            ///< for `step` and its derivatives
  std::vector<std::uint32_t> independent = {};  ///< as OutputRequest::independent
  std::string name = {};
  Form form = Form::recursive;
  std::vector<Instruction> instructions = {};
  /// Name of each instruction ("sin_theta", "~moment_link5_y"), or "". Parallel to instructions.
  std::vector<std::string> names = {};
  std::vector<Field> fields = {};
  /// Entries, numbered over all fields, that depend on a value replaced by 0 without a proof: the
  /// value vanishes at `zero_sample_count` random points.
  std::vector<std::uint32_t> sampled_zeros = {};
  /// Entries, numbered over all fields, whose code differs from their readable form, because the
  /// readable form loses digits in cancelling sums.
  std::vector<std::uint32_t> rewritten = {};
  Repetition repeated = {};  ///< count 0: no repetitions
  /// If the fields are the parts of an output (elgen/compose.hpp): the velocities in the order in
  /// which M is eliminated.
  std::vector<std::uint32_t> elimination_order = {};
};

/// `function` without instructions and fields, for the same request.
[[nodiscard]] inline Function without_body(const Function& function) {
  return {.kind = function.kind,
          .user = function.user,
          .step = function.step,
          .independent = function.independent,
          .name = function.name};
}

/// The index of the first repeated instruction; instructions.size() if no instruction is repeated.
[[nodiscard]] std::size_t first_repeated_instruction(const Function& function);

/// Number of random points at which a value has to vanish before the value counts as zero.
inline constexpr std::size_t zero_sample_count = 64;

/// True for a root or a function of numbers, such as cos(7/10). Costs count it as a number.
[[nodiscard]] bool is_call_of_numbers(const Function& function, const Instruction& instruction);

/// The number of entries of all fields.
[[nodiscard]] std::size_t entry_count(const Function& function);
/// The index of the instruction of each entry, field by field.
[[nodiscard]] std::vector<std::uint32_t> entries_of(const Function& function);
/// The index in entries_of() of the first entry of `field`; entry_count() if the field is missing.
[[nodiscard]] std::size_t first_entry_of(const Function& function, std::string_view field);
/// True if the function has the field `relative_pivots`.
[[nodiscard]] bool has_pivots(const Function& function);
/// The index of an entry as pages print it: "[1,2]", "[2]", or "" for a single entry.
[[nodiscard]] std::string index_text(const Field& field, std::size_t entry);

struct Program {
  LeafNames leaves = {};
  std::vector<Constant> constants = {};
  std::vector<Function> functions = {};  ///< in the order of the output table
  /// The closed form of every entry as pages show it, over leaves and named values. Parallel to
  /// functions, or empty. A function without a closed form has no fields in this list.
  std::vector<Function> readable = {};
};

/// True if some function contains a call of `function`.
[[nodiscard]] bool calls_function(const Program& program, FunctionId function);

/// True if the instruction loads the number 0.
[[nodiscard]] bool loads_zero(const Program& program, const Instruction& instruction);
/// True if every entry loads the number 0.
[[nodiscard]] bool is_zero(const Program& program, const Function& function);

/// The constants that instructions of `functions` load, in order. Constants that only `readable`
/// loads are omitted.
[[nodiscard]] std::vector<Constant> executed_constants(const Program& program);

/// For each instruction the number of operations if the instruction is expanded over the leaves.
/// Counting stops at `most` + 1, because the number may double with every instruction.
[[nodiscard]] std::vector<std::size_t> expanded_sizes(const Function& function, std::size_t most);

/// The operations that one call executes. `add` includes subtractions; `sincos` counts the distinct
/// angles of sines and cosines. Negations and calls of numbers are not counted.
struct OperationCounts {
  std::size_t add = 0;
  std::size_t mul = 0;
  std::size_t div = 0;
  std::size_t sqrt = 0;
  std::size_t sincos = 0;
  std::size_t other = 0;
  friend bool operator==(const OperationCounts&, const OperationCounts&) = default;
};

/// A member of OperationCounts, and its name in listings.
struct OperationColumn {
  std::string_view name;
  std::size_t OperationCounts::*count;
};

/// All counts, in the order of listings.
inline constexpr std::array operation_columns{OperationColumn{"add", &OperationCounts::add},
                                              OperationColumn{"mul", &OperationCounts::mul},
                                              OperationColumn{"div", &OperationCounts::div},
                                              OperationColumn{"sqrt", &OperationCounts::sqrt},
                                              OperationColumn{"sincos", &OperationCounts::sincos},
                                              OperationColumn{"other", &OperationCounts::other}};

[[nodiscard]] OperationCounts count_operations(const Function& function);

/// k of a call stumpff(x, k). `at` is the instruction of the operand k: a constant or the negative
/// of a constant.
[[nodiscard]] int stumpff_order(const Program& program, const Function& function, std::uint32_t at);

/// The cost in multiplications:
///
///                                     cost   measured, dependent   measured, independent
///     addition, multiplication           1
///     division                           4          4.4                   1.9
///     square root                        8          7.9                   5.9
///     sine, cosine or both of an angle  20         22.6 (library 24.9)   17.7 (library 24.6)
///     any other function                16         11.8 (exp)            11.8 (exp)
///
/// Measured by tests/bench/operation_costs (g++ 12, glibc 2.36, one run).
[[nodiscard]] std::size_t cost(const OperationCounts& counts);

/// For each instruction: true if the instruction is in `wanted`, or is a direct or indirect operand
/// of an instruction in `wanted`.
[[nodiscard]] std::vector<bool> needed_instructions(const Function& function,
                                                    const std::vector<std::uint32_t>& wanted);

/// The numbers of the instructions that needed_instructions() marks, ascending. If there are more
/// than `most`, only the `most` + 1 highest. Cost: linear in the result.
[[nodiscard]] std::vector<std::uint32_t> dependency_cone(
    const Function& function, std::vector<std::uint32_t> wanted,
    std::size_t most = std::numeric_limits<std::size_t>::max());

/// The function with only the instructions `order` (old numbers), in this order. Operands must
/// precede their users, and every entry must be present. `repeated` is kept if all repeated
/// instructions remain at the end, in their old order.
[[nodiscard]] Function reorder_instructions(const Function& function,
                                            const std::vector<std::uint32_t>& order);

/// `function` without the instructions that no entry needs.
///
///     before    0 = parameter m   1 = parameter l   2 = multiply 0 0   result = 2
///     after     0 = parameter m   1 = multiply 0 0                     result = 1
[[nodiscard]] Function eliminate_dead_code(const Function& function);

/// A function whose only field has the instructions `entries` as entries. Instructions that these
/// entries do not need are removed.
[[nodiscard]] Function with_entries(Function function, const std::vector<std::uint32_t>& entries);

/// The first violation of an invariant, with function and instruction; empty if there is none.
[[nodiscard]] std::string find_invariant_violation(const Program& program);

/// Throws std::logic_error (E912) if find_invariant_violation() is not empty, in every build. Cost:
/// linear in the instructions.
void require_invariants(const Program& program);

[[nodiscard]] std::string dump(const Program& program);

/// The name of a temporary if no other name is found: in code a hash of the computation
/// ("t_4f2a9"), on pages a number ("part_2").
enum class FallbackName : std::uint8_t { hash, number };

/// The names of instructions in equations and emitted code; "" if the instruction has no temporary.
/// Every name is a C++ identifier and unique in the function. With FallbackName::hash, no name
/// depends on code elsewhere in the function.
[[nodiscard]] std::vector<std::string> temporary_names(const Program& program,
                                                       const Function& function,
                                                       FallbackName last = FallbackName::hash);

/// For each instruction the name of its temporary; "" unless the instruction is a sine or cosine
/// ("sin_theta") or has a name without intermediate_mark in function.names. Hashes and names spelt
/// from operands are excluded, because a caller may replace the operands.
[[nodiscard]] std::vector<std::string> context_free_names(const Program& program,
                                                          const Function& function);

}  // namespace elgen
