// code_tokens: one pass; lines that end with a backslash are continued, also in comments.
#include "readback/code_tokens.hpp"

#include <algorithm>
#include <array>

#include "base/ascii.hpp"

namespace elgen {
namespace {

/// Longest first.
constexpr std::array<std::string_view, 20> long_signs{"...", "->", "::", "++", "--", "<<", ">>",
                                                      "<=",  ">=", "==", "!=", "&&", "||", "+=",
                                                      "-=",  "*=", "/=", "%=", "<:", "<%"};
constexpr std::string_view short_signs = "+-*/=<>()[]{},;:.&?!#";

class Scanner {
 public:
  Scanner(std::string_view text, CodeKind kind) : text_(text), kind_(kind) {}

  CodeText scan() {
    while (skip()) token();
    if (in_directive_) add(CodeTokenKind::end_of_directive, 0);
    add(CodeTokenKind::end, 0);
    return std::move(code_);
  }

 private:
  [[nodiscard]] char peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  [[nodiscard]] bool stands(std::string_view word) const {
    return text_.substr(at_, word.size()) == word;
  }

  void add(CodeTokenKind kind, std::size_t length) {
    code_.tokens.push_back({kind, text_.substr(at_, length), static_cast<std::uint32_t>(at_),
                            static_cast<std::uint32_t>(code_.comments.size())});
    at_ += length;
  }

  /// Passes blanks and comments; whether a token follows.
  bool skip() {
    while (at_ < text_.size()) {
      if (stands("\\\n")) {
        at_ += 2;
      } else if (peek() == '\n' && in_directive_) {
        in_directive_ = false;
        add(CodeTokenKind::end_of_directive, 0);
      } else if (is_space(peek())) {
        starts_line_ = starts_line_ || peek() == '\n';
        ++at_;
      } else if (!comment()) {
        return true;
      }
    }
    return false;
  }

  bool comment() {
    std::size_t end = at_;
    if (stands("//")) {
      end = std::min(text_.find('\n', at_), text_.size());
      while (end < text_.size() && text_[end - 1] == '\\') {
        end = std::min(text_.find('\n', end + 1), text_.size());
      }
    } else if (stands("/*")) {
      const std::size_t closed = text_.find("*/", at_ + 2);
      if (closed == std::string_view::npos) return false;
      end = closed + 2;
    }
    if (end == at_) return false;
    code_.comments.push_back(text_.substr(at_, end - at_));
    at_ = end;
    return true;
  }

  void token() {
    in_directive_ = in_directive_ || (starts_line_ && peek() == '#');
    starts_line_ = false;
    if (kind_ == CodeKind::picture && stands("{{")) {
      const std::size_t closed = std::min(text_.find("}}", at_), text_.size() - 2);
      return add(CodeTokenKind::hole, closed + 2 - at_);
    }
    if (is_word_character(peek()) && !is_digit(peek()))
      return add(CodeTokenKind::name, name_length());
    if (is_digit(peek()) || (peek() == '.' && is_digit(peek(1)))) {
      return add(CodeTokenKind::number, number_length());
    }
    if (peek() == '"') return string();
    sign();
  }

  [[nodiscard]] std::size_t name_length() const {
    std::size_t length = 1;
    while (is_word_character(peek(length))) ++length;
    return length;
  }

  /// What the preprocessor takes for one number: also `1.2.3` and `0x1p-3f`.
  [[nodiscard]] std::size_t number_length() const {
    constexpr std::string_view exponents = "eEpP";
    std::size_t length = 1;
    for (;; ++length) {
      const char c = peek(length);
      const bool is_sign =
          (c == '+' || c == '-') && exponents.find(peek(length - 1)) != std::string_view::npos;
      if (!is_word_character(c) && c != '.' && !is_sign) return length;
    }
  }

  void string() {
    std::size_t length = 1;
    while (peek(length) != '"' && peek(length) != '\n' && peek(length) != '\0') {
      length += peek(length) == '\\' ? 2 : 1;
    }
    const bool is_closed = peek(length) == '"';
    add(is_closed ? CodeTokenKind::string : CodeTokenKind::invalid, is_closed ? length + 1 : 1);
  }

  void sign() {
    for (const std::string_view sign : long_signs) {
      if (stands(sign)) return add(CodeTokenKind::sign, sign.size());
    }
    const bool is_known = short_signs.find(peek()) != std::string_view::npos;
    add(is_known ? CodeTokenKind::sign : CodeTokenKind::invalid, 1);
  }

  std::string_view text_;
  CodeKind kind_;
  std::size_t at_ = 0;
  bool starts_line_ = true;
  bool in_directive_ = false;
  CodeText code_;
};

}  // namespace

CodeText code_tokens(std::string_view text, CodeKind kind) { return Scanner(text, kind).scan(); }

}  // namespace elgen
