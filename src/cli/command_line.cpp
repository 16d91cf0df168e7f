// CLI11 reads the words; what it rejects becomes a diagnostic that points into the command line.
#include "cli/command_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdlib>

namespace elgen::cli {

namespace {

constexpr const char* examples =
    "Symbolic Euler-Lagrange equations: a model file in, closed forms and fast C++ out.\n\n"
    "  elgen generate models/cart_pole.toml            write generated/cart_pole/cart_pole.hpp\n"
    "  elgen show models/cart_pole.toml --what steps   the derivation, step by step\n"
    "  elgen verify models/cart_pole.toml              compare with 60-digit arithmetic\n";

/// Options whose values need more than CLI11's conversions.
struct RawOptions {
  std::string color = "auto";
  std::string format = "text";
  std::vector<std::string> limits = {};
  std::vector<std::string> outputs = {};
  std::vector<std::string> fixed = {};
  std::vector<std::string> sizes = {};
  bool list_limits = false;
};

void add_global_options(CLI::App& app, CommandLine& line, RawOptions& raw) {
  app.set_version_flag("--version", "elgen " ELGEN_VERSION);
  app.add_option("--color", raw.color, "auto, always or never (NO_COLOR is honoured)")
      ->check(CLI::IsMember({"auto", "always", "never"}));
  app.add_option("--format", raw.format, "of errors: text or json")
      ->check(CLI::IsMember({"text", "json"}));
  app.add_flag("-q,--quiet", line.global.quiet, "errors and warnings only");
  app.add_flag("-v,--verbose", line.global.verbose, "print the equations");
  app.add_option("--dump", line.global.dump_stage, "print what a stage made, on stdout")
      ->check(CLI::IsMember(stage_names()));
  app.add_option("--stop-after", line.global.stop_after,
                 "the last stage to run; nothing is written")
      ->check(CLI::IsMember(stage_names()));
  app.add_flag("--timings", line.global.timings, "time of every stage");
  app.add_flag("--limits", raw.list_limits, "list the limits and leave");
  app.add_option("--limit", raw.limits, "raise or lower a limit")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
}

void add_scene_options(CLI::App& command, RawOptions& raw) {
  command.add_option("--fix", raw.fixed, "make a parameter a number: NAME, NAME=VALUE or all")
      ->type_name("NAME[=VALUE]")
      ->allow_extra_args(false);
  command.add_option("--size", raw.sizes, "override a size of the model")
      ->type_name("NAME=N")
      ->allow_extra_args(false);
}

CLI::App* add_generate(CLI::App& app, CommandLine& line, RawOptions& raw) {
  CLI::App* command =
      app.add_subcommand("generate", "derive and write the code of models and scenes");
  GenerateOptions& options = line.generate;
  command->add_option("inputs", options.inputs, "NAME.toml, NAME.scene.toml or - (stdin)")
      ->required();
  command->add_option("-o,--output-directory", options.output_directory, "where to write")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_option("--outputs", raw.outputs, "only these: mass_matrix,bias,…")
      ->type_name("LIST")
      ->allow_extra_args(false);
  add_scene_options(*command, raw);
  CLI::Option* check =
      command->add_flag("--check", options.check, "write nothing; exit 1 if the files differ");
  command->add_flag("--force", options.force,
                    "overwrite regular files that elgen did not generate");
  CLI::Option* list =
      command->add_flag("--list-outputs", options.list_outputs, "print the paths it would write");
  CLI::Option* depfile = command
                             ->add_option("--depfile", options.depfile,
                                          "write the inputs of each file, for make and ninja")
                             ->type_name("FILE");
  CLI::Option* to_stdout =
      command->add_flag("--stdout", options.to_stdout, "print the header instead of writing files");
  check->excludes(list)->excludes(to_stdout)->excludes(depfile);
  list->excludes(to_stdout)->excludes(depfile);
  to_stdout->excludes(depfile);
  return command;
}

CLI::App* add_show(CLI::App& app, CommandLine& line, RawOptions& raw) {
  CLI::App* command = app.add_subcommand("show", "print the equations of a model or scene");
  ShowOptions& options = line.show;
  command->add_option("input", options.input, "NAME.toml, NAME.scene.toml or - (stdin)")
      ->required();
  command
      ->add_option("--what", options.what,
                   "outputs: mass_matrix,gravity,…; or lagrangian, steps, cost or dropped")
      ->type_name("LIST");
  command->add_option("--as", options.as, "text, latex, mathml, markdown or json")
      ->check(CLI::IsMember({"text", "latex", "mathml", "markdown", "json"}))
      ->capture_default_str();
  add_scene_options(*command, raw);
  return command;
}

CLI::App* add_verify(CLI::App& app, CommandLine& line) {
  CLI::App* command = app.add_subcommand("verify", "check models against 60-digit arithmetic");
  VerifyCommandOptions& options = line.verify;
  command->add_option("inputs", options.inputs, "NAME.toml, NAME.scene.toml or - (stdin)")
      ->required();
  command
      ->add_option("--samples", options.verify.samples,
                   "states per output (256, fewer for long programs)")
      ->check(CLI::PositiveNumber);
  command->add_flag("--quick", options.verify.quick,
                    "few states, projections instead of all entries, no compiler");
  command->add_flag("--strict", options.strict, "exit with 1 where a check is skipped");
  command->add_option("-o,--output", options.certificate_file, "write the certificates here too")
      ->type_name("FILE");
  command->add_flag("--force", options.force, "overwrite FILE");
  return command;
}

CLI::App* add_import(CLI::App& app, CommandLine& line) {
  CLI::App* command = app.add_subcommand("import", "print a robot description as a model file");
  ImportOptions& options = line.import_options;
  command->add_option("input", options.input, "NAME.urdf or - (stdin)")->required();
  command->add_option("-o,--output", options.output, "write the model here instead")
      ->type_name("FILE");
  command->add_flag("--force", options.force, "overwrite FILE");
  return command;
}

/// A source that shows the command line, with a span on `word`.
Diagnostic pointing_at(const std::vector<std::string>& words, const std::string& word,
                       std::string message, std::string hint) {
  std::string text = "elgen";
  Span span;
  for (std::size_t i = 1; i < words.size(); ++i) {
    text += " ";
    if (words[i] == word && span.end == 0) {
      span.begin = static_cast<std::uint32_t>(text.size());
      span.end = static_cast<std::uint32_t>(text.size() + word.size());
    }
    text += words[i];
  }
  // Kept for the rest of the process: diagnostics do not own their sources.
  static SourcePointer source;
  source = make_source("command line", text);
  span.source = source.get();
  return {Code::E913, span, std::move(message), std::move(hint)};
}

std::vector<std::string> known_words(const CLI::App& app) {
  std::vector<std::string> known;
  const auto add_options = [&](const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
      for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
    }
  };
  add_options(app);
  for (const CLI::App* command : app.get_subcommands({})) {
    known.push_back(command->get_name());
    if (command->parsed()) add_options(*command);
  }
  return known;
}

Diagnostic rejected(const CLI::App& app, const std::vector<std::string>& words,
                    const CLI::ParseError& error) {
  const std::vector<std::string> extras = app.remaining(true);
  if (!extras.empty()) {
    const std::string& word = extras.front();
    const std::string near = nearest(word.substr(0, word.find('=')), known_words(app));
    return pointing_at(words, word, fmt::format("`{}` is not understood", word),
                       near.empty() ? "" : fmt::format("did you mean `{}`?", near));
  }
  std::string message = error.what();
  if (!message.empty()) message[0] = static_cast<char>(std::tolower(message[0]));
  return {Code::E913, {}, message, "see `elgen --help`"};
}

Result<Limits> read_limits(const std::vector<std::string>& settings) {
  Limits limits;
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    const std::string name = setting.substr(0, equals);
    std::vector<std::string> names;
    const LimitRow* row = nullptr;
    for (const LimitRow& candidate : limit_table()) {
      names.emplace_back(candidate.name);
      if (candidate.name == name) row = &candidate;
    }
    if (row == nullptr) {
      const std::string near = nearest(name, names);
      return Diagnostic{
          Code::E913,
          {},
          fmt::format("`{}` is no limit", name),
          near.empty() ? "see `elgen --limits`" : fmt::format("did you mean `{}`?", near)};
    }
    const std::string value = equals == std::string::npos ? "" : setting.substr(equals + 1);
    const char* end = value.data() + value.size();
    const auto read = std::from_chars(value.data(), end, limits.*row->member);
    if (value.empty() || read.ec != std::errc() || read.ptr != end) {
      return Diagnostic{
          Code::E913, {}, fmt::format("`{}` is no limit: write NAME=NUMBER", setting)};
    }
  }
  return limits;
}

std::string limits_text() {
  std::string text;
  for (const LimitRow& row : limit_table()) {
    text +=
        fmt::format("{:<18} {:>10} {:<8} {}\n", row.name, Limits().*row.member, row.unit, row.doc);
  }
  return text;
}

std::vector<SourcePointer> sources(const std::vector<std::string>& values) {
  std::vector<SourcePointer> result;
  for (const std::string& value : values) result.push_back(make_source("command line", value));
  return result;
}

bool wants_color(const std::string& choice) {
  if (choice != "auto") return choice == "always";
  return std::getenv("NO_COLOR") == nullptr && ::isatty(STDERR_FILENO) != 0;
}

DiagnosticStyle style_of(const std::string& color, const std::string& format) {
  DiagnosticStyle style;
  style.color = wants_color(color);
  style.format = format == "json" ? DiagnosticFormat::json : DiagnosticFormat::text;
  return style;
}

/// The value of an option that stands before or after a mistake.
std::string value_of(const std::vector<std::string>& words, const std::string& option) {
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (words[i] == option && i + 1 < words.size()) return words[i + 1];
    if (words[i].rfind(option + "=", 0) == 0) return words[i].substr(option.size() + 1);
  }
  return {};
}

/// In quotes where a shell would not take it as one word.
std::string quoted(const std::string& word) {
  constexpr const char* harmless =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,/:@%";
  if (!word.empty() && word.find_first_not_of(harmless) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

/// The words without --check; what options would change has to be written somewhere they name.
std::string repair_command(const std::vector<std::string>& words, const GenerateOptions& options) {
  std::string command = "elgen";
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (words[i] != "--check") command += " " + quoted(words[i]);
  }
  const SceneOptions& scene = options.scene;
  const bool changes = !scene.outputs.empty() || !scene.fixed.empty() || !scene.sizes.empty();
  if (changes && !options.output_directory_given) {
    command += " -o " + quoted(options.output_directory);
  }
  return command;
}

/// What CLI11 could not convert by itself.
Diagnostics finish(const RawOptions& raw, CommandLine& line) {
  line.global.style = style_of(raw.color, raw.format);
  line.generate.scene = {sources(raw.outputs), sources(raw.fixed), sources(raw.sizes)};
  line.show.scene = {{}, sources(raw.fixed), sources(raw.sizes)};
  const bool names_outputs = !line.show.what.empty() && !is_subject_of_its_own(line.show.what);
  if (names_outputs) line.show.scene.outputs = sources({line.show.what});
  Result<Limits> limits = read_limits(raw.limits);
  if (!limits) return limits.diagnostics;
  line.global.limits = *limits;
  return {};
}

}  // namespace

DiagnosticStyle style_of_mistakes(const std::vector<std::string>& words) {
  const std::string color = value_of(words, "--color");
  return style_of(color.empty() ? "auto" : color, value_of(words, "--format"));
}

Result<CommandLine> read_command_line(const std::vector<std::string>& words) {
  CommandLine line;
  RawOptions raw;
  CLI::App app(examples, "elgen");
  app.fallthrough();
  app.get_formatter()->column_width(34);
  add_global_options(app, line, raw);
  const CLI::App* generate = add_generate(app, line, raw);
  const CLI::App* show = add_show(app, line, raw);
  const CLI::App* verify = add_verify(app, line);
  const CLI::App* import_command = add_import(app, line);
  CLI::App* explain =
      app.add_subcommand("explain", "what an error code or an entry of a model means");
  explain->add_option("name", line.name, "E201, coordinate, scene.outputs")->required();
  try {
    std::vector<std::string> reversed(words.rbegin(), words.rend() - 1);
    app.parse(reversed);
  } catch (const CLI::CallForHelp&) {
    line.answer = app.help("", CLI::AppFormatMode::Normal);
    return line;
  } catch (const CLI::CallForVersion& version) {
    line.answer = std::string(version.what()) + "\n";
    return line;
  } catch (const CLI::ParseError& error) {
    return rejected(app, words, error);
  }
  if (raw.list_limits) {
    line.answer = limits_text();
    return line;
  }
  if (app.get_subcommands().empty()) {
    return Diagnostic{Code::E913, {}, "no command given", "see `elgen --help`"};
  }
  line.command = generate->parsed()         ? Command::generate
                 : show->parsed()           ? Command::show
                 : verify->parsed()         ? Command::verify
                 : import_command->parsed() ? Command::import
                                            : Command::explain;
  line.generate.output_directory_given = generate->count("-o") > 0;
  const Diagnostics errors = finish(raw, line);
  if (!errors.empty()) return errors;
  line.generate.repair_command = repair_command(words, line.generate);
  return line;
}

}  // namespace elgen::cli
