// The user's compiler: $CXX, else c++, g++, clang++, whichever answers first.
#include "compiler.hpp"

#include <cstdlib>
#include <sstream>

namespace elgen {
namespace {

constexpr const char* flags[] = {"-std=c++17",        "-O2",
                                 "-ffp-contract=off", "-fPIC",
                                 "-shared",           "-Wall",
                                 "-Wextra",           "-Wpedantic",
                                 "-Wconversion",      "-Wsign-conversion",
                                 "-Wshadow",          "-Wdouble-promotion",
                                 "-Wfloat-equal",     "-Werror"};

CompilerCommand split(const std::string& text) {
  std::istringstream stream(text);
  CompilerCommand words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

}  // namespace

std::vector<CompilerCommand> compiler_candidates() {
  std::vector<CompilerCommand> candidates;
  const char* chosen = std::getenv("CXX");
  if (chosen != nullptr && *chosen != '\0') {
    candidates.push_back({chosen});
    if (CompilerCommand words = split(chosen); words.size() > 1) candidates.push_back(words);
  }
  for (const char* name : {"c++", "g++", "clang++"}) candidates.push_back({name});
  return candidates;
}

std::optional<CompilerCommand> find_compiler(const std::filesystem::path& scratch) {
  for (CompilerCommand candidate : compiler_candidates()) {
    CompilerCommand question = candidate;
    question.emplace_back("--version");
    const ProcessResult answer = run(question, scratch / "version.txt");
    if (answer.started && answer.status == 0) return candidate;
  }
  return std::nullopt;
}

ProcessResult compile_shared(const CompilerCommand& compiler, const std::filesystem::path& source,
                             const std::filesystem::path& object) {
  std::vector<std::string> command = compiler;
  command.insert(command.end(), std::begin(flags), std::end(flags));
  command.insert(command.end(), {source.string(), "-o", object.string()});
  return run(command, object.parent_path() / "compiler.txt");
}

}  // namespace elgen
