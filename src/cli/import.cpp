// elgen import: writes a robot description as a model file, to stdout or to the file of -o.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "base/json.hpp"
#include "base/reason.hpp"
#include "cli/commands.hpp"
#include "cli/files/inputs.hpp"
#include "elgen/diagnostic.hpp"
#include "elgen/urdf.hpp"
#include "elgen/wording.hpp"
#include "emit/cpp/cpp_names.hpp"

namespace elgen::cli {
namespace {

struct ImportCommandOptions {
  std::string input = {};
  std::string checked_file = {};  ///< the file that --check compares with the import
  FileOption output = {};         ///< empty: stdout
  ImportOptions model = {};
};

using NoteKind = std::pair<Code, std::string>;

/// The kind of a note, for merging. Notes E815 of one kind have the same message; notes E820 of one
/// kind have the same hint, which says why and where a joint is held.
NoteKind kind_of(const Diagnostic& note) {
  if (note.code == Code::E820) return {note.code, note.hint};
  return {note.code, note.code == Code::E815 ? note.message : std::string()};
}

Diagnostic summary_of(const Diagnostic& first, std::size_t count) {
  const std::size_t line = line_column(*first.span.source, first.span.begin).line;
  const std::string times =
      first.code == Code::E815 ? fmt::format("{} times", count)
                               : fmt::format("and the same for {}", count_text(count - 1, "other"));
  return {first.code, {}, fmt::format("{}, {}, from line {} on", first.message, times, line)};
}

bool is_located_note(const Diagnostic& diagnostic) {
  return code_row(diagnostic.code).severity == Severity::note && diagnostic.span.source != nullptr;
}

/// Merges all notes of one kind into one note without a place. Keeps errors, warnings, and notes
/// that are the only ones of their kind.
Diagnostics merge_by_kind(const Diagnostics& diagnostics) {
  std::map<NoteKind, std::size_t> counts;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (is_located_note(diagnostic)) ++counts[kind_of(diagnostic)];
  }
  Diagnostics kept;
  std::set<NoteKind> said;
  for (const Diagnostic& diagnostic : diagnostics) {
    const std::size_t count = is_located_note(diagnostic) ? counts[kind_of(diagnostic)] : 1;
    if (count == 1) {
      kept.push_back(diagnostic);
    } else if (said.insert(kind_of(diagnostic)).second) {
      kept.push_back(summary_of(diagnostic, count));
    }
  }
  return kept;
}

/// Prints each note if --verbose or a format for programs is set, otherwise one line per kind.
ExitCode report_import(GlobalOptions global, const Diagnostics& diagnostics) {
  if (global.verbose) global.style.maximum = diagnostics.size();
  const bool is_whole = global.verbose || global.style.format != DiagnosticFormat::text;
  const Diagnostics said = is_whole ? diagnostics : merge_by_kind(diagnostics);
  const ExitCode code = report(global, said);
  if (said.size() < diagnostics.size())
    print_message(global, "-v prints every note with its place");
  return code;
}

/// The file's name without its ending: "ur5_gripper" of "models/ur5_gripper.toml".
std::string model_name(const std::string& output) {
  return std::filesystem::path(output).stem().string();
}

/// JSON with the path of the file, and whether the file was written.
std::string written_json(const std::string& path, bool is_new) {
  const Json file{{"path", path}, {"written", is_new}};
  return Json{{"files", Json::array({file})}}.dump(2) + "\n";
}

/// The text between `before` and `behind`; "" if `before` is missing.
std::string text_between(const std::string& text, std::string_view before,
                         std::string_view behind) {
  const std::size_t found = text.find(before);
  if (found == std::string::npos) return {};
  const std::size_t begin = found + before.size();
  return text.substr(begin, text.find(behind, begin) - begin);
}

/// The text imported from `source`, with the model name and the file name that the text `stated`
/// contains, because files may have been renamed. "" if the import fails.
std::string import_with_stated_names(const std::string& stated, const SourcePointer& source,
                                     const Limits& limits, ImportOptions options) {
  options.name = text_between(stated, "[model]\nname        = \"", "\"");
  options.file = text_between(stated, "\"Imported from ", "; coordinates are those of its joints");
  const Result<ImportedModel> model = import_urdf(source, limits, options);
  return model ? model->text : "";
}

/// E715 if the checked file differs from the import in more than the names of model and file.
ExitCode check_file(const GlobalOptions& global, const ImportCommandOptions& options,
                    const SourcePointer& source, const std::string& text) {
  const Result<SourcePointer> file = read_source(options.checked_file, global.limits);
  if (!file) return report(global, file.diagnostics);
  const std::string path = printable_path(options.checked_file);
  const std::string& checked = (*file)->text;
  if (checked == text ||
      checked == import_with_stated_names(checked, source, global.limits, options.model)) {
    print_message(global, path + " is current");
    return ExitCode::success;
  }
  return report(
      global,
      {{Code::E715,
        {},
        fmt::format("`{}` differs from the import of `{}`", path, printable_path(options.input)),
        "import it with `-o OTHER.toml`; `elgen diff` then shows the changes"}});
}

ExitCode import_file(const GlobalOptions& global, const ImportCommandOptions& options) {
  const bool is_check = !options.checked_file.empty();
  if (options.output.file.empty() && !is_check && wants_json(global)) {
    return report(global,
                  {{Reason::not_as_json, {}, "a model is not printed as json", "give `-o FILE`"}});
  }
  const Result<SourcePointer> source = read_source(options.input, global.limits);
  if (!source) return report(global, source.diagnostics);
  ImportOptions wanted = options.model;
  wanted.name = model_name(is_check ? options.checked_file : options.output.file);
  const Result<ImportedModel> model = import_urdf(*source, global.limits, wanted);
  if (model && is_reserved_by_system(model->name)) {
    return report(global,
                  {{Code::E701,
                    {},
                    fmt::format("`{}` cannot name a model: C or POSIX declares it", model->name),
                    "choose another name with `-o NAME.toml`"}});
  }
  const ExitCode imported = report_import(global, model.diagnostics);
  if (!model) return imported;
  if (is_check) return std::max(imported, check_file(global, options, *source, model->text));
  if (options.output.file.empty()) return std::max(imported, print(global, model->text));
  const auto written = write_output(global, options.output, model->text);
  if (!written) return report(global, written.diagnostics);
  print_message(global, "wrote " + printable_path(options.output.file));
  if (!wants_json(global)) return imported;
  return std::max(imported, print(global, written_json(options.output.file, !written->empty())));
}

}  // namespace

void add_import(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("import", "print a robot description as a model file");
  const auto options = std::make_shared<ImportCommandOptions>();
  command->add_option("input", options->input, "NAME.urdf or - (stdin)")->required();
  add_file_options(*command, options->output, "write the model to FILE and name it after FILE");
  command
      ->add_option("--check", options->checked_file,
                   "exit with 1 if this model differs from the imported model")
      ->type_name("MODEL")
      ->excludes("-o");
  ImportOptions& model = options->model;
  command->add_flag("--floating-base", model.floating_base, "let the root link move freely");
  add_source_option(
      *command, "--joints", "A,B", model.joints,
      "movable joints in this order; all other joints are held at 0 or the nearest limit");
  add_source_option(
      *command, "--weld", "JOINT[=VALUE]", model.welds,
      "hold a joint at 0, or at VALUE in rad or m; massless: all joints that move no mass");
  command->add_flag("--exact-angles", model.exact_angles,
                    "do not replace rounded angles such as 1.5708 by right angles");
  set_action(*command, action, options, &import_file);
}

}  // namespace elgen::cli
