// sections: a long FunctionBody -> parts of bounded length, for compilers whose time grows faster
// than the length of a function.
//
//     a = …; b = f(a); c = g(b)        part 1: a = …; b = f(a)
//     result 2 1 = b c          ->     part 2: result[0] = b; c = g(b); result[1] = c     b crosses
//
// An entry is written as soon as all that it uses is there, so that few values cross into later
// parts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "statements.hpp"

namespace elgen {

/// A statement, or an entry of a field.
struct SectionItem {
  bool is_entry = false;
  std::uint32_t field = 0;
  std::uint32_t index = 0;  ///< of the statement, or of the entry in its field
};

struct Sections {
  std::vector<std::vector<SectionItem>> parts = {};  ///< at least one
  std::vector<bool> crosses = {};  ///< of each statement: used in another part than its own
};

/// Bodies of up to so many statements and entries compile in a second as they are.
inline constexpr std::size_t longest_body = 1000;
inline constexpr std::size_t section_length = 400;

[[nodiscard]] std::size_t length(const FunctionBody& body);

[[nodiscard]] Sections sections(const FunctionBody& body, std::size_t length_of_part);

/// The value of an item.
[[nodiscard]] const Term& value_of(const FunctionBody& body, const SectionItem& item);

}  // namespace elgen
