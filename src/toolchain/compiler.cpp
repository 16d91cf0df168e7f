// The user's compiler: $CXX, else c++, g++, clang++, whichever answers first.
#include "compiler.hpp"

#include <cstdlib>
#include <sstream>

namespace elgen {
namespace {

constexpr const char* flags[] = {
    "-O2",           "-ffp-contract=off",  "-fPIC",        "-shared",  "-Wall",
    "-Wextra",       "-Wpedantic",         "-Wconversion", "-Wshadow", "-Wsign-conversion",
    "-Wfloat-equal", "-Wdouble-promotion", "-Werror"};

/// Where Debian and others keep Eigen; elsewhere $CPATH says it.
constexpr const char* eigen_folder = "/usr/include/eigen3";

std::vector<std::string> language_flags(const std::filesystem::path& source) {
  if (source.extension() == ".c") return {"-std=c99", "-x", "c"};
  return {"-std=c++17", "-isystem", eigen_folder};
}

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
  const std::vector<std::string> of_language = language_flags(source);
  command.insert(command.end(), of_language.begin(), of_language.end());
  command.insert(command.end(), {source.string(), "-o", object.string()});
  return run(command, object.parent_path() / "compiler.txt");
}

}  // namespace elgen
