// Mutations: what slips, editors and other programs do to a text file.
#pragma once

#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace elgen::fuzz {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}

  /// 0 … count - 1; count is positive.
  std::size_t below(std::size_t count) { return engine_() % count; }
  template <class Items>
  const auto& one_of(const Items& items) {
    return items[below(items.size())];
  }

 private:
  std::mt19937_64 engine_;
};

/// A piece of text: a name, a number, blanks, or one other character.
struct Token {
  std::size_t begin = 0;
  std::size_t size = 0;
  enum class Kind { name, number, blank, other } kind = Kind::other;
  bool is_quoted = false;  ///< stands between double quotes of one line, as expressions do
};

[[nodiscard]] std::vector<Token> tokens_of(const std::string& text);

/// One to four of: a byte changed, put in or taken out; a token replaced by another of the text, or
/// by one of the language; a number replaced by an extreme one; lines taken out, repeated or
/// exchanged; the text cut off. The same draws give the same text in every build.
[[nodiscard]] std::string mutated(std::string text, Draw& draw);

}  // namespace elgen::fuzz
