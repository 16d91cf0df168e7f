// sections: a long body -> parts of bounded length, for compilers whose time grows faster
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

#include "emit/code/statements.hpp"

namespace elgen {

struct Sections {
  std::vector<std::vector<Statement>> parts = {};  ///< at least one
  std::vector<bool> crosses = {};  ///< of each instruction: used in another part than its own
};

/// Bodies of up to so many statements compile in a second as they are.
inline constexpr std::size_t longest_body = 1000;
inline constexpr std::size_t section_length = 400;

[[nodiscard]] Sections sections(const std::vector<Statement>& statements,
                                std::size_t length_of_part);

}  // namespace elgen
