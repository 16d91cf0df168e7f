// Ratchets: figures of src and include that may only shrink, each with a row in
// tests/layering/ratchets.txt. The rules read lines and indents as clang-format formats them.
#pragma once

#include <string>
#include <vector>

#include "layering/layering.hpp"

namespace elgen::test {

/// `text` is the content of ratchets.txt. Returns a sentence for each figure above its row,
/// followed by its places. Figures below their row or without a row, and rows without a figure, get
/// a sentence too. Places that begin with a path of `besides` do not count.
[[nodiscard]] std::vector<std::string> broken_ratchets(const SourceTree& tree,
                                                       const std::string& text);

}  // namespace elgen::test
