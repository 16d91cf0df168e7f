// Repetitions: `for = "i in 1..n"`, or a list of such.
#pragma once

#include "parse/value_reader.hpp"

namespace elgen {

/// A list of tables {index, low, high}, one per repetition, also where the file has a single
/// string. E104; E210 malformed repetition; errors of the bounds.
[[nodiscard]] ValueSyntax read_repetition(const TomlValue& value, FileReading& reading);

}  // namespace elgen
