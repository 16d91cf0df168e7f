// Limits: upper bounds on the size of a problem. `--limit NAME=VALUE` changes a limit; `--limits`
// lists all limits.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace elgen {

/// Interval operations that a search may do per second of the time limit. The number is a quarter
/// of the measured rate (4e8 in 15 s), to allow for slower machines and for other stages.
inline constexpr std::uint64_t enclosures_per_second = 7'000'000;

struct Limits {
  std::uint64_t file_bytes = 1U << 20U;
  std::uint64_t expression_depth = 200;
  std::uint64_t literal_digits = 400;
  std::uint64_t decimal_exponent = 400;
  std::uint64_t integer_power = 64;
  std::uint64_t coordinates = 1024;
  /// Number of entries except coordinates, after repetitions are expanded; also the number of
  /// elements of one array.
  std::uint64_t definitions = 20'000;
  std::uint64_t derived_nodes = 2'000'000;
  std::uint64_t seconds = 60;  ///< processor time of one command on one model
  std::uint64_t boxes = 200'000;
  /// Interval operations in the search for equilibria; not a time, so that results do not depend on
  /// the machine.
  std::uint64_t enclosures = enclosures_per_second * seconds;
  std::uint64_t memory_mib = 1024;
  std::uint64_t page_bytes = 1U << 20U;  ///< size of a page with an animation
};

struct LimitRow {
  std::string_view name;
  std::uint64_t Limits::*member;
  std::string_view unit;
  std::string_view doc;
};

[[nodiscard]] const std::vector<LimitRow>& limit_table();

}  // namespace elgen
