// Mutations of text files, as made by typing errors, editors and other programs.
#pragma once

#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace elgen::test {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}

  /// A random number from 0 to count - 1; `count` is positive.
  std::size_t number_below(std::size_t count) { return engine_() % count; }
  template <class Items>
  const auto& one_of(const Items& items) {
    return items[number_below(items.size())];
  }

 private:
  std::mt19937_64 engine_;
};

/// A token of text: a name, a number, one blank, or one other character.
struct Token {
  std::size_t begin = 0;
  std::size_t size = 0;
  enum class Kind { name, number, blank, other } kind = Kind::other;
  bool is_quoted = false;  ///< inside double quotes on one line, as expressions are
};

[[nodiscard]] std::vector<Token> tokens_of(const std::string& text);

/// `text` after one to four random edits. An edit changes or inserts a byte, removes up to eight
/// bytes, or inserts a word; replaces a token by another token of the text or by a word, a number
/// by an extreme or a small number, or a sign by a sign; removes, repeats or exchanges lines; or
/// truncates the text. The same draws give the same text in every build.
[[nodiscard]] std::string mutate(std::string text, Draw& draw);

}  // namespace elgen::test
