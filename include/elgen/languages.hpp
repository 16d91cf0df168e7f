// The table of target languages (languages.def), as an enumeration with its properties.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace elgen {

enum class LanguageId : std::uint8_t {
#define ELGEN_LANGUAGE(id, ...) id,
#include "elgen/languages.def"
#undef ELGEN_LANGUAGE
};

/// Whether emitted functions are generic in their scalar, or written for one.
enum class LanguageScalars : std::uint8_t { any, one };

struct LanguageRow {
  LanguageId id;
  std::string_view name;
  LanguageScalars scalars;
  std::string_view ending;  ///< "cpp": of a source in it
  bool has_more_headers;    ///< on Eigen's types, and in batches
};

inline constexpr std::array language_table{
#define ELGEN_LANGUAGE(id, name, scalars, ...) \
  LanguageRow{LanguageId::id, name, LanguageScalars::scalars, __VA_ARGS__},
#include "elgen/languages.def"
#undef ELGEN_LANGUAGE
};

[[nodiscard]] constexpr const LanguageRow& language_row(LanguageId id) {
  return language_table[static_cast<std::size_t>(id)];
}

inline constexpr LanguageId default_language = language_table.front().id;

}  // namespace elgen
