// Report: collects the diagnostics of one run, each once.
#pragma once

#include <set>
#include <string>
#include <tuple>

#include "elgen/diagnostic.hpp"
#include "elgen/wording.hpp"

namespace elgen {

class Report {
 public:
  /// Repetition meets one mistake many times; messages at one place that differ in their numbers
  /// only are kept once.
  void add(Diagnostic diagnostic);
  void add(Code code, const Span& span, std::string message, std::string hint = {});

  [[nodiscard]] std::size_t errors() const { return errors_; }
  [[nodiscard]] bool has(Code code) const;
  /// Suggestions cost a search each; nobody reads the hundredth.
  [[nodiscard]] bool wants_suggestion() const { return errors_ < 100; }
  /// Everything so far, in order of position.
  [[nodiscard]] Diagnostics sorted() const;

 private:
  using Key = std::tuple<const SourceText*, std::uint32_t, std::uint32_t, Code, std::string>;
  Diagnostics diagnostics_;
  std::set<Key> seen_;
  std::size_t errors_ = 0;
};

}  // namespace elgen
