// declarations: every element of every list is compared with the model's.
#include "readback/declarations.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "elgen/wording.hpp"
#include "evaluate/scalar_literal.hpp"
#include "readback/literal.hpp"
#include "readback/number_reader.hpp"

namespace elgen {
namespace {

/// User text as one line, with quotes and backslashes escaped.
std::string string_literal(std::string_view text) {
  std::string line;
  for (const char c : text) {
    const bool is_blank = static_cast<unsigned char>(c) <= ' ' || c == '\x7f';
    if (!is_blank) line += c;
    if (is_blank && !line.empty() && line.back() != ' ') line += ' ';
  }
  while (!line.empty() && line.back() == ' ') line.pop_back();
  if (!line.empty() && line.back() == '\\') line += '.';
  std::string literal = "\"";
  for (const char c : line) literal += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
  return literal + '"';
}

/// An end of an interval; `unbounded` where there is none, or none that double holds.
void read_bound(TokenReader& tokens, const std::optional<Interval>& interval, bool is_low) {
  const cln::cl_R bound = !interval ? cln::cl_RA(0) : is_low ? interval->low : interval->high;
  if (interval && fit(bound, ScalarKind::double_precision) != Fit::too_large) {
    return read_c_number(tokens, bound, ScalarKind::double_precision);
  }
  tokens.expect_code(is_low ? "-unbounded" : "unbounded");
}

void read_element(TokenReader& tokens, const DeclaredArray& array, std::size_t index) {
  if (array.has_texts) return tokens.expect_code(string_literal(array.texts[index]));
  tokens.expect("{");
  read_bound(tokens, array.intervals[index], true);
  tokens.expect(",");
  read_bound(tokens, array.intervals[index], false);
  tokens.expect("}");
}

void read_cpp_values(TokenReader& tokens, const std::vector<cln::cl_R>& values) {
  if (tokens.accept("detail")) {
    tokens.expect_code(fmt::format("::filled<{}>(", values.size()));
    const CodeToken first = tokens.current();
    read_cpp_number(tokens, values.front());
    const auto differs = [&](const cln::cl_R& value) { return value != values.front(); };
    if (std::any_of(values.begin(), values.end(), differs)) {
      tokens.fail(tokens.span_from(first), "the elements are not all the same");
    }
    return tokens.expect(")");
  }
  tokens.expect_code("{{");
  for (const cln::cl_R& value : values) {
    read_cpp_number(tokens, value);
    if (!tokens.at("}")) tokens.expect(",");
  }
  tokens.expect_code("}}");
}

}  // namespace

void read_declared_values(TokenReader& tokens, const DeclaredArray& array) {
  tokens.expect("{");
  if (array.size() > 0) {
    tokens.expect("{");
    for (std::size_t i = 0; i < array.size(); ++i) {
      if (i > 0) tokens.expect(",");
      read_element(tokens, array, i);
    }
    tokens.accept(",");
    tokens.expect("}");
  }
  tokens.expect("}");
}

std::map<std::string, ParameterMember, std::less<>> parameter_members(const Origin& origin) {
  std::map<std::string, std::uint32_t> leaves;
  const std::vector<std::string>& names = origin.program.leaves.parameters;
  for (std::uint32_t i = 0; i < names.size(); ++i) leaves.emplace(names[i], i);
  std::map<std::string, ParameterMember, std::less<>> members;
  for (const ParameterArray& array : emitted_parameters(origin.model, origin.program)) {
    ParameterMember member{array.is_array};
    for (std::uint32_t i = 0; i < array.count; ++i) {
      const auto leaf = leaves.find(origin.model.parameters[array.first + i].name);
      member.leaves.push_back(leaf == leaves.end() ? std::optional<std::uint32_t>()
                                                   : std::optional(leaf->second));
    }
    members.emplace(array.name, std::move(member));
  }
  return members;
}

void read_cpp_parameters(TokenReader& tokens, const Origin& origin) {
  for (const ParameterArray& array : emitted_parameters(origin.model, origin.program)) {
    const std::vector<cln::cl_R> values = values_of(origin.model, array);
    if (array.is_array) {
      tokens.expect_code(fmt::format("std::array<Scalar, {}> {} =", array.count, array.name));
      read_cpp_values(tokens, values);
    } else {
      tokens.expect_code(fmt::format("Scalar {} =", array.name));
      read_cpp_number(tokens, values.front());
    }
    tokens.expect(";");
  }
}

void read_c_parameters(TokenReader& tokens, const Origin& origin, const CodeDialect& dialect) {
  const std::vector<ParameterArray> arrays = emitted_parameters(origin.model, origin.program);
  for (const ParameterArray& array : arrays) {
    tokens.expect_code(fmt::format("{} {}", dialect.scalar, array.name));
    if (array.is_array) tokens.expect_code(fmt::format("[{}]", array.count));
    tokens.expect(";");
  }
  if (arrays.empty()) tokens.expect_code("char none;");
}

void read_c_defaults(TokenReader& tokens, const Origin& origin, const CodeDialect& dialect) {
  const std::vector<ParameterArray> arrays = emitted_parameters(origin.model, origin.program);
  tokens.expect("#");
  tokens.expect_code(
      fmt::format("define {}_DEFAULT_PARAMETERS {{", capitals(name_space(origin.scene))));
  for (const ParameterArray& array : arrays) {
    if (array.is_array) tokens.expect("{");
    bool is_first = true;
    for (const cln::cl_R& value : values_of(origin.model, array)) {
      if (!is_first) tokens.expect(",");
      read_c_number(tokens, value, *dialect.scalar_kind);
      is_first = false;
    }
    if (array.is_array) tokens.expect("}");
    tokens.expect(",");
  }
  if (arrays.empty()) tokens.expect("0");
  tokens.expect("}");
  if (!tokens.at(CodeTokenKind::end_of_directive)) tokens.fail_expected("the end of the line");
  tokens.advance();
}

}  // namespace elgen
