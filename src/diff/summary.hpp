// summary: a report in lines with labels, whatever they are printed as.
#pragma once

#include <string>
#include <vector>

#include "elgen/diff.hpp"

namespace elgen {

struct SummaryLine {
  std::string label = {};  ///< "changed"; "" where it goes on
  std::string text = {};
};
using SummaryLines = std::vector<SummaryLine>;

/// Causes first, then what follows, one entry in full, what callers see, and the verdict; where
/// callers break, what they see stands before the causes. At most about a dozen unless `lists_all`.
[[nodiscard]] SummaryLines summary(const DiffReport& report, bool lists_all);

/// Labels in a column of their own.
[[nodiscard]] std::string text_of(const SummaryLines& lines);

/// The entries of one system that are not identical.
struct EntryList {
  std::string system = {};
  std::vector<std::string> lines = {};
};

[[nodiscard]] std::vector<EntryList> entry_lists(const DiffReport& report);

}  // namespace elgen
