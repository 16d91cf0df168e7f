// elgen import: a robot description as a model file, on stdout or where -o says.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/files/inputs.hpp"
#include "cli/files/output_files.hpp"
#include "elgen/urdf.hpp"

namespace elgen::cli {

namespace {

struct ImportOptions {
  std::string input = {};
  std::string output = {};  ///< empty: stdout
  bool force = false;
};

/// What became of the file.
std::string written_json(const std::string& path, bool is_new) {
  using Json = nlohmann::ordered_json;
  const Json file{{"path", path}, {"written", is_new}};
  return Json{{"files", Json::array({file})}}.dump(2) + "\n";
}

ExitCode import_file(const GlobalOptions& global, const ImportOptions& options) {
  if (options.output.empty() && wants_json(global)) {
    return report(global, {{Code::E913, {}, "a model is not printed as json", "give `-o FILE`"}});
  }
  const Result<SourcePointer> source = read_source(options.input, global.limits);
  if (!source) return report(global, source.diagnostics);
  const Result<ImportedModel> model = import_urdf(*source, global.limits);
  const ExitCode imported = report(global, model.diagnostics);
  if (!model) return imported;
  if (options.output.empty()) return std::max(imported, print(global, model->text));
  // An imported model is edited by its owner, so no mark in it makes it ours again.
  const auto written = write_files({{options.output, model->text, Replaces::nothing}},
                                   {options.force, global.limits.seconds});
  if (!written) return report(global, written.diagnostics);
  tell(global, "wrote " + options.output);
  if (!wants_json(global)) return imported;
  return std::max(imported, print(global, written_json(options.output, !written->empty())));
}

}  // namespace

void add_import(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("import", "print a robot description as a model file");
  const auto options = std::make_shared<ImportOptions>();
  command->add_option("input", options->input, "NAME.urdf or - (stdin)")->required();
  command->add_option("-o,--output", options->output, "write the model here instead")
      ->type_name("FILE");
  command->add_flag("--force", options->force, "overwrite FILE");
  set_action(*command, action, options, &import_file);
}

}  // namespace elgen::cli
