// statements: a Function -> named values and entries as text of a C-like language.
//
// What has a name becomes a statement; everything else is written out where it is used, with the
// brackets that keep the order of evaluation and no others:
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
#include "render/function_formulas.hpp"

namespace elgen {

/// An expression, and what stands in it.
struct Term {
  std::string text = {};
  std::vector<std::uint32_t> uses = {};          ///< statements, ascending, each once
  std::vector<std::uint32_t> instructions = {};  ///< those written out
};

struct Statement {
  std::string name;
  Term value;
};

struct FunctionBody {
  std::vector<Statement> statements = {};
  std::vector<std::vector<Term>> entries = {};  ///< one list per field, row-major
};

/// `names`: of each instruction, empty where it is written out.
[[nodiscard]] FunctionBody statements(const Program& program, const Function& function,
                                      const Vocabulary& vocabulary,
                                      const std::vector<std::string>& names);

/// The functions of the language that a function calls, square roots apart.
[[nodiscard]] std::set<FunctionId> called_functions(const Function& function);

}  // namespace elgen
