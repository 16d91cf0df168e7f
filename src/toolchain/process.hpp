// Runs another program without a shell, so that spaces and quotes in paths mean nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace elgen {

enum class Ending : unsigned char {
  not_started,  ///< no such program, or it may not be run
  exited,
  signalled,    ///< a crash, or somebody ended it
  out_of_time,  ///< ended, with all the processes it started
  interrupted,  ///< likewise: a signal asks this process to end, and waits
};

/// Seconds that stand for no limit: 34 years.
inline constexpr std::uint64_t longest_run = 1U << 30U;
/// Bytes that are kept of another program's messages.
inline constexpr std::size_t most_said = 1U << 14U;

struct ProcessResult {
  Ending ending = Ending::not_started;
  int status = -1;          ///< exit status; 128 + signal where a signal ended it
  std::string output = {};  ///< what was written to stdout, first part
  std::string errors = {};  ///< to stderr, first 16 KiB; empty where both are one

  [[nodiscard]] bool succeeded() const { return ending == Ending::exited && status == 0; }
};

/// Runs `command` (looked up in $PATH) with no input, for `seconds` at most. `output` has the first
/// 16 KiB of stdout and stderr, in order. `temporary` is its $TMPDIR, which has what it leaves
/// there where it is ended; empty: ours.
[[nodiscard]] ProcessResult run(const std::vector<std::string>& command, std::uint64_t seconds,
                                const std::string& temporary = {});

/// The same with stdout and stderr apart: the first `most_output` bytes of stdout. `input` is all
/// that its stdin has.
[[nodiscard]] ProcessResult run_apart(const std::vector<std::string>& command,
                                      std::uint64_t seconds, std::size_t most_output,
                                      std::string_view input = {});

/// The words between blanks: what a shell without quotes makes of a command.
[[nodiscard]] std::vector<std::string> words_of_command(const std::string& text);

/// "could not be run", "was ended by signal 11 (Segmentation fault)", "exits 1", "has not ended
/// within 60 s"
[[nodiscard]] std::string ending_text(Ending ending, int status, std::uint64_t seconds = 0);

/// All numbers of a line, NaN and infinities among them, between blanks, commas and brackets; none
/// where it holds something else.
[[nodiscard]] std::optional<std::vector<double>> numbers_in(std::string_view line);

/// The words of another program, made fit for a message: without escape sequences and control
/// characters other than line ends; what is longer than 4000 bytes is cut, and so is what is not
/// UTF-8.
[[nodiscard]] std::string plain_text(std::string_view text);

/// The same behind a colon, each line indented so that none looks like ours: ":\n    Traceback".
/// Empty for a text without lines.
[[nodiscard]] std::string quoted_lines(std::string_view text);

}  // namespace elgen
