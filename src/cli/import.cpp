// elgen import: a robot description as a model file, on stdout or where -o says.
#include <fmt/format.h>

#include <filesystem>

#include "elgen/urdf.hpp"
#include "inputs.hpp"
#include "options.hpp"
#include "output_files.hpp"

namespace elgen::cli {

namespace {

namespace fs = std::filesystem;

/// An imported model is edited by its owner, so no mark in it makes it ours again.
Diagnostics write_model(const ImportOptions& options, const std::string& text) {
  const fs::path path = options.output;
  std::error_code error;
  if (!options.force && fs::exists(path, error)) {
    return {{Code::E703, {}, fmt::format("`{}` exists", path.string()), "--force overwrites it"}};
  }
  const bool force = true;
  return write_files(path.parent_path().string(), {{{path.filename().string(), text}}}, force);
}

}  // namespace

ExitCode import_file(const GlobalOptions& global, const ImportOptions& options) {
  const Result<SourcePointer> source = read_source(options.input, global.limits);
  if (!source) return report(global, source.diagnostics);
  const Result<ImportedModel> model = import_urdf(*source, global.limits);
  const ExitCode imported = report(global, model.diagnostics);
  if (!model) return imported;
  if (options.output.empty()) {
    fmt::print("{}", model->text);
    return imported;
  }
  const Diagnostics errors = write_model(options, model->text);
  if (!errors.empty()) return report(global, errors);
  tell(global, "wrote " + options.output);
  return imported;
}

}  // namespace elgen::cli
