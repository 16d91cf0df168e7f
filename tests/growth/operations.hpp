// Operations of this program, counted and not timed: the same in every run.
//
// Bytes asked for are counted always. A stage makes everything (nodes, terms, numbers, texts,
// tables) in memory, also what it throws away again, so work that no product shows is counted.
// Blocks (of instructions without a branch) also count what only looks, a search in a list: there
// they are counted where the preset `counted` compiled them, and 0 elsewhere.
#pragma once

#include <cstdint>

namespace elgen::test {

#ifdef ELGEN_COUNTED
inline constexpr bool counts_blocks = true;
#else
inline constexpr bool counts_blocks = false;
#endif

struct Operations {
  std::uint64_t bytes = 0;   ///< asked for, of CLN's numbers too
  std::uint64_t blocks = 0;  ///< executed, of libraries only what headers bring
};

/// Since the program began.
[[nodiscard]] Operations operations();

}  // namespace elgen::test
