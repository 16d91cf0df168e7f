// Program: one straight-line function per output, free of GiNaC, ordered by elgen's own keys.
//
// A Function is a list of instructions in single-assignment form, operands before use, nothing
// computed twice but by repetitions, nothing dead (check_invariants). Text form, one instruction a
// line:
//
//     function mass_matrix(q)
//       0 = parameter m             ; leaves are named as in the model
//       1 = parameter l
//       2 = multiply 1 1
//       3 = multiply 0 2            ; inertia
//       result 1 1 = 3              ; rows columns = entries, row-major;
//                                   ; of a struct: "result acceleration 2 1 = …"
//       repeated 2 16               ; the last 32 are 16 times 2 instructions: a loop in code
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
  bool is_inner = false;  ///< an acceleration's: Numerics::inner is for it, not for the others
  friend bool operator==(const Instruction&, const Instruction&) = default;
};

/// For value numbers: what is computed alike is one value.
struct InstructionHash {
  [[nodiscard]] std::size_t operator()(const Instruction& i) const;
};

/// Number of operands that are instructions (0, 1 or 2).
[[nodiscard]] std::size_t operand_count(const Instruction& instruction);

[[nodiscard]] inline bool is_sum(const Instruction& instruction) {
  return instruction.opcode == Opcode::add || instruction.opcode == Opcode::subtract;
}

/// The same operation, where its operands have moved to `places`.
[[nodiscard]] Instruction with_operands(Instruction instruction,
                                        const std::vector<std::uint32_t>& places);

/// Begins the names that are only for temporaries: "~moment_link5_y", told by the derivation.
inline constexpr char told_mark = '~';

/// The first name of a value stays; a told one gives way to others.
void take_name(std::string& known, const std::string& name);

struct Field {
  std::string name = {};  ///< "" for plain outputs
  std::uint32_t rows = 1;
  std::uint32_t columns = 1;
  std::vector<std::uint32_t> entries = {};  ///< instruction of each entry, row-major
};

/// The last `length * count` instructions of a function do the same `count` times. An operand is of
/// the own repetition, or stands before all of them: one value for all, or one for each.
///
///     5 = multiply 0 1     6 = subtract 2 5     7 = multiply 0 3     8 = subtract 4 7
///     length 2, count 2, with the values 1, 2 and then 3, 4
struct Repetition {
  std::uint32_t length = 0;
  std::uint32_t count = 0;
};

struct Function {
  OutputKind kind = {};
  std::uint32_t user = 0;                       ///< which user output, for the user_* kinds
  std::optional<StepSpec> step = {};            ///< of `step` and its derivatives
  std::vector<std::uint32_t> independent = {};  ///< as in its OutputRequest
  std::string name = {};
  Form form = Form::recursive;
  std::vector<Instruction> instructions = {};
  std::vector<std::string> names =
      {};  ///< same length; what an instruction is ("sin_theta", "~moment_link5_y"), or ""
  std::vector<Field> fields = {};
  /// Entries, numbered over all fields, that rest on a zero which was not proved but found at
  /// `zero_points` random points.
  std::vector<std::uint32_t> sampled_zeros = {};
  /// Entries, numbered alike, that are computed otherwise than they are read: what is read loses
  /// digits where sums cancel.
  std::vector<std::uint32_t> rewritten = {};
  Repetition repeated = {};  ///< none where nothing is
  /// Where the fields are parts that an output is composed of (elgen/compose.hpp): the velocities
  /// in the order in which M is eliminated.
  std::vector<std::uint32_t> elimination = {};
};

/// A function without instructions and fields that answers the request of another one.
[[nodiscard]] inline Function without_body(const Function& function) {
  return {.kind = function.kind,
          .user = function.user,
          .step = function.step,
          .independent = function.independent,
          .name = function.name};
}

/// The number of the first instruction that is repeated; that of all where none is.
[[nodiscard]] std::size_t first_repeated(const Function& function);

/// Where a value is asked for before it is taken for zero.
inline constexpr std::size_t zero_points = 64;

/// Entries of all fields.
[[nodiscard]] std::size_t entry_count(const Function& function);
/// Their instructions, field by field.
[[nodiscard]] std::vector<std::uint32_t> entries_of(const Function& function);
/// The number of the first entry of a field among them; that of all where there is no such field.
[[nodiscard]] std::size_t first_entry_of(const Function& function, std::string_view field);
/// Whether `relative_pivots` are among its fields.
[[nodiscard]] bool has_pivots(const Function& function);
/// "[1,2]", "[2]", or nothing for one entry alone: how pages number the entries of a field.
[[nodiscard]] std::string index_text(const Field& field, std::size_t entry);

struct Program {
  LeafNames leaves = {};
  std::vector<Constant> constants = {};
  std::vector<Function> functions = {};  ///< in the order of the output table
  /// Parallel to functions, where filled: the closed form of every entry as it is written for a
  /// reader, nothing shared between entries. Without fields where there is none.
  std::vector<Function> readable = {};
};

/// Whether some function calls it.
[[nodiscard]] bool calls(const Program& program, FunctionId function);

/// Whether an instruction loads the number 0.
[[nodiscard]] bool loads_zero(const Program& program, const Instruction& instruction);
/// Whether every entry of the function does.
[[nodiscard]] bool is_zero(const Program& program, const Function& function);

/// The constants that functions load, in their order; those of `readable` alone are not among them.
[[nodiscard]] std::vector<Constant> executed_constants(const Program& program);

/// Operations of each instruction written out over the leaves alone: functions of functions double
/// with every level. Counted up to just beyond `most`.
[[nodiscard]] std::vector<std::size_t> written_out_sizes(const Function& function,
                                                         std::size_t most);

/// The operations that one call executes: subtractions count as add; distinct sine/cosine angles as
/// sincos; negations free.
struct OperationCounts {
  std::size_t add = 0;
  std::size_t mul = 0;
  std::size_t div = 0;
  std::size_t sqrt = 0;
  std::size_t sincos = 0;
  std::size_t other = 0;
  friend bool operator==(const OperationCounts&, const OperationCounts&) = default;
};

/// One of these counts, by its name.
struct OperationColumn {
  std::string_view name;
  std::size_t OperationCounts::*count;
};

/// All of them, in the order in which they are listed.
inline constexpr std::array operation_columns{OperationColumn{"add", &OperationCounts::add},
                                              OperationColumn{"mul", &OperationCounts::mul},
                                              OperationColumn{"div", &OperationCounts::div},
                                              OperationColumn{"sqrt", &OperationCounts::sqrt},
                                              OperationColumn{"sincos", &OperationCounts::sincos},
                                              OperationColumn{"other", &OperationCounts::other}};

[[nodiscard]] OperationCounts count_operations(const Function& function);

/// The k of a call stumpff(x, k), which stands there: a constant or the opposite of one.
[[nodiscard]] int order_at(const Program& program, const Function& function, std::uint32_t at);

/// In multiplications: mul, add 1; division 4; square root 8; the sine and cosine of an angle 20,
/// also where one of them is needed; any other function 16. From tests/bench/operation_costs
/// (g++ 12, glibc 2.36, one run): in a row 4.4, 7.9, 22.6 (24.9 by the library) and 11.8 for exp;
/// side by side 1.9, 5.9, 17.7 (24.6) and 11.8.
[[nodiscard]] std::size_t cost(const OperationCounts& counts);

/// Whether each instruction is one of `wanted` or goes into one.
[[nodiscard]] std::vector<bool> needed_for(const Function& function,
                                           const std::vector<std::uint32_t>& wanted);

/// The same instructions by their numbers, ascending; of many, `most` and one more of the highest
/// numbers. Cost: that of the instructions that are found.
[[nodiscard]] std::vector<std::uint32_t> cone_of(
    const Function& function, std::vector<std::uint32_t> wanted,
    std::size_t most = std::numeric_limits<std::size_t>::max());

/// The instructions `order`, by their old numbers, and nothing else. Operands stand before what
/// they go into, and every entry is there. Repetitions stay where all of them stay at the end.
[[nodiscard]] Function reordered(const Function& function, const std::vector<std::uint32_t>& order);

/// Without the instructions that none of its entries needs.
///
///     before    0 = parameter m   1 = parameter l   2 = multiply 0 0   result = 2
///     after     0 = parameter m   1 = multiply 0 0                     result = 1
[[nodiscard]] Function pruned(const Function& function);

/// The instructions `entries` as one field, with what they need.
[[nodiscard]] Function with_entries(Function function, const std::vector<std::uint32_t>& entries);

/// Empty when all hold; otherwise the first broken invariant, named with function and instruction.
[[nodiscard]] std::string check_invariants(const Program& program);

/// Throws std::logic_error with the first broken invariant, in every build: E912. Linear in the
/// instructions.
void require_invariants(const Program& program);

[[nodiscard]] std::string dump(const Program& program);

/// The names of values for which nothing tells what they are: code has a hash of their content,
/// pages count them ("part_2").
enum class LastName : std::uint8_t { hash, number };

/// The names under which equations and the emitted code know an instruction; "" where it is
/// written out. Every name is a C++ identifier, unique in the function, stable under changes
/// elsewhere unless it is a number.
[[nodiscard]] std::vector<std::string> temporary_names(const Program& program,
                                                       const Function& function,
                                                       LastName last = LastName::hash);

/// Keeps the names that hold where leaves have other values, too: not those spelt over leaves, told
/// of values in frames, or made of a hash.
[[nodiscard]] std::vector<std::string> own_names(const Program& program, const Function& function);

}  // namespace elgen
