// Report: collects the diagnostics of one run without duplicates.
#pragma once

#include <set>
#include <string>
#include <tuple>

#include "elgen/diagnostic.hpp"
#include "elgen/wording.hpp"

namespace elgen {

class Report {
 public:
  /// Adds a diagnostic unless an earlier diagnostic has the same span, the same code, and the same
  /// message except for digits. In a repetition, each index would report the same mistake.
  void add(Diagnostic diagnostic);
  void add(Code code, const Span& span, std::string message, std::string hint = {});

  [[nodiscard]] std::size_t error_count() const { return errors_; }
  [[nodiscard]] bool has(Code code) const;
  /// False after 100 errors: a suggestion costs a search, and nobody reads so many suggestions.
  [[nodiscard]] bool needs_suggestion() const { return errors_ < 100; }
  /// All diagnostics, sorted by position.
  [[nodiscard]] Diagnostics sorted_diagnostics() const;

 private:
  using Key = std::tuple<const SourceText*, std::uint32_t, std::uint32_t, Code, std::string>;
  Diagnostics diagnostics_;
  std::set<Key> seen_;
  std::size_t errors_ = 0;
};

}  // namespace elgen
