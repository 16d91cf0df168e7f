// FunctionReader: the written definition of one function, in its parts where it is long, compared
// with the Program's statement by statement and entry by entry.
//
//     const Scalar t_1 = p.m * p.l;      is the first named instruction of the function
//     return {{p.M + p.m, t_1}};         are entries 0 and 1 in the order of storage
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "readback/expression_reader.hpp"

namespace elgen {

class FunctionReader {
 public:
  FunctionReader(TokenReader& tokens, const FileScope& file, const Function& function);

  // Which part of the definition comes next.
  [[nodiscard]] bool wants_struct() const;
  [[nodiscard]] bool wants_parts();
  [[nodiscard]] bool wants_part();

  // The holes of the pictures.
  void struct_name() { same_name(struct_name_); }
  void struct_members();
  void workspace_name() { same_name(workspace_name_); }
  void workspace_members();
  void signature();
  void body();

  /// What stands above the whole.
  [[nodiscard]] const std::vector<std::string_view>& comments() const { return comments_; }

 private:
  struct Result {
    const Field& field;
    std::vector<std::uint32_t> entries;  ///< instructions, as stored
    std::vector<bool> written;
    bool is_number;
  };

  /// Of a sine and a cosine.
  using Pair = std::pair<SignedNode, SignedNode>;

  [[nodiscard]] bool is_c() const { return file_.dialect.shape == Shape::c99; }
  [[nodiscard]] std::string name_of_part(std::size_t part) const;
  [[nodiscard]] bool has_parts() const { return !workspace_name_.empty(); }

  /// The first occurrence of a name says it, the others repeat it.
  void same_name(std::string_view& known);
  [[nodiscard]] std::string type_of(const Result& result) const;
  [[nodiscard]] std::string result_type() const;

  void cpp_signature();
  void cpp_part_signature();
  void cpp_arguments();
  void cpp_argument(Opcode argument);
  void c_signature();
  void c_arguments();
  void c_result();
  bool optional_name(std::string_view name);

  void statement();
  void using_declaration();
  void unused_argument();
  void declaration();
  void declared_pair();
  void result_declaration();
  void shared_assignment();
  void shared_pair();
  void assignment();
  void returned();
  void returned_values();
  void calls_of_parts();
  void array_value(std::size_t result);
  void entry(std::size_t result, std::size_t index, const CodeToken& first);
  void declare(const CodeToken& name, SignedNode value);
  void share(const CodeToken& name, SignedNode value);
  CodeToken shared_name();
  SignedNode named_value(const CodeToken& name);
  Pair pair_values(const CodeToken& sine, const CodeToken& cosine);
  SignedNode next_value(const CodeToken& name, SignedNode written, const CodeToken& first);
  void compare(SignedNode written, SignedNode derived, const CodeToken& first,
               const std::string& what);
  void expect_complete();
  std::size_t result_named(std::string_view name, const CodeToken& token);

  TokenReader& tokens_;
  const FileScope& file_;
  const Function& function_;
  ValueGraph graph_;
  std::vector<SignedNode> values_ = {};    ///< of every instruction
  std::vector<std::uint32_t> named_ = {};  ///< instructions that are statements
  std::size_t next_statement_ = 0;
  std::vector<Result> results_ = {};
  std::vector<Opcode> arguments_;
  Workspace workspace_ = {};
  ExpressionReader expressions_;
  BodyScope scope_ = {};
  std::vector<std::string_view> comments_ = {};
  std::string_view struct_name_ = {};
  std::string_view workspace_name_ = {};
  std::size_t parts_ = 0;
  bool has_members_ = false;
  bool in_parts_ = false;
  bool is_returned_ = false;   ///< the function returns its result
  bool has_result_ = false;    ///< `result` is in scope
  bool has_returned_ = false;  ///< a return has been read
};

}  // namespace elgen
