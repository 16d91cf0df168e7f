// A sentence per dimension: how much it matters where everything else stays as it is.
#pragma once

#include "elgen/tradeoff.hpp"

namespace elgen {

/// "scalar: float is up to 2.0 times as fast as double; float has up to 4.1e+08 times the error of
/// double". Times whose quartiles overlap everywhere are "noise".
[[nodiscard]] std::vector<std::string> sentences_of(const TradeoffTable& table);

}  // namespace elgen
