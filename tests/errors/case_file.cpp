#include "errors/case_file.hpp"

#include <sstream>
#include <stdexcept>

namespace elgen::test {

namespace {

constexpr std::string_view marker = "--- ";

std::vector<Section> split(std::string_view text) {
  std::vector<Section> sections;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(marker, 0) == 0) {
      sections.push_back({line.substr(marker.size()), ""});
    } else if (sections.empty()) {
      throw std::invalid_argument("a case starts with `--- `");
    } else {
      sections.back().body += line + "\n";
    }
  }
  return sections;
}

void append(std::string& text, const std::string& title, const std::string& body) {
  text += std::string(marker) + title + "\n" + body;
}

}  // namespace

CaseFile parse_case(std::string_view text) {
  CaseFile parsed;
  bool has_exit = false;
  for (Section& section : split(text)) {
    if (section.title == "command") {
      parsed.command = section.body;
    } else if (section.title == "stdout") {
      parsed.expected.output = section.body;
    } else if (section.title == "stderr") {
      parsed.expected.errors = section.body;
    } else if (section.title.rfind("exit ", 0) == 0) {
      parsed.expected.status = std::stoi(section.title.substr(5));
      has_exit = true;
    } else {
      parsed.inputs.push_back(std::move(section));
    }
  }
  if (parsed.command.empty() || !has_exit) {
    throw std::invalid_argument("a case has a command and an exit code");
  }
  return parsed;
}

std::string to_text(const CaseFile& parsed) {
  std::string text;
  for (const Section& input : parsed.inputs) append(text, input.title, input.body);
  append(text, "command", parsed.command);
  append(text, "exit " + std::to_string(parsed.expected.status), "");
  if (!parsed.expected.output.empty()) append(text, "stdout", parsed.expected.output);
  if (!parsed.expected.errors.empty()) append(text, "stderr", parsed.expected.errors);
  return text;
}

Outcome run_case(const CaseFile& parsed) {
  const Workspace workspace;
  for (const Section& input : parsed.inputs) {
    workspace.write(input.title, input.body);
  }
  return workspace.run(parsed.command);
}

}  // namespace elgen::test
