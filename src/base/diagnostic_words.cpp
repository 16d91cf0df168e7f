// diagnostic_words: shortens long names, and escapes text for GitHub. In the message of a workflow
// command, line ends, per cent signs and hidden characters must be escaped; in a property, also
// colons and commas.
#include "base/diagnostic_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/utf8.hpp"

namespace elgen {

namespace {

std::string escape_for_github(std::string_view text, std::string_view signs) {
  std::string result;
  for (const char c : visible_text(text)) {
    if (signs.find(c) == std::string_view::npos) {
      result += c;
    } else {
      result += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return result;
}

constexpr std::string_view message_escapes = "%\r\n";
constexpr std::string_view property_escapes = "%\r\n:,";

}  // namespace

std::string shorten_quotations(std::string_view text) {
  constexpr std::size_t longest = 200;
  const std::string visible = visible_text(text);
  std::string_view message = visible;
  std::string shortened;
  for (bool is_quoted = false; !message.empty(); is_quoted = !is_quoted) {
    const std::size_t size = std::min(message.find('`'), message.size());
    std::size_t shown = is_quoted ? std::min(size, longest) : size;
    while (shown < size && !starts_code_point(message[shown])) --shown;
    shortened += message.substr(0, shown);
    if (shown < size) shortened += "…";
    if (size < message.size()) shortened += '`';
    message.remove_prefix(std::min(size + 1, message.size()));
  }
  return shortened;
}

std::string message_with_hint(const Diagnostic& diagnostic) {
  const std::string message = shorten_quotations(diagnostic.message);
  return diagnostic.hint.empty()
             ? message
             : fmt::format("{}; {}", message, shorten_quotations(diagnostic.hint));
}

bool is_in_file(const Span& span) {
  return span.source != nullptr && span.source->path != "command line";
}

std::string display_path(const Span& span) {
  if (span.source == nullptr) return "elgen";
  return std::filesystem::path(span.source->path).lexically_normal().generic_string();
}

std::string text_of(const WorkflowCommand& command) {
  std::string properties;
  if (command.place.source != nullptr) {
    const LineColumn at = line_column(*command.place.source, command.place.begin);
    properties = fmt::format("file={},line={},col={},",
                             escape_for_github(display_path(command.place), property_escapes),
                             at.line, at.column);
  }
  properties += "title=" + escape_for_github(command.title, property_escapes);
  return fmt::format("::{} {}::{}\n", command.level, properties,
                     escape_for_github(command.message, message_escapes));
}

}  // namespace elgen
