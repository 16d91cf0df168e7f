// Calls of foreign code. A library writes to memory that both processes see, so that all it has
// computed before a crash is there; each result has room behind it, which shows how many numbers
// were written.
#include "elgen/foreign_code.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "elgen/wording.hpp"
#include "emit/interface/code_interface.hpp"
#include "model/state_text.hpp"
#include "numbers/exact_number.hpp"
#include "toolchain/forked.hpp"
#include "toolchain/process.hpp"
#include "toolchain/workshop.hpp"

namespace elgen {
namespace {

using AnyFunction = void (*)();
using Pointers = std::vector<const double*>;

struct ForeignCalls {
  const ForeignFunction& function;
  const Model& model;
  const std::vector<Arguments<double>>& states;
  std::vector<Opcode> arguments;
  std::size_t entries;  ///< of each answer
};

/// A NaN that nothing computes.
constexpr std::uint64_t untouched = 0x7ff8'dead'0bad'c0deU;
/// Numbers behind a result: a function of another shape writes there, not over other results.
constexpr std::size_t spare_numbers = 64;
constexpr std::size_t most_arguments = 10;  ///< leaves of all kinds

std::string how_it_ended(const ForeignCalls& calls, Ending ending, int status) {
  const bool is_late = status == 128 + SIGALRM || status == 128 + SIGXCPU;
  return ending_text(is_late ? Ending::out_of_time : ending, status, calls.function.seconds);
}

Pointers pointers_to(const ForeignCalls& calls, const Arguments<double>& state) {
  Pointers pointers;
  for (const Opcode argument : calls.arguments) {
    const std::vector<double>* const list = list_of(state, argument);
    pointers.push_back(list != nullptr ? list->data() : &leaf_of(state, argument, 0));
  }
  return pointers;
}

template <std::size_t>
using Pointer = const double*;

template <std::size_t... i>
void call_with(AnyFunction function, const Pointers& arguments, double* result,
               std::index_sequence<i...> /*all*/) {
  reinterpret_cast<void (*)(Pointer<i>..., double*)>(function)(arguments[i]..., result);
}

/// At least two arguments: parameters and q.
template <std::size_t count = 2>
void call_any(AnyFunction function, const Pointers& arguments, double* result) {
  if constexpr (count <= most_arguments) {
    if (arguments.size() != count) return call_any<count + 1>(function, arguments, result);
    call_with(function, arguments, result, std::make_index_sequence<count>());
  }
}

/// The numbers up to the last that was written.
std::vector<double> written(const double* first, std::size_t slot) {
  const auto is_touched = [](double x) { return std::bit_cast<std::uint64_t>(x) != untouched; };
  std::vector<double> numbers(first, first + slot);
  numbers.erase(std::find_if(numbers.rbegin(), numbers.rend(), is_touched).base(), numbers.end());
  return numbers;
}

/// The process that may crash leaves its results here; `refusal`, which ends with 0: why nothing is
/// called.
struct LibraryMemory {
  SharedArray<double> results;
  SharedArray<std::atomic<std::size_t>> answered;
  SharedArray<char> refusal;

  void refuse(const std::string& text) {
    std::copy_n(text.data(), std::min(text.size(), refusal.size() - 1), &refusal[0]);
  }
};

/// In that process. Output of the library is not what elgen prints.
void call_library(const ForeignCalls& calls, std::size_t slot, LibraryMemory& memory) {
  const auto& [code, name, seconds] = calls.function;
  (void)::dup2(STDERR_FILENO, STDOUT_FILENO);
  ::alarm(static_cast<unsigned>(std::min<std::uint64_t>(seconds, 1U << 30U)));
  const Library library(std::filesystem::absolute(code));
  if (!library.loaded()) {
    return memory.refuse(fmt::format("{} cannot be loaded: {}", in_backticks(code), ::dlerror()));
  }
  const auto function = library.find<AnyFunction>(name);
  if (function == nullptr) {
    const std::string lacking = in_backticks(code) + " has no function ";
    return memory.refuse(lacking + in_backticks(name));
  }
  for (std::size_t k = 0; k < calls.states.size(); ++k) {
    double* const result = &memory.results[k * slot];
    std::fill_n(result, slot, std::bit_cast<double>(untouched));
    call_any(function, pointers_to(calls, calls.states[k]), result);
    ++memory.answered[0];
  }
}

Result<ForeignAnswers> ask_library(const ForeignCalls& calls) {
  constexpr std::size_t most_words = 1024;
  const std::size_t slot = calls.entries + spare_numbers;
  LibraryMemory memory{SharedArray<double>(calls.states.size() * slot),
                       SharedArray<std::atomic<std::size_t>>(1), SharedArray<char>(most_words)};
  const auto work = [&](std::size_t) { call_library(calls, slot, memory); };
  const ForkedEnding end = run_forked(1, work, [] {});
  const std::string refusal = &memory.refusal[0];
  if (!refusal.empty()) return Diagnostic{Code::E716, {}, refusal};
  ForeignAnswers answers;
  for (std::size_t k = 0; k < memory.answered[0]; ++k) {
    answers.values.push_back(written(&memory.results[k * slot], slot));
  }
  if (answers.values.size() < calls.states.size()) {
    answers.failure = how_it_ended(calls, end.ending, end.status);
  }
  return answers;
}

/// {"function": "forward_dynamics", "p": {"M": 1.0}, "q": [0.1], "v": [0.2]}: doubles read back as
/// they are.
std::string request_line(const ForeignCalls& calls, const Arguments<double>& state) {
  constexpr int digits_of_double = 17;
  const auto exact = map_leaves([](double x) { return cln::cl_R(exact_value(x)); }, state);
  return fmt::format("{{\"function\": {}, {}}}\n", nlohmann::json(calls.function.name).dump(),
                     state_json(calls.model, exact, calls.arguments, digits_of_double));
}

/// Whole lines: a process that was ended may have begun one.
ForeignAnswers read_answers(const ForeignCalls& calls, const ProcessResult& process) {
  ForeignAnswers answers{{}, {}, plain_text(process.errors)};
  std::string_view rest = process.output;
  while (!rest.empty() && answers.values.size() < calls.states.size()) {
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos && !process.succeeded()) break;
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    std::optional<std::vector<double>> numbers = numbers_in(line);
    if (!numbers) {
      answers.failure = fmt::format("answers {}, which is no list of numbers", in_backticks(line));
      return answers;
    }
    answers.values.push_back(std::move(*numbers));
  }
  if (answers.values.size() == calls.states.size()) return answers;
  answers.failure =
      process.succeeded() ? "ends early" : how_it_ended(calls, process.ending, process.status);
  return answers;
}

Result<ForeignAnswers> ask_command(const ForeignCalls& calls) {
  constexpr std::size_t bytes_of_number = 64;
  std::string lines;
  for (const Arguments<double>& state : calls.states) lines += request_line(calls, state);
  const std::size_t most = calls.states.size() * (calls.entries + spare_numbers) * bytes_of_number;
  const ForeignFunction& function = calls.function;
  const ProcessResult process =
      run_apart(words_of_command(function.code), function.seconds, most, lines);
  if (process.ending != Ending::not_started) return read_answers(calls, process);
  return Diagnostic{Code::E716,
                    {},
                    in_backticks(function.code) + " is no file, and no command that could be run"};
}

}  // namespace

Result<ForeignAnswers> call_foreign(const ForeignFunction& function, const Model& model,
                                    const OutputRequest& output,
                                    const std::vector<Arguments<double>>& states) {
  const ForeignCalls calls{function, model, states, arguments_of(model, {.kind = output.kind}),
                           std::size_t{output.rows} * output.columns};
  std::error_code error;
  const bool is_file = std::filesystem::is_regular_file(function.code, error);
  return is_file ? ask_library(calls) : ask_command(calls);
}

}  // namespace elgen
