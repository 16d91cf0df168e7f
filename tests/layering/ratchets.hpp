// Ratchets: figures of src and include that may only shrink, each with a row in
// tests/layering/ratchets.txt. The rules read lines and indents as clang-format writes them.
#pragma once

#include <string>
#include <vector>

#include "layering/layering.hpp"

namespace elgen::test {

/// `text`: ratchets.txt. One sentence for each figure above its row, then the places that it
/// counts; one for each figure below its row or without one, and for each row without a figure.
/// Places that begin with a path of `besides` are not counted.
[[nodiscard]] std::vector<std::string> broken_ratchets(const SourceTree& tree,
                                                       const std::string& text);

}  // namespace elgen::test
