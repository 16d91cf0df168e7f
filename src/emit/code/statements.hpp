// statements: what the body of a Function computes, in order: what has a name, then the entries of
// its fields. Everything else is written out where it is used.
//
//     2 = add 0 1  ; total        total = a + b
//     3 = multiply 2 2
//     result 2 1 = 3 2            total * total, total
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elgen/program.hpp"

namespace elgen {

/// A named value, the sine and cosine of an angle, or an entry of a field.
struct Statement {
  std::uint32_t instruction = 0;
  std::vector<std::uint32_t> uses = {};     ///< named instructions, ascending, each once
  std::vector<std::uint32_t> written = {};  ///< instructions written out
  bool is_entry = false;
  std::uint32_t field = 0;                   ///< of an entry
  std::uint32_t index = 0;                   ///< of an entry in its field
  std::optional<std::uint32_t> cosine = {};  ///< computed at once with `instruction`, the sine
};

/// Whether one statement computes the sine and the cosine of an angle, where both are needed.
enum class Pairing : std::uint8_t { joint, separate };

/// `names`: of each instruction, empty where it is written out.
[[nodiscard]] std::vector<Statement> statements(const Function& function,
                                                const std::vector<std::string>& names,
                                                Pairing pairing);

}  // namespace elgen
