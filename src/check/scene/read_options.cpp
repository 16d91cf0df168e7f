// read_options: the keys of `NAME = { … }` in `[outputs]`; each output takes some of them.
#include <fmt/format.h>

#include <algorithm>

#include "base/report.hpp"
#include "check/scene/scene.hpp"

namespace elgen {
namespace {

/// Reports E103 for each key that the output does not take. The message names the first kind of
/// output that takes the key.
void report_unsupported_options(const ValueSyntax& entry, const OutputRequest& output,
                                Report& report) {
  for (const OptionRow& row : option_table) {
    const KeySyntax* const key = entry.find(row.key);
    if (key == nullptr || output_row(output.kind).options.has(row.id)) continue;
    const auto takes = [&row](const OutputRow& other) { return other.options.has(row.id); };
    report.add(Code::E103, key->key_span,
               fmt::format("`{}` has no `{}`: `{}` has {}", output.name, row.key,
                           std::ranges::find_if(output_table(), takes)->name, row.pronoun));
  }
}

}  // namespace

void read_options(const Model& model, const ValueSyntax& entry, OutputRequest& output,
                  Report& report) {
  report_unsupported_options(entry, output, report);
  const EnumSet<OutputOption>& supported = output_row(output.kind).options;
  if (supported.has(OutputOption::method)) read_step(model, entry, output, report);
  const KeySyntax* const pivots = entry.find("pivots");
  if (pivots != nullptr) output.omits_pivots = !pivots->value.boolean;
}

}  // namespace elgen
