// statements: the body of a Function in order: the named values, then the entries of the result.
// Other instructions are written out at each use.
//
//     2 = add 0 1  ; total        total = a + b
//     3 = multiply 2 2
//     result 2 1 = 3 2            total * total, total
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "elgen/program.hpp"
#include "emit/code/column_loop.hpp"
#include "program/evaluate/sine_calls.hpp"

namespace elgen {

/// Instructions that a statement reads.
struct StatementOperands {
  std::vector<std::uint32_t> uses = {};  ///< named instructions, ascending, without duplicates
  std::vector<std::uint32_t> inlined_instructions = {};  ///< written out in the statement
};

/// Assigns a named value.
struct AssignStatement {
  std::uint32_t instruction = 0;
  StatementOperands operands = {};
};

/// Computes the sine and the cosine of an angle together.
struct SineCosineStatement {
  std::uint32_t sine = 0;
  std::uint32_t cosine = 0;
  StatementOperands operands = {};
};

/// Computes the sines and cosines of several angles together.
struct AnglesStatement {
  AngleGroup calls = {};
  std::size_t number = 0;  ///< of the group in its function, from 1
  StatementOperands operands = {};
};

/// Writes an entry of a field.
struct EntryStatement {
  std::uint32_t instruction = 0;
  std::uint32_t field = 0;
  std::uint32_t index = 0;  ///< in its field
  StatementOperands operands = {};
};

/// Stores an operand of the loop over columns in the array `given`.
struct LoopOperandStatement {
  std::uint32_t instruction = 0;
  std::uint32_t index = 0;
  StatementOperands operands = {};
};

/// The loop over columns. The instruction `first` represents all values that the loop computes.
struct LoopStatement {
  std::uint32_t first = 0;
  StatementOperands operands = {};
};

/// A variant: code that writes or sorts statements needs an overload for each kind, and the
/// compiler reports a missing overload.
using Statement = std::variant<AssignStatement, SineCosineStatement, AnglesStatement,
                               EntryStatement, LoopOperandStatement, LoopStatement>;

[[nodiscard]] const StatementOperands& operands_of(const Statement& statement);

/// Instructions to which the statement gives names.
[[nodiscard]] std::vector<std::uint32_t> assigned_values(const Statement& statement);

/// The statements of a function, in the order of evaluation. The operands of a group of angles
/// precede the group. `names`: one per instruction; "" if the instruction is written out. All
/// instructions of groups have names. An entry that the loop computes has the first instruction of
/// the loop as operand.
[[nodiscard]] std::vector<Statement> make_statements(const Function& function,
                                                     const std::vector<std::string>& names,
                                                     SineCosinePairing pairing,
                                                     const ColumnLoop& loop = {});

/// A long body, cut into parts of bounded length because compile time grows faster than the length
/// of a function.
///
///     a = …; b = f(a); c = g(b)        part 1: a = …; b = f(a)
///     result 2 1 = b c          ->     part 2: result[0] = b; c = g(b); result[1] = c
///
/// The value b crosses. An entry is written as soon as its operands are computed, so that few
/// values cross into later parts.
struct BodyParts {
  std::vector<std::vector<Statement>> parts = {};  ///< at least one
  std::vector<bool> crosses_parts = {};            ///< per instruction: another part uses its value
};

/// Bodies of up to this many statements compile within a second and are not cut.
inline constexpr std::size_t max_body_statements = 1000;
inline constexpr std::size_t statements_per_part = 400;

[[nodiscard]] BodyParts cut_into_parts(const std::vector<Statement>& statements,
                                       std::size_t length_of_part);

}  // namespace elgen
