// Ratchets: figures of src and include that may only shrink, each with a row in
// tests/layering/ratchets.txt. The rules read lines and indents as clang-format formats them.
#pragma once

#include <string>
#include <vector>

#include "layering/layering.hpp"

namespace elgen::test {

/// A sentence for each figure that differs from its row in `text`, the content of ratchets.txt, for
/// each figure without a row, and for each row without a figure. The places of a figure that
/// exceeds its row follow. Places that begin with a path behind `besides` in the row do not count.
[[nodiscard]] std::vector<std::string> broken_ratchets(const SourceTree& tree,
                                                       const std::string& text);

}  // namespace elgen::test
