// process: runs another program without a shell, so that spaces and quotes in paths have no special
// meaning.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace elgen {

enum class ProcessEnding : unsigned char {
  not_started,  ///< the program does not exist or is not executable
  exited,
  signalled,    ///< by a crash, or by a signal from another process
  out_of_time,  ///< elgen killed the program and all processes of its group
  interrupted,  ///< elgen killed the program, because an interrupt of elgen is pending
};

/// In seconds: 34 years, that is, no limit.
inline constexpr std::uint64_t max_run_seconds = 1U << 30U;
/// How many bytes of another program's messages are kept.
inline constexpr std::size_t max_message_bytes = 1U << 14U;

struct ProcessResult {
  ProcessEnding ending = ProcessEnding::not_started;
  int status = -1;          ///< exit status; 128 + signal if a signal ended the program
  std::string output = {};  ///< the first bytes of stdout, up to the limit
  std::string errors = {};  ///< the first 16 KiB of stderr; empty if stderr goes to `output`

  [[nodiscard]] bool succeeded() const { return ending == ProcessEnding::exited && status == 0; }
};

/// Runs `command`, looked up in $PATH, without input, for at most `seconds`. `output` has the first
/// 16 KiB of stdout and stderr, in order. `temporary` is the program's $TMPDIR, so that files of a
/// killed program are in a known folder; if `temporary` is empty, the program has elgen's $TMPDIR.
[[nodiscard]] ProcessResult run_process(const std::vector<std::string>& command,
                                        std::uint64_t seconds, const std::string& temporary = {});

/// Like run_process(), but stdout and stderr are separate, and `output` has the first `most_output`
/// bytes of stdout. `input` is the content of stdin.
[[nodiscard]] ProcessResult run_with_input(const std::vector<std::string>& command,
                                           std::uint64_t seconds, std::size_t most_output,
                                           std::string_view input = {});

/// The words between blanks, as a shell splits a command without quotes.
[[nodiscard]] std::vector<std::string> words_of_command(const std::string& text);

/// "could not be run", "was ended by signal 11 (Segmentation fault)", "exits 1", "has not ended
/// within 60 s".
[[nodiscard]] std::string ending_text(ProcessEnding ending, int status, std::uint64_t seconds = 0);

/// The numbers of a line, including NaN and infinities, separated by blanks, commas and brackets;
/// none if the line contains other text.
[[nodiscard]] std::optional<std::vector<double>> parse_numbers(std::string_view line);

/// The output of another program, safe for use in a message: without escape sequences and control
/// characters except line ends; cut after 4000 bytes, and at the first byte that is not UTF-8.
[[nodiscard]] std::string sanitize_output(std::string_view text);

/// sanitize_output() after a colon, with each line indented, so that no line looks like a message
/// of elgen: ":\n    Traceback". "" for an empty text.
[[nodiscard]] std::string indent_output(std::string_view text);

}  // namespace elgen
