// enclosure_of: the form of a constant -> its value, with a bound of the error.
#pragma once

#include <optional>

#include "base/enclosed_number.hpp"
#include "elgen/constant.hpp"

namespace elgen {

/// A float of at least 220 digits unless exact, its error at most 1e-200 |value|, or 1e-200 where
/// 1760 digits cancelled. None where the form has no real value, or where 1760 digits do not tell
/// whether it has one.
[[nodiscard]] std::optional<EnclosedNumber> enclosure_of(const ConstantForm& form);

}  // namespace elgen
