#include "support/shell.hpp"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace elgen::test {

namespace {

std::string in_backticks(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

/// The exit status that a shell would report.
int exit_status(int wait_status) {
  return WIFEXITED(wait_status) ? WEXITSTATUS(wait_status) : 128 + WTERMSIG(wait_status);
}

}  // namespace

Outcome shell(const std::string& command, const std::filesystem::path& folder) {
  const std::filesystem::path elgen = ELGEN_BINARY;
  const Workspace captured;
  const auto script = captured.path() / "script";
  const auto output = captured.path() / "output";
  const auto errors = captured.path() / "errors";
  write_text(script, "unset CXX NO_COLOR\nELGEN=" + in_backticks(elgen) + "\nPATH=" +
                         in_backticks(elgen.parent_path()) + ":$PATH\nexport ELGEN PATH\ncd " +
                         in_backticks(folder) + " || exit 99\n" + command + "\n");
  const std::string line = "sh " + in_backticks(script) + " </dev/null >" + in_backticks(output) +
                           " 2>" + in_backticks(errors);
  const int status = exit_status(std::system(line.c_str()));
  return {status, read_text(output), read_text(errors)};
}

void prepare(const std::string& command, const std::filesystem::path& folder) {
  const Outcome outcome = shell(command, folder);
  if (outcome.status != 0) throw std::runtime_error(command + ": " + outcome.errors);
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

bool starts_with(const std::string& text, const std::string& start) {
  return text.rfind(start, 0) == 0;
}

std::string files_below(const std::filesystem::path& folder) {
  return shell("find . -type f | LC_ALL=C sort", folder).output;
}

Workspace::Workspace(const std::string& prefix) {
  std::string pattern = (std::filesystem::temp_directory_path() / (prefix + "XXXXXX")).string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = pattern;
}

Workspace::~Workspace() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string Workspace::read(const std::string& file) const { return read_text(path_ / file); }

void Workspace::write(const std::string& file, const std::string& text) const {
  write_text(path_ / file, text);
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

}  // namespace elgen::test
