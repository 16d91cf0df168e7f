// workflow_command: a message may hold anything but line ends, per cent signs and what is not seen,
// a property no colons and commas either.
#include "base/workflow_command.hpp"

#include <fmt/format.h>

#include "base/diagnostic_words.hpp"
#include "base/utf8.hpp"

namespace elgen {
namespace {

std::string escaped(std::string_view text, std::string_view signs) {
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

constexpr std::string_view of_messages = "%\r\n";
constexpr std::string_view of_properties = "%\r\n:,";

}  // namespace

std::string text_of(const WorkflowCommand& command) {
  std::string properties;
  if (command.place.source != nullptr) {
    const LineColumn at = line_column(*command.place.source, command.place.begin);
    properties = fmt::format("file={},line={},col={},",
                             escaped(path_of(command.place), of_properties), at.line, at.column);
  }
  properties += "title=" + escaped(command.title, of_properties);
  return fmt::format("::{} {}::{}\n", command.level, properties,
                     escaped(command.message, of_messages));
}

}  // namespace elgen
