// function_signature: what a definition declares: the struct of its result, the workspace of its
// parts, types and arguments. FunctionReader's other half.
#include <fmt/format.h>

#include "elgen/wording.hpp"
#include "readback/function_reader.hpp"

namespace elgen {

void FunctionReader::same_name(std::string_view& known) {
  if (known.empty()) {
    known = tokens_.name();
  } else {
    tokens_.expect(known);
  }
}

/// Forces<Scalar> gravity;   double gravity[2];
void FunctionReader::struct_members() {
  has_members_ = true;
  for (const Result& result : results_) {
    const std::size_t size = result.entries.size();
    if (is_c() && size == 0) continue;
    tokens_.expect_code(type_of(result));
    tokens_.expect(result.field.name);
    if (is_c() && !result.is_number) tokens_.expect_code(fmt::format("[{}]", size));
    tokens_.expect(";");
  }
}

void FunctionReader::workspace_members() {
  while (!tokens_.at("}")) {
    tokens_.expect(file_.dialect.scalar);
    const CodeToken name = tokens_.current();
    const bool is_new = workspace_.emplace(tokens_.name(), std::nullopt).second;
    if (!is_new) tokens_.fail(tokens_.span(name), in_backticks(name.text) + " is declared twice");
    tokens_.expect(";");
  }
}

/// Of a field; in C of its elements.
std::string FunctionReader::type_of(const Result& result) const {
  if (is_c()) return file_.dialect.scalar;
  const OutputKind kind = kind_of_field(file_.origin.program, function_, result.field);
  const bool is_eigen = file_.dialect.shape == Shape::eigen;
  return is_eigen ? eigen_type(kind, result.field) : field_type(kind, result.field);
}

/// Of the whole: its struct, or the type of its one field.
std::string FunctionReader::result_type() const {
  return gives_struct(function_) ? std::string(struct_name_) + "<Scalar>"
                                 : type_of(results_.front());
}

void FunctionReader::signature() {
  scope_ = {};
  has_result_ = has_returned_ = false;
  is_returned_ = false;
  if (is_c()) return c_signature();
  if (in_parts_) return cpp_part_signature();
  cpp_signature();
}

void FunctionReader::cpp_signature() {
  is_returned_ = tokens_.at("[");
  if (is_returned_) tokens_.expect_code("[[nodiscard]]");
  if (file_.dialect.shape == Shape::cpp) tokens_.expect("ELGEN_FUNCTION");
  tokens_.expect_code(is_returned_ ? result_type() : "void");
  tokens_.expect(function_.name);
  tokens_.expect("(");
  if (!is_returned_) {
    tokens_.expect_code(result_type() + "& result,");
    has_result_ = true;
  }
  cpp_arguments();
}

void FunctionReader::cpp_part_signature() {
  if (file_.dialect.shape == Shape::cpp) tokens_.expect("ELGEN_FUNCTION");
  tokens_.expect("void");
  tokens_.expect(name_of_part(parts_));
  tokens_.expect("(");
  tokens_.expect_code(result_type() + "&");
  has_result_ = optional_name("result");
  tokens_.expect(",");
  tokens_.expect(workspace_name_);
  tokens_.expect_code("<Scalar>&");
  scope_.has_workspace = optional_name("w");
  tokens_.expect(",");
  cpp_arguments();
}

void FunctionReader::cpp_arguments() {
  for (std::size_t i = 0; i < arguments_.size(); ++i) {
    if (i > 0) tokens_.expect(",");
    cpp_argument(arguments_[i]);
  }
  tokens_.expect_code(") noexcept");
}

void FunctionReader::cpp_argument(Opcode argument) {
  const bool is_eigen = file_.dialect.shape == Shape::eigen && is_vector(argument);
  tokens_.expect("const");
  tokens_.expect_code(
      is_eigen ? fmt::format("Argument<Scalar, {}>", leaf_count(file_.origin.model, argument))
               : std::string(leaf_row(argument).type));
  tokens_.expect("&");
  if (optional_name(leaf_row(argument).symbol)) scope_.arguments.push_back(argument);
}

/// What a body does not mention has no name.
bool FunctionReader::optional_name(std::string_view name) {
  const bool is_named = !tokens_.at(",") && !tokens_.at(")");
  if (is_named) tokens_.expect(name);
  return is_named;
}

void FunctionReader::c_signature() {
  tokens_.expect_code("static inline");
  is_returned_ = !in_parts_ && !gives_struct(function_) && results_.front().is_number;
  tokens_.expect(is_returned_ ? file_.dialect.scalar : "void");
  tokens_.expect(in_parts_ ? name_of_part(parts_) : file_.dialect.prefix + function_.name);
  tokens_.expect("(");
  c_arguments();
  if (!is_returned_) c_result();
  tokens_.expect(")");
}

void FunctionReader::c_arguments() {
  const std::string& scalar = file_.dialect.scalar;
  for (std::size_t i = 0; i < arguments_.size(); ++i) {
    const Opcode argument = arguments_[i];
    const std::size_t size = leaf_count(file_.origin.model, argument);
    const std::string extent = size == 0 ? "" : std::to_string(size);
    if (i > 0) tokens_.expect(",");
    if (argument == Opcode::parameter) {
      tokens_.expect_code(fmt::format("const {}parameters *p", file_.dialect.prefix));
    } else if (is_single(argument)) {
      tokens_.expect_code(fmt::format("{} {}", scalar, leaf_row(argument).symbol));
    } else {
      tokens_.expect_code(
          fmt::format("const {} {}[{}]", scalar, leaf_row(argument).symbol, extent));
    }
  }
  scope_.arguments = arguments_;
}

/// The last argument, behind the workspace of parts.
void FunctionReader::c_result() {
  has_result_ = true;
  scope_.has_workspace = in_parts_;
  tokens_.expect(",");
  if (in_parts_) tokens_.expect_code(fmt::format("{} *w,", workspace_name_));
  if (gives_struct(function_)) {
    tokens_.expect_code(fmt::format("{} *result", struct_name_));
  } else {
    const std::size_t size = results_.front().entries.size();
    tokens_.expect_code(
        fmt::format("{} result[{}]", file_.dialect.scalar, size == 0 ? "" : std::to_string(size)));
  }
}

}  // namespace elgen
