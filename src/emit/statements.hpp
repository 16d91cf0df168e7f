// statements: a Function -> named values and entries as text of a C-like language.
//
// What temporary_names() names becomes a statement; everything else is written out where it is
// used, with the brackets that keep the order of evaluation and no others:
//
//     2 = add 0 1  ; total        total = a + b
//     3 = multiply 2 2
//     result 2 1 = 3 2            total * total, total
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "elgen/program.hpp"

namespace elgen {

enum class Precedence : std::uint8_t { sum, product, negation, primary };

/// An expression, and the statements whose values it mentions (by index, ascending, each once).
struct Term {
  std::string text = {};
  Precedence precedence = Precedence::primary;
  std::vector<std::uint32_t> uses = {};
};

/// How a language writes leaves, constants, calls and temporaries.
class Spelling {
 public:
  virtual ~Spelling() = default;
  /// A parameter, coordinate, …, or time.
  [[nodiscard]] virtual std::string leaf(const Instruction& instruction) const = 0;
  [[nodiscard]] virtual Term constant(const Constant& constant) const = 0;
  /// `arguments` as they stand between the brackets: "x" or "y, x".
  [[nodiscard]] virtual std::string call(FunctionId function,
                                         const std::string& arguments) const = 0;
  [[nodiscard]] virtual std::string square_root(const std::string& argument) const = 0;
  /// The name as this language can take it.
  [[nodiscard]] virtual std::string temporary(const std::string& name) const = 0;
  /// A temporary that several parts of a function share, where it is written and read.
  [[nodiscard]] virtual std::string shared(const std::string& name) const = 0;
};

struct Statement {
  std::string name;
  Term value;
};

struct FunctionBody {
  std::vector<Statement> statements = {};
  std::vector<std::vector<Term>> entries = {};  ///< one list per field, row-major
};

/// Names of statements are unique in the function. `is_shared` (of each statement; empty: none)
/// says which of them are spelt as shared.
[[nodiscard]] FunctionBody statements(const Program& program, const Function& function,
                                      const Spelling& spelling,
                                      const std::vector<bool>& is_shared = {});

/// The functions of the language that a function calls, square roots apart.
[[nodiscard]] std::set<FunctionId> called_functions(const Function& function);

}  // namespace elgen
