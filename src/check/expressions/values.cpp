// ValueReader, and the dimension of the vectors in a file.
#include "check/expressions/values.hpp"

#include <cln/float.h>

#include <algorithm>
#include <utility>

#include "base/reason.hpp"
#include "check/expressions/resolver.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

cln::cl_R round_irrational(const cln::cl_R& value) {
  return is_rational(value) ? value
                            : cln::cl_R(cln::cl_float(value, cln::float_format(constant_digits)));
}

/// The name of the world's origin in `joined_to`.
constexpr std::string_view origin = "origin";

/// True if the nodes are only numbers, pi and operations on them.
bool is_numeric(const std::vector<Expression>& nodes, ExpressionId first, ExpressionId last) {
  return std::none_of(nodes.begin() + first, nodes.begin() + last + 1, [](const auto& node) {
    return node.kind == ExpressionKind::leaf || node.kind == ExpressionKind::named;
  });
}

}  // namespace

void report_degrees(Report& report, const Span& span, const cln::cl_RA& angle) {
  report.add(
      Code::E405, span, in_backticks(span) + " is in rad",
      "a turn is `2*pi`, and as degrees it would be " + quote_text(multiple_of_pi(angle / 180)));
}

void note_degrees(Report& report, const Span& span, const Coordinate& coordinate,
                  const std::optional<cln::cl_R>& value) {
  if (!is_angle(coordinate) || !value || !is_rational(*value)) return;
  const cln::cl_RA angle = cln::rational(*value);
  const bool is_multiple = cln::denominator(angle / 5) == 1;
  if (is_multiple && cln::abs(angle) > 7) report_degrees(report, span, angle);  // 2 pi < 7
}

ExpressionId ValueReader::read_root(const ExpressionSyntax& expression,
                                    const RootRequest& request) {
  const auto first = static_cast<ExpressionId>(context_.model.expressions.size());
  const std::optional<ExpressionId> id =
      Resolver(context_, scope_, request.role.allowed).resolve(expression);
  if (!id) return no_expression;
  const bool plain = request.unit && is_numeric(context_.model.expressions, first, *id);
  context_.roots.push_back({first, *id, request.role, request.unit, false, plain});
  return *id;
}

ExpressionId ValueReader::root(const ValueSyntax& value, const RootRequest& request) {
  return read_root(value.expression, request);
}

ExpressionId ValueReader::read_scene_value(const ValueSyntax& value, const RootRequest& request) {
  const ExpressionId id = root(value, request);
  if (id == no_expression) return id;
  WrittenExpression& read = context_.roots.back();
  const auto& nodes = context_.model.expressions;
  read.is_in_role_unit = std::none_of(
      nodes.begin() + read.first, nodes.begin() + read.value + 1, [](const Expression& node) {
        return is_leaf(node, Opcode::parameter) || refers_to_entry(node, NamedKind::prescribed) ||
               refers_to_entry(node, NamedKind::definition);
      });
  return id;
}

std::vector<ExpressionId> ValueReader::read_roots(const ValueSyntax& value,
                                                  const RootRequest& request) {
  if (value.kind != ValueKind::list) return {root(value, request)};
  std::vector<ExpressionId> result;
  for (const ValueSyntax& item : value.items) result.push_back(root(item, request));
  return result;
}

std::optional<cln::cl_R> ValueReader::read_constant(const ValueSyntax& value) {
  const std::size_t size = context_.model.expressions.size();
  const std::optional<FixedValue> result = read_exact_constant(value);
  context_.truncate(size);
  return result ? std::optional(result->number) : std::nullopt;
}

std::optional<FixedValue> ValueReader::read_exact_constant(const ValueSyntax& value,
                                                           std::string hint) {
  const ExpressionSyntax& syntax = value.expression;
  const std::size_t size = context_.model.expressions.size();
  const std::optional<ExpressionId> id = Resolver(context_, scope_).resolve(syntax);
  const std::optional<cln::cl_R> result = id ? context_.constants[*id] : std::optional<cln::cl_R>{};
  const bool needs_form = result && !is_rational(*result);
  if (!needs_form) context_.truncate(size);
  if (id && !result) {
    context_.report.add(Code::E319, syntax.span,
                        in_backticks(syntax.span) + " is not a constant number", std::move(hint));
  }
  if (!result) return std::nullopt;
  return FixedValue{round_irrational(*result), needs_form ? id : std::nullopt};
}

std::optional<Interval> ValueReader::read_interval(const EntrySyntax& entry, std::string_view key) {
  const KeySyntax* given = entry.find(key);
  return given == nullptr ? std::nullopt : read_interval(given->value);
}

std::optional<Interval> ValueReader::read_interval(const ValueSyntax& value) {
  const std::optional<cln::cl_R> low = read_constant(value.items[0]);
  const std::optional<cln::cl_R> high = read_constant(value.items[1]);
  if (!low || !high) return std::nullopt;
  if (*low >= *high) {
    context_.report.add(
        Reason::empty_range, value.span,
        in_backticks(value.items[0].span) + " is not below " + in_backticks(value.items[1].span));
    return std::nullopt;
  }
  return Interval{*low, *high};
}

std::optional<std::uint32_t> ValueReader::resolve_reference(const ValueSyntax& value,
                                                            SymbolKind kind) {
  const ExpressionSyntax& name = value.expression;
  Resolver resolver(context_, scope_);
  const DeclaredName* symbol = resolver.require_declaration(name, kind, true, name.text);
  return symbol == nullptr ? std::nullopt : resolver.resolve_element(name, *symbol);
}

std::optional<std::uint32_t> ValueReader::resolve_rotation_name(const ValueSyntax& value) {
  const ExpressionSyntax& name = value.expression;
  const DeclaredName* symbol =
      Resolver(context_, scope_)
          .require_declaration(name, SymbolKind::rotation, name.operands.empty(),
                               covered_text(name.span));
  if (symbol == nullptr) return std::nullopt;
  return context_.model.velocities[symbol->elements.begin()->second].rotation;
}

std::optional<std::uint32_t> ValueReader::resolve_velocity_name(const ValueSyntax& value) {
  const DeclaredName* symbol = context_.symbols.find(value.expression.text);
  if (symbol != nullptr && symbol->kind == SymbolKind::rotation) {
    return Resolver(context_, scope_).resolve_element(value.expression, *symbol);
  }
  if (symbol != nullptr && symbol->kind == SymbolKind::point) {
    const std::string name = in_backticks(value.span);
    context_.report.add(Reason::name_of_another_kind, value.span, "unknown coordinate " + name,
                        name + " is a point: write `at` in the place of `on`");
    return std::nullopt;
  }
  const std::optional<std::uint32_t> coordinate = resolve_reference(value, SymbolKind::coordinate);
  return coordinate ? std::optional(context_.model.coordinates[*coordinate].velocity)
                    : std::nullopt;
}

bool ValueReader::check_vector(const ValueSyntax& value) {
  const std::size_t count = value.items.size();
  if (count != 2 && count != 3) {
    context_.report.add(Reason::wrong_component_count, value.span,
                        count_text(count, "component") + ", but a vector has 2 or 3");
    return false;
  }
  if (context_.dimension == 0) {
    context_.dimension = static_cast<std::uint32_t>(count);
  } else if (count != context_.dimension) {
    context_.report.add(Code::E516, value.span,
                        count_text(count, "component") + ", but other vectors of this model have " +
                            std::to_string(context_.dimension));
  }
  return true;
}

namespace {

/// For each n < 4: the number of vectors with n components in the file.
std::array<std::size_t, 4> count_vectors(const FileSyntax& model) {
  constexpr std::array<std::string_view, 4> vectors{"at", "com", "translate", "vector"};
  std::array<std::size_t, 4> counts{};
  for (const EntrySyntax& entry : model.entries) {
    for (const KeySyntax& key : entry.keys) {
      const bool is_vector = key.value.kind == ValueKind::list && key.value.items.size() < 4 &&
                             std::ranges::find(vectors, key.key) != vectors.end();
      if (is_vector) ++counts[key.value.items.size()];
    }
  }
  return counts;
}

}  // namespace

std::uint32_t majority_dimension(const FileSyntax& model) {
  const auto counts = count_vectors(model);
  if (counts[2] == 0 || counts[3] == 0 || counts[2] == counts[3]) return 0;
  return counts[2] > counts[3] ? 2 : 3;
}

bool is_planar(const FileSyntax& model) {
  const auto counts = count_vectors(model);
  return counts[2] > counts[3];
}

std::optional<std::uint32_t> ValueReader::resolve_frame_or_world(const ValueSyntax& value) {
  const ExpressionSyntax& name = value.expression;
  if (name.text == world && name.operands.empty()) return std::nullopt;
  return resolve_reference(value, SymbolKind::frame);
}

std::optional<LineEnd> ValueReader::resolve_joined_place(const ValueSyntax& value) {
  const ExpressionSyntax& name = value.expression;
  const DeclaredName* point = context_.symbols.find(name.text);
  if (point != nullptr && point->kind != SymbolKind::point) point = nullptr;
  const DeclaredName* const frame = context_.frames.find(name.text);
  if (name.kind == SyntaxKind::name && (point != nullptr || frame != nullptr)) {
    const auto index =
        Resolver(context_, scope_)
            .resolve_element(name, point != nullptr ? *point : *frame, Reason::unknown_place);
    if (!index) return std::nullopt;
    return point != nullptr ? LineEnd{.point = index} : LineEnd{.frame = index};
  }
  if (name.kind == SyntaxKind::name && name.text == origin && name.operands.empty()) {
    return LineEnd{};
  }
  if (context_.symbols.has_failed(name.text) || context_.frames.has_failed(name.text)) {
    return std::nullopt;
  }
  std::vector<std::string> names = context_.symbols.names({SymbolKind::point});
  for (std::string& each : context_.frames.names()) names.push_back(std::move(each));
  names.emplace_back(origin);
  context_.report.add(Reason::unknown_place, name.span, "unknown place " + in_backticks(name.span),
                      name.text == world ? "the origin of the world is `origin`"
                                         : context_.symbols.suggest(name.text, names));
  return std::nullopt;
}

std::array<const KeySyntax*, 2> first_two_keys(const EntrySyntax& entry,
                                               std::span<const std::string_view> keys) {
  std::array<const KeySyntax*, 2> found{};
  for (const KeySyntax& key : entry.keys) {
    if (std::ranges::find(keys, key.key) == keys.end()) continue;
    if (found[0] != nullptr) return {found[0], &key};
    found[0] = &key;
  }
  return found;
}

ExpressionSyntax difference_syntax(const ExpressionSyntax& larger, const ExpressionSyntax& smaller,
                                   const Span& span) {
  ExpressionSyntax negated;
  negated.kind = SyntaxKind::negate;
  negated.operands.push_back(smaller);
  negated.span = negated.token = smaller.span;
  ExpressionSyntax sum;
  sum.kind = SyntaxKind::add;
  sum.operands.push_back(larger);
  sum.operands.push_back(std::move(negated));
  sum.span = sum.token = span;
  return sum;
}

std::optional<ExpressionSyntax> residual_syntax(const ValueSyntax& equation) {
  const KeySyntax* const left = equation.find("left");
  const KeySyntax* const right = equation.find("right");
  if (left == nullptr || right == nullptr) return std::nullopt;  // reported by the parser
  const ExpressionSyntax& other = right->value.expression;
  const bool is_zero = other.kind == SyntaxKind::number && cln::zerop(other.value);
  if (is_zero) return left->value.expression;
  return difference_syntax(left->value.expression, other, equation.span);
}

std::vector<KeySyntax> parse_option_keys(Context& context,
                                         const std::vector<SourcePointer>& options, KeyType type) {
  Result<std::vector<KeySyntax>> keys = parse_options(options, type, context.limits);
  for (Diagnostic& problem : keys.diagnostics) context.report.add(std::move(problem));
  return *std::move(keys.value);
}

}  // namespace elgen
