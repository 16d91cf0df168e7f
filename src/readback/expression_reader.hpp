// ExpressionReader: an expression of C or C++ -> what it stands for, by the precedence of these
// languages:
//
//     sum     = product { ("+" | "-") product }
//     product = unary { ("*" | "/") unary }
//     unary   = "-" unary | primary
//     primary = "(" sum ")" | call | argument | local | number
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>

#include "dialect.hpp"
#include "elgen/arguments.hpp"
#include "token_reader.hpp"
#include "value_graph.hpp"

namespace elgen::reading {

/// A member of the parameters: the leaf of each element; none where the program has no such leaf.
struct ParameterMember {
  bool is_array = false;
  std::vector<std::optional<std::uint32_t>> leaves = {};
};

/// What the functions of a file may name.
struct FileScope {
  Origin origin;
  Dialect dialect;
  std::map<std::string, ParameterMember, std::less<>> parameters = {};
  std::map<std::string, cln::cl_R, std::less<>> numbers = {};  ///< "number_1_3"
};

/// What the statements of a body may name.
struct BodyScope {
  std::vector<Opcode> arguments = {};  ///< those with a name
  bool has_workspace = false;
  std::set<std::string_view> used = {};  ///< the functions of namespace std
  std::unordered_map<std::string_view, Value> locals = {};
};

/// Values that the parts of a function share; none before one has written them.
using Workspace = std::unordered_map<std::string_view, std::optional<Value>>;

class ExpressionReader {
 public:
  ExpressionReader(TokenReader& tokens, ValueGraph& graph, const FileScope& file,
                   const Workspace& workspace)
      : tokens_(tokens), graph_(graph), file_(file), workspace_(workspace) {}

  [[nodiscard]] Value read(const BodyScope& body);

 private:
  Value sum();
  Value product();
  Value unary();
  Value primary();
  Value bracketed();
  Value literal();
  Value short_constant();
  Value named();
  Value named_number(const CodeToken& name);
  Value argument(Opcode argument);
  Value parameter();
  Value shared();
  Value kinked();
  std::optional<FunctionId> kinked_function(std::string_view helper) const;
  std::optional<FunctionId> function_named(std::string_view name) const;
  bool is_square_root(std::string_view name) const;
  std::string_view without_suffix(std::string_view name) const;
  Value call(const CodeToken& name);
  Value call_of(FunctionId function);
  std::uint32_t index(std::size_t size);
  void expect_in_scope(const CodeToken& name);

  TokenReader& tokens_;
  ValueGraph& graph_;
  const FileScope& file_;
  const Workspace& workspace_;
  const BodyScope* body_ = nullptr;
  int depth_ = 0;
};

}  // namespace elgen::reading
