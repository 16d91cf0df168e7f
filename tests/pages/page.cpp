#include "pages/page.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

constexpr std::string_view backticks = "```";
constexpr std::string_view any_lines = "…";

/// Sets the kind and file of a fence. The file is the last word: "cpp in out/a.hpp".
void classify(Fence& fence) {
  static const std::regex file(R"(\w[\w+]* ([\w./-]+\.\w+))");
  static const std::regex excerpt(R"(\w[\w+]* in ([\w./-]+\.\w+))");
  std::smatch match;
  if (fence.info == "sh") fence.kind = FenceKind::commands;
  if (std::regex_match(fence.info, std::regex("sh not-run: .+"))) fence.kind = FenceKind::not_run;
  if (fence.info == "console") fence.kind = FenceKind::console;
  if (fence.info == "text") fence.kind = FenceKind::picture;
  if (std::regex_match(fence.info, match, excerpt)) {
    fence.kind = FenceKind::excerpt;
    fence.file = match[1];
  } else if (std::regex_match(fence.info, match, file)) {
    fence.kind = FenceKind::file;
    fence.file = match[1];
  }
}

/// The parts of `expected` between its lines "…"; the first and the last part may be empty.
std::vector<std::string> chunks_of(const std::string& expected) {
  std::vector<std::string> chunks(1);
  for (const std::string& line : split_lines(expected)) {
    if (line == any_lines) {
      chunks.emplace_back();
    } else {
      chunks.back() += line + "\n";
    }
  }
  return chunks;
}

/// The position of the first `chunk` in `text` that starts a line at or after position `at`.
std::size_t find_lines(const std::string& text, const std::string& chunk, std::size_t at) {
  std::size_t found = text.find(chunk, at);
  while (found != std::string::npos && found > 0 && text[found - 1] != '\n') {
    found = text.find(chunk, found + 1);
  }
  return found;
}

}  // namespace

const std::vector<Page>& pages() {
  static const std::vector<Page> all = [] {
    std::vector<Page> read;
    for (const char* folder : {"", "models/", "src/", "src/cli/", "templates/", "tests/",
                               "generated/", "examples/", "recipes/", "recipes/sweeps/"}) {
      const std::string path = std::string(folder) + "README.md";
      read.push_back(read_page(path, read_text(std::string(ELGEN_SOURCE_DIR) + "/" + path)));
    }
    const std::string reference = "models/REFERENCE.md";
    read.push_back(
        read_page(reference, read_text(std::string(ELGEN_SOURCE_DIR) + "/" + reference)));
    return read;
  }();
  return all;
}

const Page& page(const std::string& path) {
  const auto found = std::find_if(pages().begin(), pages().end(),
                                  [&](const Page& one) { return one.path == path; });
  if (found == pages().end()) throw std::runtime_error("no page " + path);
  return *found;
}

Page read_page(const std::string& path, const std::string& text) {
  Page read{path};
  bool is_open = false;
  std::size_t number = 0;
  for (const std::string& line : split_lines(text)) {
    ++number;
    if (starts_with(line, std::string(backticks))) {
      is_open = !is_open;
      if (!is_open) continue;
      read.fences.push_back({number, FenceKind::unknown, line.substr(backticks.size())});
      classify(read.fences.back());
    } else {
      (is_open ? read.fences.back().text : read.prose) += line + "\n";
    }
  }
  return read;
}

std::vector<Exchange> exchanges(const std::string& console) {
  std::vector<Exchange> all;
  for (const std::string& line : split_lines(console)) {
    if (starts_with(line, "$ ")) {
      all.push_back({line.substr(2)});
    } else if (!all.empty()) {
      all.back().output += line + "\n";
    } else {
      throw std::runtime_error("no command before: " + line);
    }
  }
  return all;
}

bool agrees(const std::string& expected, const std::string& text) {
  const std::vector<std::string> chunks = chunks_of(expected);
  if (chunks.size() == 1) return expected == text;
  if (!starts_with(text, chunks.front())) return false;
  std::size_t at = chunks.front().size();
  for (std::size_t i = 1; i + 1 < chunks.size(); ++i) {
    at = find_lines(text, chunks[i], at);
    if (at == std::string::npos) return false;
    at += chunks[i].size();
  }
  const std::string& last = chunks.back();
  return text.size() >= at + last.size() &&
         text.compare(text.size() - last.size(), last.size(), last) == 0;
}

std::vector<std::string> all_matches(const std::string& text, const std::regex& pattern) {
  std::vector<std::string> matches;
  for (std::sregex_iterator i(text.begin(), text.end(), pattern), end; i != end; ++i) {
    matches.push_back((*i)[1]);
  }
  return matches;
}

std::vector<std::string> links(const std::string& prose) {
  return all_matches(prose, std::regex(R"re((?:\]\(|<img src=")([^)\s"]+)[)"])re"));
}

std::vector<std::string> anchors(const std::string& prose) {
  std::vector<std::string> all;
  for (const std::string& heading : all_matches(prose, std::regex(R"((?:^|\n)#+ ([^\n]+))"))) {
    std::string anchor;
    for (const char c : heading) {
      const auto letter = static_cast<unsigned char>(c);
      if (c == ' ') anchor += '-';
      if (std::isalnum(letter) != 0 || c == '-' || c == '_') {
        anchor += static_cast<char>(std::tolower(letter));
      }
    }
    all.push_back(anchor);
  }
  return all;
}

std::vector<std::string> code_spans(const std::string& prose) {
  return all_matches(prose, std::regex("`([^`\n]+)`"));
}

}  // namespace elgen::test
