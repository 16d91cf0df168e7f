#include "fuzz/command_line/process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>

#include "support/shell.hpp"

namespace elgen::fuzz {

namespace {

constexpr int not_started = 127;

void limit(int resource, rlim_t value) {
  const rlimit both{value, value};
  setrlimit(static_cast<__rlimit_resource_t>(resource), &both);
}

void redirect(const std::filesystem::path& path, int flags, int descriptor) {
  const int file = open(path.c_str(), flags, 0600);
  if (file < 0 || dup2(file, descriptor) < 0) _exit(not_started);
  close(file);
}

[[noreturn]] void become(const std::vector<std::string>& words, const std::filesystem::path& folder,
                         const ProcessLimits& limits, const std::filesystem::path& captured) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  redirect("/dev/null", O_RDONLY, STDIN_FILENO);
  redirect(captured / "output", O_WRONLY | O_CREAT, STDOUT_FILENO);
  redirect(captured / "errors", O_WRONLY | O_CREAT, STDERR_FILENO);
  limit(RLIMIT_CPU, limits.seconds);
  limit(RLIMIT_AS, static_cast<rlim_t>(limits.memory_mib) << 20U);
  limit(RLIMIT_CORE, 0);
  if (chdir(folder.c_str()) == 0) execvp(arguments[0], arguments.data());
  _exit(not_started);
}

}  // namespace

Ended run(const std::vector<std::string>& words, const std::filesystem::path& folder,
          const ProcessLimits& limits) {
  const test::Workspace captured;
  const pid_t child = fork();
  if (child == 0) become(words, folder, limits, captured.path());
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) {
    throw std::runtime_error("cannot run " + words[0]);
  }
  Ended ended;
  ended.status = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  ended.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (ended.status == not_started) throw std::runtime_error("cannot start " + words[0]);
  ended.output = test::read_text(captured.path() / "output");
  ended.errors = test::read_text(captured.path() / "errors");
  return ended;
}

}  // namespace elgen::fuzz
