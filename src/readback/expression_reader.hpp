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

#include "elgen/arguments.hpp"
#include "readback/dialect.hpp"
#include "readback/token_reader.hpp"
#include "readback/value_graph.hpp"

namespace elgen {

/// A member of the parameters: the leaf of each element; none where the program has no such leaf.
struct ParameterMember {
  bool is_array = false;
  std::vector<std::optional<std::uint32_t>> leaves = {};
};

/// What the functions of a file may name.
struct FileScope {
  Origin origin;
  CodeDialect dialect;
  std::map<std::string, ParameterMember, std::less<>> parameters = {};
  std::map<std::string, cln::cl_R, std::less<>> numbers = {};  ///< "number_1_3"
};

/// What the statements of a body may name.
struct BodyScope {
  std::vector<Opcode> arguments = {};  ///< those with a name
  bool has_workspace = false;
  std::set<std::string_view> used = {};  ///< the functions of namespace std
  std::unordered_map<std::string_view, SignedNode> locals = {};
};

/// Values that the parts of a function share; none before one has written them.
using Workspace = std::unordered_map<std::string_view, std::optional<SignedNode>>;

class ExpressionReader {
 public:
  ExpressionReader(TokenReader& tokens, ValueGraph& graph, const FileScope& file,
                   const Workspace& workspace)
      : tokens_(tokens), graph_(graph), file_(file), workspace_(workspace) {}

  [[nodiscard]] SignedNode read(const BodyScope& body);
  /// The angle of `detail::SineCosine<Scalar>::of(angle)`.
  [[nodiscard]] SignedNode read_sine_cosine(const BodyScope& body);

 private:
  [[nodiscard]] bool is_c() const { return file_.dialect.shape == Shape::c99; }
  SignedNode sum();
  SignedNode product();
  SignedNode unary();
  SignedNode primary();
  SignedNode bracketed();
  SignedNode literal();
  SignedNode short_constant();
  SignedNode named();
  SignedNode named_number(const CodeToken& name);
  SignedNode argument(Opcode argument);
  SignedNode parameter();
  SignedNode shared();
  SignedNode kinked();
  std::optional<FunctionId> kinked_function(std::string_view helper) const;
  std::optional<FunctionId> function_named(std::string_view name) const;
  std::string_view without_suffix(std::string_view name) const;
  SignedNode call(const CodeToken& name);
  SignedNode call_of(FunctionId function);
  std::uint32_t index(std::size_t size);
  void expect_in_scope(const CodeToken& name);

  TokenReader& tokens_;
  ValueGraph& graph_;
  const FileScope& file_;
  const Workspace& workspace_;
  const BodyScope* body_ = nullptr;
  int depth_ = 0;
};

}  // namespace elgen
