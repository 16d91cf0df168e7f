// pieces: the rows of spellings, and where brackets stand.
#include "pieces.hpp"

#include <fmt/format.h>

#include <cctype>

namespace elgen::rendering {
namespace {

/// What a formula spells differently from a program; the others are `\name`.
std::string latex_head(FunctionId function) {
  switch (function) {
    case FunctionId::asin:
      return "\\arcsin";
    case FunctionId::acos:
      return "\\arccos";
    case FunctionId::atan:
      return "\\arctan";
    case FunctionId::atan2:
      return "\\operatorname{atan2}";
    case FunctionId::log:
      return "\\ln";
    case FunctionId::sign:
      return "\\operatorname{sgn}";
    default:
      return fmt::format("\\{}", function_row(function).name);
  }
}

/// Brackets grow with what is taller than a line.
std::string in_brackets(const Notation& notation, const std::string& text) {
  const bool is_tall = notation.is_two_dimensional && (text.find("\\frac") != std::string::npos ||
                                                       text.find("\\sqrt") != std::string::npos);
  return is_tall ? fmt::format("\\left( {} \\right)", text) : fmt::format("({})", text);
}

std::string at_least(const Notation& notation, const Piece& piece, Precedence least) {
  return piece.precedence < least ? in_brackets(notation, piece.text()) : piece.text();
}

bool starts_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

Piece raised(const Notation& notation, const Factor& factor) {
  const Piece& base = factor.base;
  const std::string exponent = std::to_string(factor.exponent);
  if (!base.tail.empty()) {
    const std::string head = fmt::format(fmt::runtime(notation.power), base.head, exponent);
    return {head, Precedence::power, base.tail};
  }
  std::string text = at_least(notation, base, Precedence::atom);
  const bool has_exponent = notation.is_two_dimensional && base.precedence == Precedence::atom &&
                            text.find('^') != std::string::npos;
  if (has_exponent) text = fmt::format("{{{}}}", text);
  return {fmt::format(fmt::runtime(notation.power), text, exponent), Precedence::power};
}

/// Side by side, factors keep apart where one could be read into the other.
std::string separator(const Notation& notation, const Piece& before, const std::string& after) {
  if (!notation.is_two_dimensional) return "*";
  if (std::isdigit(static_cast<unsigned char>(after.front())) != 0) return " \\cdot ";
  const bool is_word = starts_with(before.head, "\\mathrm") || starts_with(after, "\\mathrm");
  return is_word || !before.tail.empty() ? " \\thinspace " : " ";
}

}  // namespace

const Notation& text_notation() {
  static constexpr Notation notation{"{} + {}",  "{} - {}", "-{}",          "{}^{}", "{}/{}",
                                     "sqrt({})", "dot({})", "dot(dot({}))", false};
  return notation;
}

const Notation& latex_notation() {
  static constexpr Notation notation{
      "{} + {}",      "{} - {}",     "-{}",          "{}^{{{}}}", "\\frac{{{}}}{{{}}}",
      "\\sqrt{{{}}}", "\\dot{{{}}}", "\\ddot{{{}}}", true};
  return notation;
}

Piece negated(const Notation& notation, const Piece& operand) {
  const std::string text = at_least(notation, operand, Precedence::product);
  return {fmt::format(fmt::runtime(notation.negate), text), Precedence::sum};
}

Piece sum(const Notation& notation, const Piece& left, const Piece& right) {
  return {fmt::format(fmt::runtime(notation.add), left.text(),
                      at_least(notation, right, Precedence::product)),
          Precedence::sum};
}

Piece difference(const Notation& notation, const Piece& left, const Piece& right) {
  return {fmt::format(fmt::runtime(notation.subtract), left.text(),
                      at_least(notation, right, Precedence::product)),
          Precedence::sum};
}

Piece quotient(const Notation& notation, const Piece& above, const Piece& below) {
  if (notation.is_two_dimensional) {
    return {fmt::format(fmt::runtime(notation.quotient), above.text(), below.text()),
            Precedence::power};
  }
  return {
      fmt::format(fmt::runtime(notation.quotient), at_least(notation, above, Precedence::product),
                  at_least(notation, below, Precedence::power)),
      Precedence::product};
}

Piece product(const Notation& notation, const std::vector<Factor>& factors) {
  std::string text;
  Piece last;
  for (const Factor& factor : factors) {
    Piece written = factor.exponent > 1 ? raised(notation, factor) : factor.base;
    // Only the first factor may be a quotient without brackets.
    const Precedence least = text.empty() ? Precedence::product : Precedence::power;
    const std::string next = at_least(notation, written, least);
    if (!text.empty()) text += separator(notation, last, next);
    text += next;
    last = std::move(written);
  }
  if (factors.size() == 1) return last;
  return {text, Precedence::product};
}

Piece square_root(const Notation& notation, const Piece& radicand) {
  const std::string text = fmt::format(fmt::runtime(notation.root), radicand.text());
  return {text, notation.is_two_dimensional ? Precedence::power : Precedence::atom};
}

Piece call(const Notation& notation, FunctionId function, const std::vector<Piece>& arguments) {
  std::string list;
  for (const Piece& argument : arguments) list += (list.empty() ? "" : ", ") + argument.text();
  if (!notation.is_two_dimensional) {
    return {fmt::format("{}({})", function_row(function).name, list)};
  }
  if (function == FunctionId::abs) return {fmt::format("\\left| {} \\right|", list)};
  const Piece& first = arguments.front();
  const bool is_alone = first.precedence == Precedence::atom && first.tail.empty();
  const bool is_fraction = first.precedence == Precedence::power && starts_with(list, "\\frac");
  const bool stands_free = arguments.size() == 1 && (is_alone || is_fraction);
  return {latex_head(function), Precedence::power,
          stands_free ? " " + list : in_brackets(notation, list)};
}

}  // namespace elgen::rendering
