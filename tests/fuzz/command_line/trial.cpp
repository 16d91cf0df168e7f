// Trial: runs commands under limits of processor time and memory, without a shell.
#include "fuzz/command_line/trial.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "fuzz/command_line/mutation.hpp"
#include "random/generator.hpp"
#include "random/trial.hpp"
#include "support/shell.hpp"

namespace elgen::test {
namespace {

struct ProcessResult {
  int status = 0;           ///< the exit code, if the process ended by itself
  int signal = 0;           ///< the signal that ended the process, or 0
  std::string output = {};  ///< standard output
  std::string errors = {};  ///< standard error
};

struct ProcessLimits {
  unsigned seconds = 60;  ///< of processor time
  unsigned long memory_mib = 4096;
};

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

/// Runs the command `words` in `folder` without standard input; throws if the command cannot start.
ProcessResult run(const std::vector<std::string>& words, const std::filesystem::path& folder,
                  const ProcessLimits& limits) {
  const Workspace captured;
  const pid_t child = fork();
  if (child == 0) become(words, folder, limits, captured.path());
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) {
    throw std::runtime_error("cannot run " + words[0]);
  }
  ProcessResult ended;
  ended.status = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  ended.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (ended.status == not_started) throw std::runtime_error("cannot start " + words[0]);
  ended.output = read_text(captured.path() / "output");
  ended.errors = read_text(captured.path() / "errors");
  return ended;
}

namespace fs = std::filesystem;

/// Well above seconds_limit and memory_limit, so that only a process that ignores these two options
/// reaches process_limits.
constexpr ProcessLimits process_limits{.seconds = 40, .memory_mib = 3000};
constexpr const char* seconds_limit = "seconds=10";
constexpr const char* memory_limit = "memory_mib=1000";

/// The scene and its model as files of one folder: `model = "../NAME.toml"` becomes "NAME.toml".
Input scene_input(const fs::path& scene, const fs::path& models) {
  std::string text = read_text(scene);
  static const std::regex reference("\"\\.\\./([a-z0-9_]+\\.toml)\"");
  std::smatch found;
  if (!std::regex_search(text, found, reference)) return {};
  const std::string model = found[1];
  text = std::regex_replace(text, reference, "\"$1\"");
  const std::string name = scene.filename();
  return {name, {{name, text}, {model, read_text(models / model)}}};
}

Input random_input(std::uint64_t seed) {
  const random::System system = random::Generator(seed).system();
  const std::string model = system.model.name + ".toml";
  Input input{model, {{model, random::text_of(system.model)}}};
  if (system.scene.is_present) {
    input.name = system.model.name + ".scene.toml";
    input.files[input.name] = random::text_of(system.scene, system.model);
  }
  return input;
}

bool is_robot(const Input& input) { return input.name.ends_with(".urdf"); }

std::vector<std::string> command_for(const Input& input, Draw& draw) {
  static const std::array<std::string, 6> shown{"lagrangian", "steps", "mass_matrix",
                                                "cost",       "bias",  "forward_dynamics"};
  static const std::array<std::string, 5> formats{"text", "latex", "mathml", "markdown", "json"};
  std::vector<std::string> words{ELGEN_BINARY, "--limit", seconds_limit, "--limit", memory_limit};
  const auto add = [&words](const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
  };
  const std::size_t choice = draw.number_below(8);
  if (is_robot(input)) {
    add({"import", input.name, "-o", "imported.toml"});
  } else if (choice < 5) {
    add({"generate", "-q", "-o", "out", input.name});
  } else if (choice < 7) {
    add({"show", input.name, "--what", draw.one_of(shown), "--as", draw.one_of(formats)});
  } else {
    add({"verify", "--quick", "--format", "json", input.name});
  }
  return words;
}

void write(const Input& input, const fs::path& folder) {
  for (const auto& [name, text] : input.files) write_text(folder / name, text);
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string line_with(const std::string& text, const std::string& part) {
  const std::size_t at = text.find(part);
  const std::size_t begin = text.rfind('\n', at) + 1;
  return text.substr(begin, text.find('\n', at) - begin);
}

/// The first failed check of `certificate` that is a fault of elgen; empty if there is none. A
/// failed [[expect]] or an indefinite M is a fault of the mutated model, not of elgen.
std::string false_alarm(const std::string& certificate) {
  const auto parsed = nlohmann::json::parse(certificate, nullptr, false);
  if (!parsed.is_object() || !parsed.contains("checks")) return {};
  for (const auto& row : parsed.at("checks")) {
    const std::string check = row.at("check");
    if (row.at("verdict") != "fails" || check == "[[expect]]") continue;
    if (check == "mass matrix positive definite") continue;
    return check + ": " + row.at("subject").get<std::string>() + ": " +
           row.at("worst").get<std::string>();
  }
  return {};
}

std::string fault_of_ending(const ProcessResult& ended) {
  static constexpr std::array documented{0, 1, 2, 3, 4};
  if (ended.signal != 0) return "signal " + std::to_string(ended.signal);
  const auto* const known = std::find(documented.begin(), documented.end(), ended.status);
  if (known == documented.end()) {
    return "exit " + std::to_string(ended.status) + ": " + first_line(ended.errors);
  }
  for (const char* const mistake : {"E911", "E912"}) {
    if (test::mentions(ended.errors, mistake)) return line_with(ended.errors, mistake);
  }
  if (ended.status != 0 && ended.errors.empty() && ended.output.empty()) return "no word of why";
  return false_alarm(ended.output);
}

/// "left behind: PATH" for a file or folder that the command must not write; empty if there is
/// none. A failed command may write nothing, a successful command only its output.
std::string unexpected_file(const Trial& trial, const fs::path& folder, bool succeeded) {
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string path = entry.path().lexically_relative(folder).string();
    const bool is_output =
        path == "imported.toml" || path == "out" || test::starts_with(path, "out/");
    const bool is_expected = trial.input.files.count(path) > 0 || (succeeded && is_output);
    if (!is_expected) return "left behind: " + path;
  }
  return {};
}

std::string fault_of_headers(const fs::path& folder) {
  static const std::string strict =
      " -fsyntax-only -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow "
      "-Wdouble-promotion -Werror -isystem /usr/include/eigen3 ";
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string path = entry.path().string();
    const bool is_c = path.ends_with(".h");
    if (!is_c && !path.ends_with(".hpp")) continue;
    const std::string compiler = is_c ? "gcc -std=c99 -x c" : "g++ -std=c++17 -x c++";
    const Outcome compiled =
        shell(compiler + " /dev/null -include '" + path + "'" + strict, folder);
    if (compiled.status != 0) return "does not compile: " + first_line(compiled.errors);
  }
  return {};
}

}  // namespace

Corpus::Corpus(std::size_t random_models) {
  const fs::path root = ELGEN_SOURCE_DIR;
  for (const fs::path& model : files_in(root / "models", ".toml")) {
    const std::string name = model.filename();
    inputs_.push_back({name, {{name, read_text(model)}}});
  }
  for (const fs::path& scene : files_in(root / "models/scenes", ".scene.toml")) {
    const Input input = scene_input(scene, root / "models");
    if (!input.files.empty()) inputs_.push_back(input);
  }
  for (std::uint64_t seed = 0; seed < random_models; ++seed) {
    inputs_.push_back(random_input(seed));
  }
  add_robots(root / "tests/urdf/robots");
}

void Corpus::add_robots(const fs::path& folder) {
  for (const fs::path& robot : files_in(folder, ".urdf")) {
    const std::string name = robot.filename();
    inputs_.push_back({name, {{name, read_text(robot)}}});
  }
}

Trial random_trial(const Corpus& corpus, std::uint64_t seed) {
  Draw draw(seed);
  Trial trial{draw.one_of(corpus.inputs()), {}};
  auto file = trial.input.files.begin();
  std::advance(file, draw.number_below(trial.input.files.size()));
  file->second = mutate(file->second, draw);
  trial.command = command_for(trial.input, draw);
  return trial;
}

Verdict run_trial(const Trial& trial, bool compiles) {
  const Workspace workspace;
  write(trial.input, workspace.path());
  const ProcessResult ended = run(trial.command, workspace.path(), process_limits);
  Verdict verdict{ended.signal == 0 && ended.status == 0, fault_of_ending(ended)};
  if (verdict.fault.empty())
    verdict.fault = unexpected_file(trial, workspace.path(), verdict.worked);
  if (verdict.fault.empty() && verdict.worked && compiles) {
    verdict.fault = fault_of_headers(workspace.path());
  }
  return verdict;
}

void save(const Trial& trial, const std::string& fault, const fs::path& folder) {
  write(trial.input, folder);
  std::string line;
  for (const std::string& word : trial.command) line += (line.empty() ? "" : " ") + word;
  write_text(folder / "finding.txt", fault + "\n" + line + "\n");
}

}  // namespace elgen::test
