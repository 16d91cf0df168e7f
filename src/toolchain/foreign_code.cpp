// foreign_code: calls functions in a user's library or command. A library is called in a forked
// process, whose results are in memory that both processes share, so that results before a crash
// are kept. Each result has spare numbers before and after it, which show how many numbers were
// written, and at which place. The library may write anywhere in this memory, so everything that is
// read from it is checked.
#include "elgen/foreign_code.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include "base/json.hpp"
#include "elgen/wording.hpp"
#include "emit/interface/code_interface.hpp"
#include "model/requests.hpp"
#include "model/state_text.hpp"
#include "numbers/exact_number.hpp"
#include "toolchain/forked.hpp"
#include "toolchain/process.hpp"
#include "toolchain/stream.hpp"
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
  std::size_t entries;  ///< largest number of entries of an answer
};

/// A NaN that no computation produces; it marks numbers that were not written.
constexpr std::uint64_t untouched = 0x7ff8'dead'0bad'c0deU;
/// Numbers before and after each result. A function with a result of another size writes there and
/// not into other results.
constexpr std::size_t spare_numbers = 64;
constexpr std::size_t most_arguments = 10;  ///< the number of kinds of leaves

std::string how_it_ended(const ForeignCalls& calls, Ending ending, int status) {
  const bool is_late = status == 128 + SIGXCPU;
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

/// Calls the function with as many pointers as it has arguments; the fewest are two, parameters and
/// q.
template <std::size_t count = 2>
void call_any(AnyFunction function, const Pointers& arguments, double* result) {
  if constexpr (count <= most_arguments) {
    if (arguments.size() != count) return call_any<count + 1>(function, arguments, result);
    call_with(function, arguments, result, std::make_index_sequence<count>());
  }
}

bool is_touched(double x) { return std::bit_cast<std::uint64_t>(x) != untouched; }

/// The numbers from `first` up to the last one that was written.
std::vector<double> written_numbers(const double* first, std::size_t count) {
  std::vector<double> numbers(first, first + count);
  numbers.erase(std::find_if(numbers.rbegin(), numbers.rend(), is_touched).base(), numbers.end());
  return numbers;
}

/// Memory into which the child process writes. Each result has a slot with spare numbers around it.
/// `refusal`: why nothing was called, a text that ends with 0.
struct LibraryMemory {
  SharedArray<double> results;
  SharedArray<std::atomic<std::size_t>> answered;
  SharedArray<char> refusal;
  Stream words;  ///< what the library prints

  void refuse(const std::string& text) {
    std::copy_n(text.data(), std::min(text.size(), refusal.size() - 1), &refusal[0]);
  }
};

/// Calls the library at all states, in the child process. Redirects its output, so that it does not
/// mix with elgen's. The parent enforces the time limit, because the library may ignore signals.
void call_library(const ForeignCalls& calls, std::size_t slot, LibraryMemory& memory) {
  const auto& [code, name, seconds] = calls.function;
  for (const int output : {STDOUT_FILENO, STDERR_FILENO}) {
    (void)::dup2(memory.words.write_end().number(), output);
  }
  const Library library(std::filesystem::absolute(code));
  if (!library.loaded()) {
    return memory.refuse(fmt::format("{} cannot be loaded: {}", in_backticks(code), ::dlerror()));
  }
  const auto function = library.find<AnyFunction>(name);
  if (function == nullptr) {
    const std::string error = in_backticks(code) + " has no function ";
    return memory.refuse(error + in_backticks(name));
  }
  for (std::size_t k = 0; k < calls.states.size(); ++k) {
    double* const result = &memory.results[k * slot + spare_numbers];
    call_any(function, pointers_to(calls, calls.states[k]), result);
    ++memory.answered[0];
  }
}

/// The results of the calls that returned. Numbers before a result are a failure, even if the call
/// that did not return has written them.
ForeignAnswers results_of(const LibraryMemory& memory, std::size_t slot, std::size_t answered) {
  ForeignAnswers answers;
  for (std::size_t first = 0; first < memory.results.size(); first += slot) {
    const double* const room = &memory.results[first];
    if (std::any_of(room, room + spare_numbers, is_touched)) {
      answers.failure = "writes before its result";
      break;
    }
    if (answers.values.size() == answered) break;
    answers.values.push_back(written_numbers(room + spare_numbers, slot - spare_numbers));
  }
  return answers;
}

Result<ForeignAnswers> run_library(const ForeignCalls& calls) {
  constexpr std::size_t most_words = 1024;
  const std::size_t count = calls.states.size();
  const std::size_t slot = spare_numbers + calls.entries + spare_numbers;
  LibraryMemory memory{SharedArray<double>(count * slot), SharedArray<std::atomic<std::size_t>>(1),
                       SharedArray<char>(most_words), Stream(max_message_bytes)};
  if (!memory.words.is_open()) return Diagnostic{Code::E716, {}, "no pipe can be opened"};
  std::fill_n(&memory.results[0], memory.results.size(), std::bit_cast<double>(untouched));
  const auto work = [&](std::size_t) { call_library(calls, slot, memory); };
  const auto listen = [&] { memory.words.drain(); };
  const ForkedEnding end = run_forked(1, work, listen, calls.function.seconds);
  listen();
  const std::size_t answered = std::min(memory.answered[0].load(), count);
  const char* const refusal = &memory.refusal[0];
  if (answered == 0 && end.succeeded() && *refusal != '\0') {
    return Diagnostic{Code::E716, {}, std::string(refusal, ::strnlen(refusal, most_words))};
  }
  ForeignAnswers answers = results_of(memory, slot, answered);
  if (answers.failure.empty() && (answered < count || !end.succeeded())) {
    answers.failure = how_it_ended(calls, end.ending, end.status);
  }
  answers.error_output = quoted_lines(memory.words.take());
  return answers;
}

/// {"function": "forward_dynamics", "p": {"M": 1.0}, "q": [0.1], "v": [0.2]} and a line end. With
/// 17 digits every double is read exactly.
std::string request_line(const ForeignCalls& calls, const Arguments<double>& state) {
  constexpr int digits_of_double = 17;
  const auto exact = map_leaves([](double x) { return cln::cl_R(exact_value(x)); }, state);
  return fmt::format("{{\"function\": {}, {}}}\n", Json(calls.function.name).dump(),
                     state_json(calls.model, exact, calls.arguments, digits_of_double));
}

/// Reads the answers, but no incomplete last line of a process that was killed.
ForeignAnswers read_answers(const ForeignCalls& calls, const ProcessResult& process) {
  ForeignAnswers answers{{}, {}, quoted_lines(process.errors)};
  std::string_view rest = process.output;
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos && !process.succeeded()) break;
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    if (answers.values.size() == calls.states.size()) {
      answers.failure = fmt::format("writes {} beyond its last answer", in_backticks(line));
      return answers;
    }
    std::optional<std::vector<double>> numbers = numbers_in(line);
    if (!numbers) {
      answers.failure = fmt::format("answers {}, which is no list of numbers", in_backticks(line));
      return answers;
    }
    answers.values.push_back(std::move(*numbers));
  }
  if (!process.succeeded()) {
    answers.failure = how_it_ended(calls, process.ending, process.status);
  } else if (answers.values.size() < calls.states.size()) {
    answers.failure = "ends early";
  }
  return answers;
}

Result<ForeignAnswers> run_command(const ForeignCalls& calls) {
  constexpr std::size_t bytes_of_number = 64;
  std::string lines;
  for (const Arguments<double>& state : calls.states) lines += request_line(calls, state);
  const std::size_t most = calls.states.size() * (calls.entries + spare_numbers) * bytes_of_number;
  const ForeignFunction& function = calls.function;
  const ProcessResult process =
      run_with_input(words_of_command(function.code), function.seconds, most, lines);
  if (process.ending != Ending::not_started) return read_answers(calls, process);
  return Diagnostic{
      Code::E716,
      {},
      in_backticks(function.code) + " is neither a file nor a command that could be run"};
}

}  // namespace

Result<ForeignAnswers> call_foreign(const ForeignFunction& function, const Model& model,
                                    const OutputRequest& output,
                                    const std::vector<Arguments<double>>& states) {
  const std::size_t fields = output_row(output.kind).fields.size();
  const ForeignCalls calls{function, model, states,
                           arguments_of(model, {.kind = output.kind, .user = output.user}),
                           first_entry_of(model, output, fields)};
  std::error_code error;
  const bool is_file = std::filesystem::is_regular_file(function.code, error);
  return is_file ? run_library(calls) : run_command(calls);
}

}  // namespace elgen
