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
constexpr std::uint64_t untouched_bits = 0x7ff8'dead'0bad'c0deU;
/// Numbers before and after each result. A function with a result of another size writes there and
/// not into other results.
constexpr std::size_t spare_numbers = 64;
constexpr std::size_t most_arguments = 10;  ///< the number of kinds of leaves

std::string ending_message(const ForeignCalls& calls, ProcessEnding ending, int status) {
  const bool is_late = status == 128 + SIGXCPU;
  return ending_text(is_late ? ProcessEnding::out_of_time : ending, status, calls.function.seconds);
}

Pointers leaf_pointers(const ForeignCalls& calls, const Arguments<double>& state) {
  Pointers pointers;
  for (const Opcode argument : calls.arguments) {
    const std::vector<double>* const list = leaf_list(state, argument);
    pointers.push_back(list != nullptr ? list->data() : &leaf_of(state, argument, 0));
  }
  return pointers;
}

template <std::size_t>
using Pointer = const double*;

template <std::size_t... i>
void call_with_pointers(AnyFunction function, const Pointers& arguments, double* result,
                        std::index_sequence<i...> /*all*/) {
  reinterpret_cast<void (*)(Pointer<i>..., double*)>(function)(arguments[i]..., result);
}

/// Calls the function with as many pointers as it has arguments; the fewest are two, parameters and
/// q.
template <std::size_t count = 2>
void call_by_arity(AnyFunction function, const Pointers& arguments, double* result) {
  if constexpr (count <= most_arguments) {
    if (arguments.size() != count) return call_by_arity<count + 1>(function, arguments, result);
    call_with_pointers(function, arguments, result, std::make_index_sequence<count>());
  }
}

bool is_written(double x) { return std::bit_cast<std::uint64_t>(x) != untouched_bits; }

/// The numbers from `first` up to the last one that was written.
std::vector<double> written_numbers(const double* first, std::size_t count) {
  std::vector<double> numbers(first, first + count);
  numbers.erase(std::find_if(numbers.rbegin(), numbers.rend(), is_written).base(), numbers.end());
  return numbers;
}

/// Memory into which the child process writes. Each result has a slot with spare numbers around it.
/// `refusal`: the reason if nothing was called, as text that ends with 0.
struct LibraryMemory {
  SharedArray<double> results;
  SharedArray<std::atomic<std::size_t>> answered;
  SharedArray<char> refusal;
  OutputPipe output;  ///< what the library prints

  void set_refusal(const std::string& text) {
    std::copy_n(text.data(), std::min(text.size(), refusal.size() - 1), &refusal[0]);
  }
};

/// Calls the library at all states, in the child process. Text that the library prints goes into
/// `memory.output`. The parent enforces the time limit, because the library may ignore signals.
void call_library(const ForeignCalls& calls, std::size_t slot, LibraryMemory& memory) {
  const auto& [code, name, seconds] = calls.function;
  for (const int output : {STDOUT_FILENO, STDERR_FILENO}) {
    (void)::dup2(memory.output.write_end().number(), output);
  }
  const SharedLibrary library(std::filesystem::absolute(code));
  if (!library.is_loaded()) {
    return memory.set_refusal(
        fmt::format("{} cannot be loaded: {}", quote_text(code), ::dlerror()));
  }
  const auto function = library.find<AnyFunction>(name);
  if (function == nullptr) {
    const std::string error = quote_text(code) + " has no function ";
    return memory.set_refusal(error + quote_text(name));
  }
  for (std::size_t k = 0; k < calls.states.size(); ++k) {
    double* const result = &memory.results[k * slot + spare_numbers];
    call_by_arity(function, leaf_pointers(calls, calls.states[k]), result);
    ++memory.answered[0];
  }
}

/// The results of the calls that returned. A written spare number before a result is a
/// failure, even if the call that wrote the number did not return.
ForeignResults collect_answers(const LibraryMemory& memory, std::size_t slot,
                               std::size_t answered) {
  ForeignResults answers;
  for (std::size_t first = 0; first < memory.results.size(); first += slot) {
    const double* const room = &memory.results[first];
    if (std::any_of(room, room + spare_numbers, is_written)) {
      answers.failure = "writes before its result";
      break;
    }
    if (answers.values.size() == answered) break;
    answers.values.push_back(written_numbers(room + spare_numbers, slot - spare_numbers));
  }
  return answers;
}

Result<ForeignResults> run_library(const ForeignCalls& calls) {
  constexpr std::size_t most_words = 1024;
  const std::size_t count = calls.states.size();
  const std::size_t slot = spare_numbers + calls.entries + spare_numbers;
  LibraryMemory memory{SharedArray<double>(count * slot), SharedArray<std::atomic<std::size_t>>(1),
                       SharedArray<char>(most_words), OutputPipe(max_message_bytes)};
  if (!memory.output.is_open()) return Diagnostic{Code::E716, {}, "no pipe can be opened"};
  std::fill_n(&memory.results[0], memory.results.size(), std::bit_cast<double>(untouched_bits));
  const auto work = [&](std::size_t) { call_library(calls, slot, memory); };
  const auto listen = [&] { memory.output.drain(); };
  const ForkResult end = run_forked(1, work, listen, calls.function.seconds);
  listen();
  const std::size_t answered = std::min(memory.answered[0].load(), count);
  const char* const refusal = &memory.refusal[0];
  if (answered == 0 && end.succeeded() && *refusal != '\0') {
    const bool is_script = calls.function.code.ends_with(".py");
    return Diagnostic{Code::E716,
                      {},
                      std::string(refusal, ::strnlen(refusal, most_words)),
                      is_script ? "`--foreign \"python3 mine.py\"` runs a script" : ""};
  }
  ForeignResults answers = collect_answers(memory, slot, answered);
  if (answers.failure.empty() && (answered < count || !end.succeeded())) {
    answers.failure = ending_message(calls, end.ending, end.status);
  }
  answers.error_output = indent_output(memory.output.take_text());
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
ForeignResults read_answers(const ForeignCalls& calls, const ProcessResult& process) {
  ForeignResults answers{{}, {}, indent_output(process.errors)};
  std::string_view rest = process.output;
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos && !process.succeeded()) break;
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    if (answers.values.size() == calls.states.size()) {
      answers.failure = fmt::format("writes {} beyond its last answer", quote_text(line));
      return answers;
    }
    std::optional<std::vector<double>> numbers = parse_numbers(line);
    if (!numbers) {
      answers.failure = fmt::format("answers {}, which is no list of numbers", quote_text(line));
      return answers;
    }
    answers.values.push_back(std::move(*numbers));
  }
  if (!process.succeeded()) {
    answers.failure = ending_message(calls, process.ending, process.status);
  } else if (answers.values.size() < calls.states.size()) {
    answers.failure = "ends early";
  }
  return answers;
}

Result<ForeignResults> run_command(const ForeignCalls& calls) {
  constexpr std::size_t bytes_of_number = 64;
  std::string lines;
  for (const Arguments<double>& state : calls.states) lines += request_line(calls, state);
  const std::size_t most = calls.states.size() * (calls.entries + spare_numbers) * bytes_of_number;
  const ForeignFunction& function = calls.function;
  const ProcessResult process =
      run_with_input(words_of_command(function.code), function.seconds, most, lines);
  if (process.ending != ProcessEnding::not_started) return read_answers(calls, process);
  return Diagnostic{
      Code::E716,
      {},
      quote_text(function.code) + " is neither a file nor a command that could be run"};
}

}  // namespace

Result<ForeignResults> call_foreign_function(const ForeignFunction& function, const Model& model,
                                             const OutputRequest& output,
                                             const std::vector<Arguments<double>>& states) {
  const std::size_t fields = output_row(output.kind).fields.size();
  const ForeignCalls calls{function, model, states,
                           arguments_of(model, {.kind = output.kind, .user = output.user}),
                           first_entry_index(model, output, fields)};
  std::error_code error;
  const bool is_file = std::filesystem::is_regular_file(function.code, error);
  return is_file ? run_library(calls) : run_command(calls);
}

}  // namespace elgen
