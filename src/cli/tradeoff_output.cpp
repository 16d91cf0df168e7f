// The scene of a row is written beside the table, both or none.
#include "cli/tradeoff_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/design_base.hpp"
#include "cli/files/data_formats.hpp"
#include "cli/files/inputs.hpp"
#include "cli/files/output_files.hpp"

namespace elgen::cli {

namespace {

/// From the folder of the scene.
std::string model_path(const Inputs& inputs, const std::string& scene_file) {
  namespace fs = std::filesystem;
  const auto from_root = [](const fs::path& path) { return fs::absolute(path).lexically_normal(); };
  return from_root(inputs.model->path)
      .lexically_proximate(from_root(scene_file).parent_path())
      .generic_string();
}

Diagnostics none_within(const TradeoffTable& table, double max_error) {
  const TradeoffRow* const nearest = most_accurate(table);
  return {{Code::E632,
           {},
           fmt::format("no design is within {}", max_error),
           nearest == nullptr ? ""
                              : fmt::format("`{}` is nearest, its worst error is {:.1e}",
                                            name_of(*nearest), nearest->error.worst)}};
}

/// The row that --max-error asks for; its scene joins `files`.
ExitCode choose_row(const GlobalOptions& global, const TradeoffOutput& output, const Inputs& inputs,
                    const TradeoffTable& table, std::vector<OutputFile>& files) {
  const TradeoffRow* const row = cheapest_within(table, *output.max_error);
  if (row == nullptr) return report(global, none_within(table, *output.max_error));
  tell(global, fmt::format("cheapest within {}: {}, {:.4g} ns, error {:.1e}", *output.max_error,
                           name_of(*row), row->cost.median, row->error.worst));
  if (output.scene_file.empty()) return ExitCode::success;
  std::vector<SourcePointer> sources;
  const Result<OutputBase> base = output_base(inputs, table.subject, global.limits, sources);
  if (!base) return report(global, base.diagnostics);
  const std::string path = model_path(inputs, output.scene_file);
  files.push_back({output.scene_file, scene_text(base->base(), design_of(table, *row), path),
                   Replaces::nothing});
  return ExitCode::success;
}

}  // namespace

Diagnostics refuse_output(const TradeoffOutput& output) {
  if (!output.file.empty()) {
    const auto format = format_of<TradeoffTable>(output.file);
    if (!format) return format.diagnostics;
  }
  std::vector<OutputFile> files;
  for (const std::string& path : {output.file, output.scene_file}) {
    if (!path.empty()) files.push_back({path, "", Replaces::nothing});
  }
  return refuse_places(files, output.force);
}

ExitCode deliver(const GlobalOptions& global, const TradeoffOutput& output, const Inputs& inputs,
                 const TradeoffTable& table) {
  const std::string as = output.as.empty() && wants_json(global) ? "json" : output.as;
  const auto printed = format_of<TradeoffTable>("." + as);
  ExitCode worst = print(global, printed ? printed->text(table) : to_text(table));
  std::vector<OutputFile> files;
  if (!output.file.empty()) {
    const auto format = format_of<TradeoffTable>(output.file);
    files.push_back({output.file, format->text(table), Replaces::nothing});
  }
  if (output.max_error) {
    worst = std::max(worst, choose_row(global, output, inputs, table, files));
  }
  const auto written = write_files(files, {output.force, global.limits.seconds});
  return std::max(worst, report(global, written.diagnostics));
}

}  // namespace elgen::cli
