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

void FunctionReader::struct_members() {
  has_members_ = true;
  for (Result& result : results_) {
    if (is_c() && result.entries.empty()) continue;
    if (is_c()) {
      c_member(result);
    } else {
      const CodeToken first = tokens_.current();
      const WrittenType written = type();
      expect_type(written, result, first);
      tokens_.expect(result.field.name);
    }
    tokens_.expect(";");
  }
}

void FunctionReader::c_member(Result& result) {
  tokens_.expect(file_.dialect.scalar);
  tokens_.expect(result.field.name);
  result.is_number = !tokens_.at("[");
  if (result.is_number && result.entries.size() == 1) return;
  tokens_.expect("[");
  tokens_.expect_integer(result.entries.size());
  tokens_.expect("]");
}

void FunctionReader::workspace_members() {
  while (!tokens_.at("}")) {
    tokens_.expect(file_.dialect.scalar);
    const CodeToken name = tokens_.current();
    const bool is_new = workspace_.emplace(tokens_.name(), std::nullopt).second;
    if (!is_new) tokens_.fail(tokens_.span(name), quoted(name.text) + " is declared twice");
    tokens_.expect(";");
  }
}

WrittenType FunctionReader::type() {
  using Kind = WrittenType::Kind;
  if (tokens_.accept("Scalar")) return {};
  if (!struct_name_.empty() && tokens_.accept(struct_name_)) {
    tokens_.expect_code("<Scalar>");
    return {Kind::structure};
  }
  return file_.dialect.shape == Shape::eigen ? eigen_type() : array_type();
}

WrittenType FunctionReader::eigen_type() {
  using Kind = WrittenType::Kind;
  const bool is_matrix = tokens_.accept("Matrix");
  if (!is_matrix) tokens_.expect("Vector");
  tokens_.expect_code("<Scalar,");
  const std::size_t rows = tokens_.integer();
  if (is_matrix) tokens_.expect(",");
  const std::size_t columns = is_matrix ? tokens_.integer() : 1;
  tokens_.expect(">");
  return {Kind::matrix, rows, columns};
}

/// An array, or one of the names that the header gives to arrays.
WrittenType FunctionReader::array_type() {
  using Kind = WrittenType::Kind;
  const Model& model = file_.origin.model;
  const std::size_t n = model.velocities.size();
  if (tokens_.accept("std")) {
    tokens_.expect_code("::array<Scalar,");
    std::size_t size = count();
    while (tokens_.accept("*")) size *= count();
    tokens_.expect(">");
    return {Kind::array, size, 1};
  }
  const CodeToken name = tokens_.current();
  const std::map<std::string_view, std::size_t> sizes{{"Coordinates", model.coordinates.size()},
                                                      {"Velocities", n},
                                                      {"Accelerations", n},
                                                      {"Forces", n},
                                                      {"Inputs", model.inputs.size()},
                                                      {"SquareMatrix", n * n},
                                                      {"InputMatrix", n * model.inputs.size()}};
  const auto known = sizes.find(name.text);
  if (known == sizes.end()) tokens_.fail_expected("the type of a result");
  tokens_.advance();
  tokens_.expect_code("<Scalar>");
  return {Kind::array, known->second, 1};
}

std::size_t FunctionReader::count() {
  const Model& model = file_.origin.model;
  if (tokens_.accept("coordinate_count")) return model.coordinates.size();
  if (tokens_.accept("velocity_count")) return model.velocities.size();
  if (tokens_.accept("input_count")) return model.inputs.size();
  return tokens_.integer();
}

void FunctionReader::expect_type(const WrittenType& type, Result& result, const CodeToken& first) {
  using Kind = WrittenType::Kind;
  const Field& field = result.field;
  result.is_number = type.kind == Kind::number;
  const bool is_right =
      type.kind == Kind::matrix
          ? type.rows == field.rows && type.columns == field.columns
          : type.kind != Kind::structure && type.rows * type.columns == field.entries.size();
  if (is_right) return;
  tokens_.fail(tokens_.span_from(first),
               fmt::format("{} has no place for {} times {} entries",
                           quoted(tokens_.span_from(first)), field.rows, field.columns));
}

/// Of the whole: its struct, or the type of its one field.
void FunctionReader::result_type() {
  const CodeToken first = tokens_.current();
  const WrittenType written = type();
  if (!is_struct(function_)) {
    expect_type(written, results_.front(), first);
  } else if (written.kind != WrittenType::Kind::structure) {
    tokens_.fail(tokens_.span_from(first), "the result of several fields is no struct");
  }
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
  is_returned_ = !tokens_.at("void");
  if (is_returned_) {
    tokens_.expect_code("[[nodiscard]]");
    result_type();
  } else {
    tokens_.expect("void");
  }
  tokens_.expect(function_.name);
  tokens_.expect("(");
  if (!is_returned_) {
    result_type();
    tokens_.expect_code("& result,");
    has_result_ = true;
  }
  cpp_arguments();
}

void FunctionReader::cpp_part_signature() {
  tokens_.expect("void");
  tokens_.expect(name_of_part(parts_));
  tokens_.expect("(");
  result_type();
  tokens_.expect("&");
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
  const bool is_number = !in_parts_ && !tokens_.at("void");
  is_returned_ = is_number;
  tokens_.expect(is_number ? file_.dialect.scalar : "void");
  tokens_.expect(in_parts_ ? name_of_part(parts_) : file_.dialect.prefix + function_.name);
  tokens_.expect("(");
  c_arguments();
  if (is_number) {
    results_.front().is_number = true;
  } else {
    c_result();
  }
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
    } else if (argument == Opcode::time) {
      tokens_.expect_code(scalar + " t");
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
  if (is_struct(function_)) {
    tokens_.expect_code(fmt::format("{} *result", struct_name_));
  } else {
    const std::size_t size = results_.front().entries.size();
    tokens_.expect_code(
        fmt::format("{} result[{}]", file_.dialect.scalar, size == 0 ? "" : std::to_string(size)));
  }
}

}  // namespace elgen
