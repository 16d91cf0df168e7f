// elgen: parses the command line and runs the command that the command line names. Errors of CLI11
// become diagnostics that point into the command line.
#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <new>
#include <system_error>
#include <utility>

#include "base/ascii.hpp"
#include "base/json.hpp"
#include "base/reason.hpp"
#include "cli/commands.hpp"
#include "cli/help/command_list.hpp"
#include "cli/help/commit.hpp"
#include "cli/process/resources.hpp"
#include "cli/process/terminal.hpp"
#include "elgen/wording.hpp"

namespace elgen::cli {

namespace {

constexpr const char* examples =
    "Symbolic Euler-Lagrange equations: a model file in, closed forms and fast C++ out.\n\n"
    "  elgen generate models/cart_pole.toml            write generated/cart_pole/cart_pole.hpp\n"
    "  elgen show models/cart_pole.toml --what steps   the derivation, step by step\n"
    "  elgen verify models/cart_pole.toml              compare with 60-digit arithmetic\n";

struct CommandLine {
  Action action = {};       ///< empty for --help, --version, --limits, and without a command
  std::string answer = {};  ///< the text that is printed if there is no action
  GlobalOptions global = {};
};

/// Options that are converted after CLI11 has parsed them.
struct RawOptions {
  std::string color = "auto";
  std::string format = "text";
  std::vector<std::string> limits = {};
  bool list_limits = false;
};

/// "elgen 0.1.0 (d205d2cd1a2b)".
std::string version_text() {
  const std::string of_commit = *commit == '\0' ? "" : fmt::format(" ({})", commit);
  return "elgen " ELGEN_VERSION + of_commit;
}

void add_global_options(CLI::App& app, CommandLine& line, RawOptions& raw) {
  app.set_version_flag("-V,--version", version_text());
  app.add_option("--color", raw.color,
                 "auto, always or never (default: auto; NO_COLOR is honoured)")
      ->check(CLI::IsMember({"auto", "always", "never"}));
  app.add_option("--format", raw.format,
                 "format of messages: text, json (also of results) or github")
      ->check(CLI::IsMember(column_words(diagnostic_formats(), &DiagnosticFormatRow::word)));
  app.add_flag("-q,--quiet", line.global.quiet, "print errors and warnings only");
  app.add_flag("-v,--verbose", line.global.verbose, "print equations and further details");
  app.add_option("--dump", line.global.dump_stage, "print the result of a stage on stdout")
      ->check(CLI::IsMember({"derive", "lower"}));
  app.add_option("--stop-after", line.global.stop_after, "stop after this stage and write nothing")
      ->check(CLI::IsMember(std::vector<std::string>(stage_names.begin(), stage_names.end())));
  app.add_flag("--timings", line.global.timings, "print the time of every stage");
  app.add_flag("--limits", raw.list_limits, "list the limits and exit");
  app.add_option("--limit", raw.limits, "raise or lower a limit")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
}

/// E913 at `word`, in a source that contains the command line.
Diagnostic error_at_word(const std::vector<std::string>& words, const std::string& word,
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
  span.source = make_permanent_source("command line", text).get();
  return {Reason::unknown_option, span, std::move(message), std::move(hint)};
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

/// The hint "see `elgen COMMAND --help`"; without COMMAND if the command line names no command.
std::string help_hint(const CLI::App& app) {
  const std::vector<CLI::App*> begun = app.get_subcommands();
  const std::string command = begun.empty() ? "" : begun.front()->get_name() + " ";
  return fmt::format("see `elgen {}--help`", command);
}

/// Turns `elgen help show` into `elgen show --help`, and `elgen help` into `elgen --help`.
std::vector<std::string> without_help_command(std::vector<std::string> words) {
  if (words.size() < 2 || words[1] != "help") return words;
  words.erase(words.begin() + 1);
  words.emplace_back("--help");
  return words;
}

/// Turns `--state a=1 b=2` and `--state a=1, b=2` into `--state a=1 --state b=2`. Names of input
/// files do not count as settings.
std::vector<std::string> repeat_options(const std::vector<std::string>& words) {
  std::vector<std::string> all;
  std::string option;  // the option to which the next settings belong
  bool is_first = false;
  for (std::string word : words) {
    const std::size_t equals = word.find('=');
    if (word.starts_with("--")) {
      option = word.substr(0, equals);
      is_first = equals == std::string::npos;
    } else if (equals == std::string::npos || word.ends_with(".toml")) {
      option.clear();
    } else if (!option.empty()) {
      if (!is_first) all.push_back(option);
      is_first = false;
      if (word.ends_with(',')) word.pop_back();
    }
    all.push_back(std::move(word));
  }
  return all;
}

/// The option of the begun command, or the common option, that takes the word of a flag such as
/// `--latex`: "--as latex". "" if no option takes the word.
std::string option_with_choice(const CLI::App& app, const std::string& word) {
  for (const CLI::App* command : app.get_subcommands()) {
    const std::string option = option_with_choice(*command, word);
    if (!option.empty()) return option;
  }
  for (const ListedOption& option : command_list(app).options) {
    const bool takes_word = std::ranges::count(option.choices, word) > 0;
    if (takes_word) return fmt::format("{} {}", option.names.back(), word);
  }
  return "";
}

/// The hint on a word that no option or argument takes.
std::string extra_word_hint(const CLI::App& app, const std::string& extra) {
  const std::string word = extra.substr(0, extra.find('='));
  if (word.ends_with(".toml")) {
    return app.get_subcommands().empty()
               ? fmt::format("write `elgen show {}`", printable_path(word))
               : "one input at a time";
  }
  if (word == "-o") return "the result goes to stdout: write `> FILE`";
  const std::vector<std::string> known = known_words(app);
  std::string meant = nearest_word(word, known);
  const auto longer = std::ranges::find_if(
      known, [&word](const std::string& name) { return name.starts_with(word); });
  if (meant.empty() && word.size() > 1 && longer != known.end()) meant = *longer;
  if (!meant.empty()) return fmt::format("did you mean `{}`?", meant);
  const std::string option = word.starts_with("--") ? option_with_choice(app, word.substr(2)) : "";
  return option.empty() ? help_hint(app) : fmt::format("write `{}`", option);
}

/// The hint on a required option or argument that is missing; if none is, help_hint().
std::string missing_option_hint(const CLI::App& app) {
  for (const CLI::App* command : app.get_subcommands()) {
    for (const CLI::Option* option : command->get_options()) {
      if (!option->get_required() || option->count() > 0) continue;
      const std::string& doc = option->get_description();
      const std::string name = option->get_name();
      return name.starts_with("--") ? fmt::format("{}: write `{} 10`", doc, name) : "write " + doc;
    }
  }
  return help_hint(app);
}

Diagnostic parse_error(const CLI::App& app, const std::vector<std::string>& words,
                       const CLI::ParseError& error) {
  const std::vector<std::string> extras = app.remaining(true);
  if (!extras.empty()) {
    const std::string& word = extras.front();
    return error_at_word(words, word, fmt::format("`{}` is not understood", word),
                         extra_word_hint(app, word));
  }
  std::string message = error.what();
  if (!message.empty()) message[0] = to_lower_case(message[0]);
  return {Reason::unknown_option, {}, message, missing_option_hint(app)};
}

Result<Limits> read_limits(const std::vector<std::string>& settings) {
  Limits limits;
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    const std::string name = setting.substr(0, equals);
    const auto row = std::ranges::find(limit_table(), name, &LimitRow::name);
    if (row == limit_table().end()) {
      const std::vector<std::string> names = column_words(limit_table(), &LimitRow::name);
      return Diagnostic{Reason::unknown_limit,
                        {},
                        fmt::format("`{}` is no limit", name),
                        suggestion(name, names, "see `elgen --limits`")};
    }
    const std::string value = equals == std::string::npos ? "" : setting.substr(equals + 1);
    const char* end = value.data() + value.size();
    const auto read = std::from_chars(value.data(), end, limits.*row->member);
    if (value.empty() || read.ec != std::errc() || read.ptr != end) {
      return Diagnostic{
          Reason::unknown_limit, {}, fmt::format("`{}` is no limit: write NAME=NUMBER", setting)};
    }
  }
  const bool is_given = std::ranges::any_of(
      settings, [](const std::string& setting) { return setting.starts_with("enclosures="); });
  constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max() / enclosures_per_second;
  if (!is_given) limits.enclosures = enclosures_per_second * std::min(limits.seconds, most);
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

std::string limits_json() {
  Json list = Json::array();
  for (const LimitRow& row : limit_table()) {
    list.push_back({{"name", row.name},
                    {"value", Limits().*row.member},
                    {"unit", row.unit},
                    {"doc", row.doc}});
  }
  return list.dump(2) + "\n";
}

/// The line that names the first page of an installed elgen; "" if its pages are not installed.
std::string pages_line() {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path page = (program.parent_path() / ELGEN_PAGES / "README.md").lexically_normal();
  if (error || !fs::exists(page, error)) return "";
  return fmt::format("Pages to read: {}\n", page.string());
}

/// The help that `elgen` prints without arguments: examples and all commands.
std::string short_help(const CLI::App& app) {
  std::string text = std::string(examples) + "\n";
  for (const CLI::App* command : app.get_subcommands({})) {
    text += fmt::format("  {:<10} {}\n", command->get_name(), command->get_description());
  }
  return text +
         "\n`elgen COMMAND --help` lists the options of a command, `elgen --help` the common "
         "options.\n" +
         pages_line();
}

bool wants_color(const std::string& choice) {
  if (choice != "auto") return choice == "always";
  return std::getenv("NO_COLOR") == nullptr && is_terminal(stderr);
}

DiagnosticStyle style_of(const std::string& color, const std::string& format) {
  DiagnosticStyle style;
  style.color = wants_color(color);
  for (const DiagnosticFormatRow& row : diagnostic_formats()) {
    if (row.word == format) style.format = row.format;
  }
  return style;
}

/// E913 for each option whose output has no JSON form, if the format is JSON.
Diagnostics check_json_options(const GlobalOptions& global) {
  if (!wants_json(global)) return {};
  Diagnostics refused;
  const auto refuse = [&](bool is_asked_for, const char* option) {
    if (!is_asked_for) return;
    refused.push_back(
        {Reason::not_as_json, {}, fmt::format("`{}` is not printed as json", option)});
  };
  refuse(global.timings, "--timings");
  refuse(global.verbose, "-v");
  refuse(!global.dump_stage.empty(), "--dump");
  return refused;
}

/// The value of an option, found without CLI11, even if other words contain mistakes.
std::string find_option_value(const std::vector<std::string>& words, const std::string& option) {
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (words[i] == option && i + 1 < words.size()) return words[i + 1];
    if (words[i].rfind(option + "=", 0) == 0) return words[i].substr(option.size() + 1);
  }
  return {};
}

/// The style for errors of read_command_line(), from --color and --format as far as they are valid.
DiagnosticStyle command_line_error_style(const std::vector<std::string>& words) {
  const std::string color = find_option_value(words, "--color");
  return style_of(color.empty() ? "auto" : color, find_option_value(words, "--format"));
}

/// Parses the command line. E913, with a suggestion, for words that are not understood.
Result<CommandLine> read_command_line(const std::vector<std::string>& words) {
  CommandLine line;
  RawOptions raw;
  CLI::App app(examples, "elgen");
  app.fallthrough();
  app.get_formatter()->column_width(34);
  add_global_options(app, line, raw);
#define ELGEN_COMMAND(name) add_##name(app, line.action);
#include "cli/commands.def"
#undef ELGEN_COMMAND
  try {
    const std::vector<std::string> read = repeat_options(without_help_command(words));
    std::vector<std::string> reversed(read.rbegin(), read.rend() - 1);
    app.parse(reversed);
  } catch (const CLI::CallForHelp& help) {
    const bool has_command = !app.get_subcommands().empty();
    if (!has_command && app.remaining_size(true) > 0) return parse_error(app, words, help);
    line.answer = app.help("", CLI::AppFormatMode::Normal);
    if (app.get_subcommands().empty()) line.answer += pages_line();
    return line;
  } catch (const CLI::CallForVersion& version) {
    line.answer = std::string(version.what()) + "\n";
    return line;
  } catch (const CLI::ParseError& error) {
    return parse_error(app, words, error);
  }
  if (raw.list_limits) {
    line.answer = raw.format == "json" ? limits_json() : limits_text();
    return line;
  }
  if (app.get_subcommands().empty()) {
    if (words.size() > 1) {
      return Diagnostic{Reason::no_command, {}, "no command given", "see `elgen --help`"};
    }
    line.answer = short_help(app);
    return line;
  }
  line.global.words = words;
  line.global.style = style_of(raw.color, raw.format);
  Result<Limits> limits = read_limits(raw.limits);
  if (!limits) return limits.diagnostics;
  line.global.limits = *limits;
  const Diagnostics refused = check_json_options(line.global);
  if (!refused.empty()) return refused;
  return line;
}

/// Runs the command line. Sets `global` before the command runs, so that the caller can report
/// exceptions in the requested format.
ExitCode run_command_line(const std::vector<std::string>& words, GlobalOptions& global) {
  const auto line = read_command_line(words);
  if (!line) {
    global.style = command_line_error_style(words);
    return report(global, line.diagnostics);
  }
  global = line->global;
  set_resource_limits(global.limits, global.style);
  return line->action ? line->action(global) : print(global, line->answer);
}

/// Runs the command line; every exception becomes a diagnostic.
ExitCode run_program(int count, char** words) {
  GlobalOptions global;
  try {
    return run_command_line({words, words + count}, global);
  } catch (const std::bad_alloc&) {
    return report(global, {memory_limit_error(global.limits)});
  } catch (const std::exception& mistake) {
    return report(global,
                  {{Reason::exception, {}, fmt::format("internal error: {}", mistake.what())}});
  }
}

}  // namespace

}  // namespace elgen::cli

int main(int argc, char** argv) { return static_cast<int>(elgen::cli::run_program(argc, argv)); }
