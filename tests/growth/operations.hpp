// Counts the operations of this program instead of timing them: the counts are the same in every
// run.
//
// Allocated bytes are always counted. A stage builds everything (nodes, terms, numbers, texts,
// tables) in memory, including temporary results. So bytes count work that leaves no trace in the
// product. Blocks (instructions without a branch) also count work that only reads memory, such as a
// search in a list. The number of blocks is 0 unless the preset `counted` compiled the code.
#pragma once

#include <cstdint>

namespace elgen::test {

#ifdef ELGEN_COUNTED
inline constexpr bool counts_blocks = true;
#else
inline constexpr bool counts_blocks = false;
#endif

struct Operations {
  std::uint64_t bytes = 0;   ///< allocated, including CLN's numbers
  std::uint64_t blocks = 0;  ///< executed; of libraries, only code in their headers
};

/// Counts since the start of the program.
[[nodiscard]] Operations operations();

}  // namespace elgen::test
