#include "support/shell.hpp"

#include <sys/wait.h>

#include <cstdlib>
#include <stdexcept>

namespace elgen::test {

namespace {

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

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
  write_text(script, "unset CXX NO_COLOR\nELGEN=" + quoted(elgen) + "\nPATH=" +
                         quoted(elgen.parent_path()) + ":$PATH\nexport ELGEN PATH\ncd " +
                         quoted(folder) + " || exit 99\n" + command + "\n");
  const std::string line =
      "sh " + quoted(script) + " </dev/null >" + quoted(output) + " 2>" + quoted(errors);
  const int status = exit_status(std::system(line.c_str()));
  return {status, read_text(output), read_text(errors), command};
}

std::string failure_of(const Outcome& outcome) {
  if (outcome.status == 0) return "";
  return outcome.command + ": exit " + std::to_string(outcome.status) + "\n" + outcome.output +
         outcome.errors;
}

void prepare(const std::string& command, const std::filesystem::path& folder) {
  const Outcome outcome = shell(command, folder);
  if (outcome.status != 0) throw std::runtime_error(command + ": " + outcome.errors);
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

}  // namespace elgen::test
