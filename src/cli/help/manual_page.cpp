// manual_page: elgen(1) in the macros of man.
#include <fmt/format.h>

#include <array>

#include "base/fill_template.hpp"
#include "cli/help/command_list.hpp"
#include "elgen/diagnostic.hpp"

namespace elgen::cli {

namespace {

struct ExitCodeRow {
  ExitCode code;
  std::string_view doc;
};

constexpr std::array exit_rows{
    ExitCodeRow{ExitCode::success, "success: nothing differs, all checks hold"},
    ExitCodeRow{ExitCode::differs, "files or equations differ, or a check fails"},
    ExitCodeRow{ExitCode::invalid, "error in the command line or in an input"},
    ExitCodeRow{ExitCode::limit, "a limit was reached, or the self-check failed"},
    ExitCodeRow{ExitCode::inaccessible,
                "a file could not be read or written, or a program could not run"},
    ExitCodeRow{ExitCode::internal, "internal error of elgen"},
    ExitCodeRow{ExitCode::interrupted, "interrupted; no file is incomplete"}};

/// Escapes for troff: backslashes, and dots and apostrophes at the start of a line. Hyphens become
/// minus signs, so that readers can copy options.
std::string escape_for_troff(const std::string& text) {
  std::string result;
  bool begins_line = true;
  for (const char c : text) {
    if (begins_line && (c == '.' || c == '\'')) result += "\\&";
    begins_line = c == '\n';
    result += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  }
  return result;
}

/// The names of an option, and its argument: "\fB-o\fR, \fB--output-directory\fR \fIDIR\fR".
std::string heading_of(const ListedOption& option) {
  std::string text;
  for (const std::string& name : option.names) {
    const char font = option.is_positional ? 'I' : 'B';
    text += fmt::format("{}\\f{}{}\\fR", text.empty() ? "" : ", ", font, escape_for_troff(name));
  }
  if (option.is_positional || option.type.empty()) return text;
  std::string words;  // "\\:" after each word: troff may break the line here
  for (const std::string& choice : option.choices) {
    words += (words.empty() ? "" : "|\\:") + escape_for_troff(choice);
  }
  return fmt::format("{} \\fI{}\\fR", text, words.empty() ? escape_for_troff(option.type) : words);
}

TemplateData option_rows(const std::vector<ListedOption>& options) {
  return repeated_section(options, [](const ListedOption& option) {
    return TemplateRow{{"heading", heading_of(option)}, {"doc", escape_for_troff(option.doc)}};
  });
}

}  // namespace

std::string manual_page(const CommandList& list) {
  const TemplateData commands = repeated_section(list.commands, [](const ListedCommand& command) {
    return TemplateRow{{"name", command.name},
                       {"manual_doc", escape_for_troff(command.doc)},
                       {"manual_options", option_rows(command.options)}};
  });
  const TemplateData exit_codes = repeated_section(exit_rows, [](const ExitCodeRow& row) {
    return TemplateRow{{"code", std::to_string(static_cast<int>(row.code))},
                       {"doc", escape_for_troff(std::string(row.doc))}};
  });
  return fill_template("pages/manual.1.mustache",
                       TemplateRow{{"version", ELGEN_VERSION},
                                   {"doc", escape_for_troff(list.doc)},
                                   {"options", option_rows(list.options)},
                                   {"commands", commands},
                                   {"exit_codes", exit_codes}});
}

}  // namespace elgen::cli
