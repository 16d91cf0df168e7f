// statements: what the body of a Function computes, in order: what has a name, then the entries of
// its fields. Everything else is written out where it is used.
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

namespace elgen {

/// The instructions that a statement reads.
struct StatementOperands {
  std::vector<std::uint32_t> uses = {};     ///< named instructions, ascending, each once
  std::vector<std::uint32_t> written = {};  ///< instructions written out
};

/// A named value.
struct Assign {
  std::uint32_t instruction = 0;
  StatementOperands operands = {};
};

/// The sine and the cosine of an angle, computed at once.
struct SineAndCosine {
  std::uint32_t sine = 0;
  std::uint32_t cosine = 0;
  StatementOperands operands = {};
};

/// An entry of a field.
struct Entry {
  std::uint32_t instruction = 0;
  std::uint32_t field = 0;
  std::uint32_t index = 0;  ///< in its field
  StatementOperands operands = {};
};

/// A number that the loop over columns reads, in the array of them.
struct Given {
  std::uint32_t instruction = 0;
  std::uint32_t index = 0;
  StatementOperands operands = {};
};

/// The loop over columns. Its first instruction stands for all values that it computes.
struct Loop {
  std::uint32_t first = 0;
  StatementOperands operands = {};
};

/// Whoever writes or sorts statements has an overload for each kind, so that the compiler names the
/// places that lack a new one.
using Statement = std::variant<Assign, SineAndCosine, Entry, Given, Loop>;

[[nodiscard]] const StatementOperands& operands_of(const Statement& statement);

/// The instructions whose values have names from here on, ascending.
[[nodiscard]] std::vector<std::uint32_t> named_by(const Statement& statement);

/// Whether one statement computes the sine and the cosine of an angle, where both are needed.
enum class Pairing : std::uint8_t { joint, separate };

/// `names`: of each instruction, empty where it is written out. An entry that the loop computes
/// uses its first instruction.
[[nodiscard]] std::vector<Statement> statements(const Function& function,
                                                const std::vector<std::string>& names,
                                                Pairing pairing, const ColumnLoop& loop = {});

/// A long body in parts of bounded length, for compilers whose time grows faster than the length of
/// a function.
///
///     a = …; b = f(a); c = g(b)        part 1: a = …; b = f(a)
///     result 2 1 = b c          ->     part 2: result[0] = b; c = g(b); result[1] = c     b
///     crosses
///
/// An entry is written as soon as all that it uses is there, so that few values cross into later
/// parts.
struct Sections {
  std::vector<std::vector<Statement>> parts = {};  ///< at least one
  std::vector<bool> crosses = {};  ///< of each instruction: used in another part than its own
};

/// Bodies of up to so many statements compile in a second as they are.
inline constexpr std::size_t longest_body = 1000;
inline constexpr std::size_t section_length = 400;

[[nodiscard]] Sections sections(const std::vector<Statement>& statements,
                                std::size_t length_of_part);

}  // namespace elgen
