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
  /// Drops a diagnostic if an earlier one has the same span, code and message up to digits, because
  /// a repetition finds the same mistake for every index.
  void add(Diagnostic diagnostic);
  void add(Code code, const Span& span, std::string message, std::string hint = {});

  [[nodiscard]] std::size_t errors() const { return errors_; }
  [[nodiscard]] bool has(Code code) const;
  /// False from 100 errors on: a suggestion costs a search, and nobody reads the hundredth.
  [[nodiscard]] bool needs_suggestion() const { return errors_ < 100; }
  /// All diagnostics in order of position.
  [[nodiscard]] Diagnostics sorted() const;

 private:
  using Key = std::tuple<const SourceText*, std::uint32_t, std::uint32_t, Code, std::string>;
  Diagnostics diagnostics_;
  std::set<Key> seen_;
  std::size_t errors_ = 0;
};

}  // namespace elgen
