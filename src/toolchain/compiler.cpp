// compiler: finds and runs the user's compiler. The compiler is $CXX, if this variable is set;
// otherwise the first of c++, g++, clang++ that answers.
#include <fmt/ranges.h>
#include <gnu/libc-version.h>
#include <sys/utsname.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>

#include "toolchain/workshop.hpp"

namespace elgen {
namespace {

/// Flags in the order of BuildFlags. Without -fno-tree-slp-vectorize, g++ 12 contracts products and
/// sums in straight-line code to vfmaddsub, despite -ffp-contract=off.
constexpr std::array<const char*, 4> flags_of_builds{
    "-O2 -ffp-contract=off -fPIC -shared -Wall -Wextra -Wpedantic -Wconversion -Wshadow "
    "-Wsign-conversion -Wfloat-equal -Wdouble-promotion -Werror",
    "-O3 -march=native -ffp-contract=off -fno-tree-slp-vectorize -fPIC -shared",
    "-O3 -march=native -ffp-contract=fast -fPIC -shared",
    "-O2 -march=native -ffp-contract=fast -fPIC -shared"};

/// Eigen's folder on Debian and most other systems. Elsewhere the user's $CPATH must name it.
constexpr const char* eigen_folder = "/usr/include/eigen3";

CompilerCommand language_flags(const std::filesystem::path& source) {
  if (source.extension() == ".c") return {"-std=c99", "-x", "c"};
  return {"-std=c++17", "-isystem", eigen_folder};
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string chosen_compiler() {
  const char* const chosen = std::getenv("CXX");
  return chosen == nullptr ? "" : chosen;
}

Diagnostic time_limit_error(const CompilerCommand& command, std::uint64_t seconds) {
  return {Code::E909,
          {},
          fmt::format("`{}` has not ended within {} s", fmt::join(command, " "), seconds),
          "`--limit seconds=N` raises the limit"};
}

/// E704. `last`: the result of the last candidate.
Diagnostic no_compiler_error(const ProcessResult& last) {
  const std::string chosen = chosen_compiler();
  if (!chosen.empty()) {
    return {
        Code::E704,
        {},
        fmt::format("`{}`, which $CXX names, {}", chosen, ending_text(last.ending, last.status))};
  }
  std::string tried;
  for (const CompilerCommand& candidate : compiler_candidates()) {
    tried += fmt::format("{}`{}`", tried.empty() ? "" : ", ", candidate.front());
  }
  return {Code::E704, {}, "tried " + tried};
}

/// A source that compiles if the compiler supports the language and its library, does not
/// reassociate sums, and can write an object.
std::string probe_text(const SourceFile& source) {
  std::string headers =
      "#include <math.h>\n#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__)\n#error\n"
      "#endif\n";
  if (!source.required_header.empty()) {
    headers +=
        fmt::format("#if __has_include(<{0}>)\n#include <{0}>\n#endif\n", source.required_header);
  }
  return headers + "int elgen_probe(void);\nint elgen_probe(void) { return 0; }\n";
}

/// True if the compiler refused the source: GCC and clang then exit with 1. GCC also exits with 1
/// if memory or disk space is exhausted; its output then names this reason.
bool is_refusal(const ProcessResult& compiled) {
  constexpr std::array<std::string_view, 4> other_reasons{
      "signal terminated program", "virtual memory exhausted", "out of memory",
      "No space left on device"};
  const auto is_said = [&compiled](std::string_view reason) {
    return compiled.output.find(reason) != std::string::npos;
  };
  return compiled.ending == ProcessEnding::exited && compiled.status == 1 &&
         std::none_of(other_reasons.begin(), other_reasons.end(), is_said);
}

/// The model name in /proc/cpuinfo, which x86 systems have; otherwise the name of the architecture.
std::string processor_name() {
  constexpr std::string_view key = "model name";
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with(key) && colon != std::string::npos) return line.substr(colon + 2);
  }
  utsname system{};
  return ::uname(&system) == 0 ? system.machine : "";
}

}  // namespace

std::vector<CompilerCommand> compiler_candidates() {
  const std::string chosen = chosen_compiler();
  if (chosen.empty()) return {{"c++"}, {"g++"}, {"clang++"}};
  std::vector<CompilerCommand> candidates{{chosen}};
  if (CompilerCommand words = words_of_command(chosen); words.size() > 1)
    candidates.push_back(words);
  return candidates;
}

Result<Compiler> find_compiler(std::uint64_t seconds) {
  ProcessResult answer;
  for (const CompilerCommand& candidate : compiler_candidates()) {
    CompilerCommand question = candidate;
    question.emplace_back("--version");
    answer = run_process(question, seconds);
    if (answer.succeeded()) return Compiler{candidate, seconds, first_line(answer.output)};
    if (answer.ending == ProcessEnding::out_of_time) return time_limit_error(question, seconds);
    if (answer.ending == ProcessEnding::interrupted) break;
  }
  return no_compiler_error(answer);
}

ProcessResult compile_shared(const Compiler& compiler, BuildFlags build,
                             const std::filesystem::path& source,
                             const std::filesystem::path& object) {
  CompilerCommand command = compiler.command;
  const char* const flags_of_build = flags_of_builds[static_cast<std::size_t>(build)];
  for (const CompilerCommand& flags : {words_of_command(flags_of_build), language_flags(source)}) {
    command.insert(command.end(), flags.begin(), flags.end());
  }
  command.insert(command.end(), {source.string(), "-o", object.string()});
  return run_process(command, compiler.seconds, object.parent_path().string());
}

bool accepts_probe(const Compiler& compiler, BuildFlags build,
                   const std::filesystem::path& directory, const SourceFile& source) {
  const std::filesystem::path probe = directory / ("probe_" + source.file);
  std::ofstream(probe, std::ios::binary) << probe_text(source);
  return compile_shared(compiler, build, probe, directory / "probe.so").succeeded();
}

Diagnostic compile_error(const Compiler& compiler, const ProcessResult& compiled,
                         const std::filesystem::path& directory, const SourceFile& source) {
  if (compiled.ending == ProcessEnding::out_of_time) {
    return time_limit_error(compiler.command, compiler.seconds);
  }
  const bool is_ours =
      is_refusal(compiled) && accepts_probe(compiler, BuildFlags::as_written, directory, source);
  return {
      is_ours ? Code::E705 : Code::E709,
      {},
      fmt::format("`{}` {}:\n{}", fmt::join(compiler.command, " "),
                  ending_text(compiled.ending, compiled.status), sanitize_output(compiled.output))};
}

Result<Machine> this_machine(const Limits& limits) {
  const Result<Compiler> compiler = find_compiler(limits.seconds);
  if (!compiler) return compiler.diagnostics;
  return Machine{sanitize_output(compiler->version), processor_name(),
                 fmt::format("glibc {}", ::gnu_get_libc_version())};
}

}  // namespace elgen
