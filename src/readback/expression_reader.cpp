// expression_reader: recursive descent; a name is an argument, a local, or what it calls.
#include "readback/expression_reader.hpp"

#include <algorithm>

#include "elgen/wording.hpp"
#include "evaluate/scalar_literal.hpp"
#include "readback/literal.hpp"

namespace elgen {
namespace {

constexpr int deepest = 200;

}  // namespace

SignedNode ExpressionReader::read(const BodyScope& body) {
  body_ = &body;
  return sum();
}

SignedNode ExpressionReader::read_sine_cosine(const BodyScope& body) {
  body_ = &body;
  tokens_.expect_code("detail::SineCosine<Scalar>::of");
  return bracketed();
}

SignedNode ExpressionReader::sum() {
  SignedNode value = product();
  while (tokens_.at("+") || tokens_.at("-")) {
    const Opcode opcode = tokens_.advance().text == "+" ? Opcode::add : Opcode::subtract;
    const SignedNode next = product();
    value = graph_.binary(opcode, value, next);
  }
  return value;
}

SignedNode ExpressionReader::product() {
  SignedNode value = unary();
  while (tokens_.at("*") || tokens_.at("/")) {
    const Opcode opcode = tokens_.advance().text == "*" ? Opcode::multiply : Opcode::divide;
    const SignedNode next = unary();
    value = graph_.binary(opcode, value, next);
  }
  return value;
}

SignedNode ExpressionReader::unary() {
  if (!tokens_.at("-")) return primary();
  tokens_.advance();
  return negated(unary());
}

SignedNode ExpressionReader::primary() {
  if (tokens_.at("(")) return bracketed();
  if (tokens_.at(CodeTokenKind::number) && is_c()) return literal();
  if (!tokens_.at(CodeTokenKind::name)) tokens_.fail_expected("an operand");
  return named();
}

SignedNode ExpressionReader::bracketed() {
  if (++depth_ > deepest) tokens_.fail_expected("fewer brackets");
  tokens_.expect("(");
  const SignedNode value = sum();
  tokens_.expect(")");
  --depth_;
  return value;
}

/// Of C: a number of its one scalar, known by what it rounds to.
SignedNode ExpressionReader::literal() {
  const CodeToken token = tokens_.advance();
  const std::optional<Literal> literal = read_literal(token.text);
  const bool is_float = file_.dialect.scalar_kind == ScalarKind::single_precision;
  if (!literal || literal->suffix != (is_float ? 'f' : '\0')) {
    tokens_.fail(tokens_.span(token),
                 in_backticks(token.text) + " is no literal of type " + file_.dialect.scalar);
  }
  return graph_.constant(rounded(literal->value, *file_.dialect.scalar_kind));
}

/// constant<Scalar>(0.5): a number that is the same in every scalar.
SignedNode ExpressionReader::short_constant() {
  tokens_.expect_code("<Scalar>(");
  const CodeToken token = tokens_.advance();
  const std::optional<Literal> literal = read_literal(token.text);
  const bool is_exact = literal && literal->suffix == '\0' && exact_in_float(literal->value);
  if (!is_exact) {
    tokens_.fail(tokens_.span(token),
                 in_backticks(token.text) + " is no number that a float holds");
  }
  tokens_.expect(")");
  return graph_.constant(literal->value);
}

SignedNode ExpressionReader::named() {
  const CodeToken name = tokens_.advance();
  const auto is_meant = [&](Opcode argument) { return leaf_row(argument).symbol == name.text; };
  const auto known = std::find_if(body_->arguments.begin(), body_->arguments.end(), is_meant);
  if (known != body_->arguments.end()) return argument(*known);
  if (name.text == "w" && body_->has_workspace) return shared();
  const auto local = body_->locals.find(name.text);
  if (local != body_->locals.end()) return local->second;
  if (tokens_.at("(")) return call(name);
  if (is_c()) expect_in_scope(name);
  if (name.text == "constant") return short_constant();
  if (name.text == "detail") return kinked();
  return named_number(name);
}

SignedNode ExpressionReader::named_number(const CodeToken& name) {
  const auto known = file_.numbers.find(name.text);
  if (known == file_.numbers.end()) expect_in_scope(name);
  tokens_.expect_code("<Scalar>()");
  return graph_.constant(known->second);
}

void ExpressionReader::expect_in_scope(const CodeToken& name) {
  tokens_.fail(tokens_.span(name), in_backticks(name.text) + " is not declared here");
}

SignedNode ExpressionReader::argument(Opcode argument) {
  if (argument == Opcode::parameter) return parameter();
  if (is_single(argument)) return graph_.leaf(argument, 0);
  return graph_.leaf(argument, index(leaf_count(file_.origin.model, argument)));
}

std::uint32_t ExpressionReader::index(std::size_t size) {
  tokens_.expect("[");
  const CodeToken token = tokens_.current();
  const std::uint32_t index = tokens_.integer();
  if (index >= size) {
    tokens_.fail(tokens_.span(token),
                 in_backticks(token.text) + " is no index of " + counted(size, "number"));
  }
  tokens_.expect("]");
  return index;
}

SignedNode ExpressionReader::parameter() {
  tokens_.expect(file_.dialect.member);
  const CodeToken name = tokens_.current();
  const auto known = file_.parameters.find(tokens_.name());
  if (known == file_.parameters.end()) expect_in_scope(name);
  const ParameterMember& member = known->second;
  const std::uint32_t element = member.is_array ? index(member.leaves.size()) : 0;
  const std::optional<std::uint32_t> leaf = member.leaves[element];
  if (!leaf) expect_in_scope(name);
  return graph_.leaf(Opcode::parameter, *leaf);
}

SignedNode ExpressionReader::shared() {
  tokens_.expect(file_.dialect.member);
  const CodeToken name = tokens_.current();
  const auto known = workspace_.find(tokens_.name());
  if (known == workspace_.end()) expect_in_scope(name);
  if (!known->second)
    tokens_.fail(tokens_.span(name), in_backticks(name.text) + " has no value yet");
  return *known->second;
}

/// detail::sign_of<Scalar>(x): helpers of C++ for functions with kinks.
SignedNode ExpressionReader::kinked() {
  tokens_.expect("::");
  const CodeToken name = tokens_.current();
  const std::optional<FunctionId> function = kinked_function(tokens_.name());
  if (!function) expect_in_scope(name);
  tokens_.expect_code("<Scalar>");
  return call_of(*function);
}

std::optional<FunctionId> ExpressionReader::kinked_function(std::string_view helper) const {
  for (const FunctionRow& row : function_table) {
    if (!helper.empty() && own_name(row.id) == helper) return row.id;
  }
  return std::nullopt;
}

/// Of C in float: sinf is sin.
std::string_view ExpressionReader::without_suffix(std::string_view name) const {
  if (file_.dialect.scalar_kind != ScalarKind::single_precision) return name;
  return name.ends_with('f') ? name.substr(0, name.size() - 1) : std::string_view();
}

/// What a call by this name computes, square roots apart.
std::optional<FunctionId> ExpressionReader::function_named(std::string_view name) const {
  const std::string& prefix = file_.dialect.prefix;
  if (is_c() && name.starts_with(prefix)) return kinked_function(name.substr(prefix.size()));
  const std::string_view plain = without_suffix(name);
  if (is_c() && plain == "fabs") return FunctionId::abs;
  const FunctionRow* row = find_function(plain);
  const bool is_library =
      row != nullptr && (!is_kinked(row->id) || (!is_c() && row->id == FunctionId::abs));
  return is_library ? std::optional(row->id) : std::nullopt;
}

SignedNode ExpressionReader::call(const CodeToken& name) {
  const bool is_root = without_suffix(name.text) == "sqrt";
  const std::optional<FunctionId> function = function_named(name.text);
  const bool is_known = is_c() || body_->used.count(name.text) > 0;
  if ((!is_root && !function) || !is_known) expect_in_scope(name);
  return is_root ? graph_.square_root(bracketed()) : call_of(*function);
}

SignedNode ExpressionReader::call_of(FunctionId function) {
  if (function_row(function).arity == 1) return graph_.call(function, bracketed(), {});
  tokens_.expect("(");
  const SignedNode x = sum();
  tokens_.expect(",");
  const SignedNode y = sum();
  tokens_.expect(")");
  return graph_.call(function, x, y);
}

}  // namespace elgen
