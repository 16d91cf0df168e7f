// Program: one straight-line function per output, without GiNaC, in elgen's own order.
//
// A Function is a list of instructions in single-assignment form. Operands precede their users, no
// value is computed twice except in repetitions, and no code is dead (check_invariants). Text form,
// one instruction per line:
//
//     function mass_matrix(q)
//       0 = parameter m             ; leaves are named as in the model
//       1 = parameter l
//       2 = multiply 1 1
//       3 = multiply 0 2            ; inertia
//       result 1 1 = 3              ; rows columns = entries, row-major;
//                                   ; of a struct: "result acceleration 2 1 = …"
//       repeated 2 16               ; the last 32 are 16 repetitions of 2: a loop in code
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
  /// Part of an acceleration in a `step`, for which Numerics::inner may hold alone.
  bool is_inner = false;
  friend bool operator==(const Instruction&, const Instruction&) = default;
};

/// For value numbering: equal instructions have the same value.
struct InstructionHash {
  [[nodiscard]] std::size_t operator()(const Instruction& i) const;
};

/// Number of operands that are instructions (0, 1 or 2).
[[nodiscard]] std::size_t operand_count(const Instruction& instruction);

[[nodiscard]] inline bool is_sum(const Instruction& instruction) {
  return instruction.opcode == Opcode::add || instruction.opcode == Opcode::subtract;
}

/// The same operation with its operands renumbered by `places`.
[[nodiscard]] Instruction renumber_operands(Instruction instruction,
                                            const std::vector<std::uint32_t>& places);

/// The prefix of names that only temporaries may have, from the derivation: "~moment_link5_y".
inline constexpr char intermediate_mark = '~';

/// Names a value that has no name. A name with intermediate_mark gives way to one without it.
void merge_name(std::string& known, const std::string& name);

struct Field {
  std::string name = {};  ///< "" for outputs of one field
  std::uint32_t rows = 1;
  std::uint32_t columns = 1;
  std::vector<std::uint32_t> entries = {};  ///< instruction of each entry, row-major
};

/// The last `length * count` instructions are `count` repetitions of `length` instructions. An
/// operand is in the same repetition or precedes all of them. In the latter case it is the same
/// value for all repetitions, or one value for each.
///
///     5 = multiply 0 1     6 = subtract 2 5     7 = multiply 0 3     8 = subtract 4 7
///     length 2, count 2, with the values 1, 2 and then 3, 4
struct Repetition {
  std::uint32_t length = 0;
  std::uint32_t count = 0;
};

struct Function {
  OutputKind kind = {};
  std::uint32_t user = 0;                       ///< index in Model::outputs, for the user_* kinds
  std::optional<StepSpec> step = {};            ///< for `step` and its derivatives
  std::vector<std::uint32_t> independent = {};  ///< as in its OutputRequest
  std::string name = {};
  Form form = Form::recursive;
  std::vector<Instruction> instructions = {};
  /// Name of each instruction ("sin_theta", "~moment_link5_y"), or "". Parallel to instructions.
  std::vector<std::string> names = {};
  std::vector<Field> fields = {};
  /// Entries, numbered over all fields, that contain a zero without proof, found at
  /// `zero_sample_count` random points.
  std::vector<std::uint32_t> sampled_zeros = {};
  /// Entries, numbered over all fields, whose code differs from the readable form, which loses
  /// digits in cancelling sums.
  std::vector<std::uint32_t> rewritten = {};
  Repetition repeated = {};  ///< count 0: no repetitions
  /// For a function of parts (elgen/compose.hpp): the velocities in the order in which M is
  /// eliminated.
  std::vector<std::uint32_t> elimination = {};
};

/// A copy without instructions and fields; it answers the same request.
[[nodiscard]] inline Function without_body(const Function& function) {
  return {.kind = function.kind,
          .user = function.user,
          .step = function.step,
          .independent = function.independent,
          .name = function.name};
}

/// The number of the first repeated instruction; the number of instructions if none is repeated.
[[nodiscard]] std::size_t first_repeated_instruction(const Function& function);

/// Points at which a value has to vanish before it counts as zero.
inline constexpr std::size_t zero_sample_count = 64;

/// The number of entries of all fields.
[[nodiscard]] std::size_t entry_count(const Function& function);
/// The instructions of all entries, field by field.
[[nodiscard]] std::vector<std::uint32_t> entries_of(const Function& function);
/// The number of the first entry of a field; the number of all entries if the field is missing.
[[nodiscard]] std::size_t first_entry_of(const Function& function, std::string_view field);
/// True if the function has the field `relative_pivots`.
[[nodiscard]] bool has_pivots(const Function& function);
/// The index of an entry on pages: "[1,2]", "[2]", or "" for a single entry.
[[nodiscard]] std::string index_text(const Field& field, std::size_t entry);

struct Program {
  LeafNames leaves = {};
  std::vector<Constant> constants = {};
  std::vector<Function> functions = {};  ///< in the order of the output table
  /// The closed form of every entry as written for readers, without shared values. Parallel to
  /// functions, or empty. A function without closed form has no fields here.
  std::vector<Function> readable = {};
};

/// True if some function contains a call of `function`.
[[nodiscard]] bool calls(const Program& program, FunctionId function);

/// True if the instruction loads the number 0.
[[nodiscard]] bool loads_zero(const Program& program, const Instruction& instruction);
/// True if every entry loads the number 0.
[[nodiscard]] bool is_zero(const Program& program, const Function& function);

/// The constants that `functions` load, in order; constants of `readable` alone are omitted.
[[nodiscard]] std::vector<Constant> executed_constants(const Program& program);

/// The operations of each instruction if it is expanded over the leaves, at most `most` + 1. The
/// size may double with every level.
[[nodiscard]] std::vector<std::size_t> expanded_sizes(const Function& function, std::size_t most);

/// The operations that one call executes. Subtractions count as add, different angles of sines and
/// cosines as sincos, negations as nothing.
struct OperationCounts {
  std::size_t add = 0;
  std::size_t mul = 0;
  std::size_t div = 0;
  std::size_t sqrt = 0;
  std::size_t sincos = 0;
  std::size_t other = 0;
  friend bool operator==(const OperationCounts&, const OperationCounts&) = default;
};

/// One of these counts, and its name.
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

/// k of the call stumpff(x, k): `at` is the operand k, a constant or its negative.
[[nodiscard]] int stumpff_order(const Program& program, const Function& function, std::uint32_t at);

/// In multiplications: mul and add 1, division 4, square root 8, sine and cosine of an angle 20
/// (also if only one is used), any other function 16. Measured by tests/bench/operation_costs (g++
/// 12, glibc 2.36, one run): dependent operations 4.4, 7.9, 22.6 (24.9 by the library), 11.8 for
/// exp; independent operations 1.9, 5.9, 17.7 (24.6), 11.8.
[[nodiscard]] std::size_t cost(const OperationCounts& counts);

/// For each instruction: true if it is one of `wanted` or an operand of one, directly or
/// indirectly.
[[nodiscard]] std::vector<bool> needed_instructions(const Function& function,
                                                    const std::vector<std::uint32_t>& wanted);

/// The numbers of these instructions, ascending. If there are more than `most`, only the `most` + 1
/// highest. Cost: linear in the result.
[[nodiscard]] std::vector<std::uint32_t> cone_of(
    const Function& function, std::vector<std::uint32_t> wanted,
    std::size_t most = std::numeric_limits<std::size_t>::max());

/// The function with only the instructions in `order` (old numbers). Operands must precede their
/// users, and every entry must be present. Repetitions are kept if all of them remain at the end.
[[nodiscard]] Function reordered(const Function& function, const std::vector<std::uint32_t>& order);

/// Removes the instructions that no entry needs.
///
///     before    0 = parameter m   1 = parameter l   2 = multiply 0 0   result = 2
///     after     0 = parameter m   1 = multiply 0 0                     result = 1
[[nodiscard]] Function pruned(const Function& function);

/// The instructions `entries` as the only field, with their operands.
[[nodiscard]] Function with_entries(Function function, const std::vector<std::uint32_t>& entries);

/// Empty if all invariants hold; else the first violation with function and instruction.
[[nodiscard]] std::string check_invariants(const Program& program);

/// Throws std::logic_error with the first violation (E912), in every build. Cost: linear in the
/// instructions.
void require_invariants(const Program& program);

[[nodiscard]] std::string dump(const Program& program);

/// The name of a value without a meaning: a hash of its content in code, a number on pages
/// ("part_2").
enum class FallbackName : std::uint8_t { hash, number };

/// The names of instructions in equations and emitted code; "" if the instruction is expanded.
/// Every name is a C++ identifier and unique in the function. With FallbackName::hash no name
/// depends on code elsewhere in the function.
[[nodiscard]] std::vector<std::string> temporary_names(const Program& program,
                                                       const Function& function,
                                                       FallbackName last = FallbackName::hash);

/// Only the names that stay true if the leaves have other values. Names composed from leaves, names
/// of values in frames and hashes are replaced by "".
[[nodiscard]] std::vector<std::string> context_free_names(const Program& program,
                                                          const Function& function);

}  // namespace elgen
