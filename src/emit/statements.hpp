// statements: a Function -> named values and entries as text of a C-like language.
//
// What temporary_names() names becomes a statement; everything else is written out where it is
// used, with the brackets that keep the order of evaluation and no others:
//
//     2 = multiply 0 1            const Scalar x = a * b;
//     3 = add 2 2   ; x           (x + x) * c
//     4 = multiply 3 ...
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "elgen/program.hpp"

namespace elgen {

enum class Precedence : std::uint8_t { sum, product, negation, primary };

struct Term {
  std::string text = {};
  Precedence precedence = Precedence::primary;
};

/// How a language writes leaves, constants and calls.
class Spelling {
 public:
  virtual ~Spelling() = default;
  /// A parameter, coordinate, …, or time.
  [[nodiscard]] virtual std::string leaf(const Instruction& instruction) const = 0;
  [[nodiscard]] virtual Term constant(const Constant& constant) const = 0;
  /// `arguments` as they stand between the brackets: "x" or "y, x".
  [[nodiscard]] virtual std::string call(FunctionId function, const std::string& arguments) const = 0;
  [[nodiscard]] virtual std::string square_root(const std::string& argument) const = 0;
  /// The name as this language can take it.
  [[nodiscard]] virtual std::string temporary(const std::string& name) const = 0;
};

struct Statement {
  std::string name;
  std::string value;
};

struct FunctionBody {
  std::vector<Statement> statements = {};
  std::vector<std::vector<std::string>> entries = {};  ///< one list per field, row-major
};

/// An expression longer than this is cut by a statement named after its hash: compilers limit the
/// depth of brackets.
inline constexpr std::size_t longest_expression = 1000;

[[nodiscard]] FunctionBody statements(const Program& program, const Function& function,
                              const Spelling& spelling);

/// Which opcodes and functions a function uses, so that its text can leave out the rest.
struct Usage {
  std::set<Opcode> opcodes = {};
  std::set<FunctionId> calls = {};
};
[[nodiscard]] Usage usage(const Function& function);

}  // namespace elgen
