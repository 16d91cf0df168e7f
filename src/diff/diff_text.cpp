// diff_text: the summary, and what --list adds.
#include "diff/summary.hpp"

namespace elgen {

std::string to_text(const DiffReport& report, bool lists_all) {
  std::string text = text_of(summary(report, lists_all));
  if (!lists_all) return text;
  for (const auto& [system, entries] : entry_lists(report)) {
    SummaryLines lines;
    for (const std::string& entry : entries) lines.push_back({"", entry});
    text += "\n" + system + "\n" + text_of(lines);
  }
  return text;
}

}  // namespace elgen
