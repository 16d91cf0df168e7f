// cpp_signature: a Function -> its C++ declaration, with line breaks.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"

namespace elgen {

/// "const Coordinates<Scalar>&" and "q".
struct CppArgument {
  std::string type;
  std::string name;
};

/// Those of the output table: parameters, q, then v, a, u and t as far as the function takes them.
[[nodiscard]] std::vector<CppArgument> cpp_arguments(const Model& model, const Function& function);

/// "SquareMatrix<Scalar>", "ForwardDynamics<Scalar>"
[[nodiscard]] std::string result_type(const Function& function);

/// True where `word` stands in `text` as an identifier of its own: not as a member or part of a
/// name.
[[nodiscard]] bool mentions(std::string_view text, std::string_view word);

/// "[[nodiscard]] Forces<Scalar> bias(const Parameters<Scalar>& p, …) noexcept"; `start` ends
/// before the bracket. Arguments that the body does not mention have no name.
[[nodiscard]] std::string cpp_signature(const std::string& start,
                                        const std::vector<CppArgument>& arguments,
                                        std::string_view body);

}  // namespace elgen
