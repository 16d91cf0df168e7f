#include "fuzz/command_line/mutation.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace elgen::test {

namespace {

using namespace std::string_literals;

/// Words of models, scenes and robots, and text that must not occur in these files.
const std::array words{"coordinate"s,
                       "parameters"s,
                       "frame"s,
                       "body"s,
                       "point"s,
                       "input"s,
                       "force"s,
                       "output"s,
                       "expect"s,
                       "equilibrium"s,
                       "energy"s,
                       "gravity"s,
                       "define"s,
                       "lock"s,
                       "approximate"s,
                       "rotation"s,
                       "quaternion"s,
                       "armature"s,
                       "range"s,
                       "for"s,
                       "sum"s,
                       "dot"s,
                       "sqrt"s,
#define ELGEN_FUNCTION(name, arity) std::string(#name),
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
                       "world"s,
                       "pi"s,
                       "t"s,
                       "rad"s,
                       "kg*m^2"s,
                       "double"s,
                       "joint"s,
                       "link"s,
                       "mimic"s,
                       "<inertia/>"s,
                       "0 0 1"s,
                       "revolute"s,
                       "prismatic"s,
                       "+"s,
                       "-"s,
                       "*"s,
                       "/"s,
                       "^"s,
                       "("s,
                       ")"s,
                       "["s,
                       "]"s,
                       "[["s,
                       "]]"s,
                       "{"s,
                       "}"s,
                       "\""s,
                       "'"s,
                       "="s,
                       ","s,
                       "."s,
                       "#"s,
                       "\\"s,
                       "\n"s,
                       "\r\n"s,
                       "\t"s,
                       "\0"s,
                       "\x7f"s,
                       "\xff"s,
                       "\xc3\xa9"s,
                       "\xe2\x80\xae"s,
                       "\xef\xbb\xbf"s,
                       "?\?/"s,
                       "*/"s,
                       "\"\"\""s,
                       "true"s,
                       "1979-05-27"s};

const std::array numbers{"0"s,
                         "-0"s,
                         "1"s,
                         "-1"s,
                         "2"s,
                         "1/3"s,
                         "0.1"s,
                         "1e-9"s,
                         "1e9"s,
                         "1e39"s,
                         "1e-46"s,
                         "1e308"s,
                         "1e-324"s,
                         "1e400"s,
                         "-1e-400"s,
                         "1e401"s,
                         "nan"s,
                         "inf"s,
                         "64"s,
                         "65"s,
                         "1000"s,
                         "1024"s,
                         "2147483648"s,
                         "9223372036854775808"s,
                         "0x10"s,
                         "1_000"s,
                         "00"s,
                         "1e"s,
                         "."s,
                         "pi"s,
                         "3.14159265358979323846264338327950288419716939937510"s};

Token::Kind kind_of(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (std::isdigit(byte) != 0) return Token::Kind::number;
  if (std::isalpha(byte) != 0 || c == '_') return Token::Kind::name;
  return std::isspace(byte) != 0 ? Token::Kind::blank : Token::Kind::other;
}

bool continues(Token::Kind kind, char c) {
  const Token::Kind next = kind_of(c);
  if (kind == Token::Kind::name) return next == Token::Kind::name || next == Token::Kind::number;
  if (kind == Token::Kind::number) return next == kind || c == '.' || c == 'e';
  return false;
}

void replace(std::string& text, const Token& token, const std::string& by) {
  text.replace(token.begin, token.size, by);
}

/// A random token of one of `kinds`; of size 0 if there is none.
Token any_token(const std::string& text, Draw& draw, const std::vector<Token::Kind>& kinds) {
  std::vector<Token> found;
  for (const Token& token : tokens_of(text)) {
    if (std::find(kinds.begin(), kinds.end(), token.kind) != kinds.end()) found.push_back(token);
  }
  return found.empty() ? Token{} : draw.one_of(found);
}

/// A name, number or sign of an expression; of size 0 if there is none.
Token part_of_expression(const std::string& text, Draw& draw) {
  std::vector<Token> found;
  for (const Token& token : tokens_of(text)) {
    if (token.is_quoted && token.kind != Token::Kind::blank) found.push_back(token);
  }
  return found.empty() ? Token{} : draw.one_of(found);
}

void change_byte(std::string& text, Draw& draw) {
  text[draw.number_below(text.size())] = static_cast<char>(draw.number_below(256));
}

void insert_byte(std::string& text, Draw& draw) {
  text.insert(draw.number_below(text.size() + 1), 1, static_cast<char>(draw.number_below(256)));
}

void remove_bytes(std::string& text, Draw& draw) {
  text.erase(draw.number_below(text.size()), 1 + draw.number_below(8));
}

void swap_token(std::string& text, Draw& draw) {
  const std::vector<Token::Kind> kinds{Token::Kind::name, Token::Kind::number, Token::Kind::other};
  const Token from = any_token(text, draw, kinds);
  const std::string word = text.substr(from.begin, from.size);
  replace(text, any_token(text, draw, kinds), word);
}

void rename(std::string& text, Draw& draw) {
  const Token from = any_token(text, draw, {Token::Kind::name});
  const std::string word = text.substr(from.begin, from.size);
  replace(text, any_token(text, draw, {Token::Kind::name}), word);
}

/// Replaces a name or number in an expression by a name or number from any expression, or replaces
/// a sign by a random sign.
void change_expression(std::string& text, Draw& draw) {
  static const std::string signs = "+-*/^";
  const Token at = part_of_expression(text, draw);
  const Token from = part_of_expression(text, draw);
  if (at.size == 0) return;
  if (at.kind != Token::Kind::other && from.kind != Token::Kind::other) {
    replace(text, at, text.substr(from.begin, from.size));
  } else if (signs.find(text[at.begin]) != std::string::npos) {
    text[at.begin] = signs[draw.number_below(signs.size())];
  }
}

void put_word(std::string& text, Draw& draw) {
  const std::string& word = draw.one_of(words);
  if (draw.number_below(2) == 0) {
    text.insert(draw.number_below(text.size() + 1), word);
  } else {
    replace(text, any_token(text, draw, {Token::Kind::name, Token::Kind::other}), word);
  }
}

void put_number(std::string& text, Draw& draw) {
  const std::string number =
      draw.number_below(2) == 0 ? draw.one_of(numbers) : std::to_string(1 + draw.number_below(9));
  replace(text, any_token(text, draw, {Token::Kind::number}), number);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    lines.push_back(text.substr(begin, end - begin));
    begin = end;
  }
  return lines;
}

void move_lines(std::string& text, Draw& draw) {
  std::vector<std::string> lines = lines_of(text);
  const std::size_t first = draw.number_below(lines.size());
  const std::size_t second = draw.number_below(lines.size());
  switch (draw.number_below(3)) {
    case 0:
      lines[first].clear();
      break;
    case 1:
      lines[first] += lines[second];
      break;
    default:
      std::swap(lines[first], lines[second]);
  }
  text.clear();
  for (const std::string& line : lines) text += line;
}

void cut_off(std::string& text, Draw& draw) { text.resize(draw.number_below(text.size())); }

}  // namespace

std::vector<Token> tokens_of(const std::string& text) {
  std::vector<Token> tokens;
  bool is_quoted = false;
  for (std::size_t at = 0; at < text.size();) {
    Token token{at, 1, kind_of(text[at])};
    while (at + token.size < text.size() && continues(token.kind, text[at + token.size])) {
      ++token.size;
    }
    if (text[at] == '\n') is_quoted = false;
    token.is_quoted = is_quoted && text[at] != '"';
    if (text[at] == '"') is_quoted = !is_quoted;
    at += token.size;
    tokens.push_back(token);
  }
  return tokens;
}

std::string mutate(std::string text, Draw& draw) {
  // Edits of expressions and numbers are repeated in the list, because they get past the parser
  // most often.
  static constexpr std::array mutations{
      change_byte,      insert_byte,       remove_bytes,      swap_token,        rename,
      put_word,         put_number,        put_number,        put_number,        move_lines,
      cut_off,          change_expression, change_expression, change_expression, change_expression,
      change_expression};
  const std::size_t count = draw.number_below(3) > 0 ? 1 : 2 + draw.number_below(3);
  for (std::size_t i = 0; i < count && !text.empty(); ++i) draw.one_of(mutations)(text, draw);
  return text;
}

}  // namespace elgen::test
