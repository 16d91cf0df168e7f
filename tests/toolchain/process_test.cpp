// Programs run without a shell: arguments arrive unchanged, and output and status are returned.
// Output shown to users cannot control or flood a terminal.
#include "toolchain/process.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <fstream>
#include <limits>

#include "support/text.hpp"
#include "toolchain/environment.hpp"
#include "toolchain/workshop.hpp"

using elgen::sanitize_output;
using elgen::test::mentions;

namespace {

using elgen::ProcessEnding;

volatile std::sig_atomic_t interrupts = 0;

void count_interrupt(int /*signal*/) { interrupts = interrupts + 1; }

/// True if the process has ended but its parent has not waited for it yet.
bool is_zombie(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return mentions(text, ") Z ");
}

/// True if a killed process is gone or a zombie within a second.
bool ends(pid_t process) {
  const auto has_ended = [process] { return kill(process, 0) != 0 || is_zombie(process); };
  for (int i = 0; i < 1000 && !has_ended(); ++i) usleep(1000);
  return has_ended();
}

class Fixture {
 public:
  Fixture() : directory_(elgen::TemporaryDirectory::create()) { REQUIRE(directory_); }

 protected:
  [[nodiscard]] std::filesystem::path path() const { return directory_->path(); }
  [[nodiscard]] elgen::ProcessResult run(const std::vector<std::string>& command) const {
    return elgen::run_process(command, 60);
  }

 private:
  std::optional<elgen::TemporaryDirectory> directory_;
};

}  // namespace

TEST_CASE_METHOD(Fixture, "output of both streams and the status are returned") {
  const auto result = run({"sh", "-c", "echo out; echo err >&2; exit 7"});
  CHECK(result.ending == ProcessEnding::exited);
  CHECK_FALSE(result.succeeded());
  CHECK(result.status == 7);
  CHECK(result.output == "out\nerr\n");
}

TEST_CASE("stdin contains the given text, however long") {
  const std::string text(1U << 20U, 'x');
  const auto result = elgen::run_with_input({"wc", "-c"}, 60, 100, text);
  CHECK(result.status == 0);
  CHECK(result.output == "1048576\n");
  CHECK(elgen::run_with_input({"cat"}, 60, 100).output.empty());
}

TEST_CASE("numbers of an answer are read exactly, beyond the range of double as infinity or 0") {
  CHECK(elgen::parse_numbers("[[0.1, -2e-3],\t[5, 1e-310]]") ==
        std::vector<double>{0.1, -2e-3, 5, 1e-310});
  CHECK(elgen::parse_numbers("1e400 -1e400 1e-400") == std::vector<double>{HUGE_VAL, -HUGE_VAL, 0});
  CHECK(elgen::parse_numbers("")->empty());
  CHECK_FALSE(elgen::parse_numbers("[1, two]"));
  CHECK_FALSE(elgen::parse_numbers("[1.2.3]"));
  CHECK_FALSE(elgen::parse_numbers(std::string("1 \0 2", 5)));
}

TEST_CASE("the end of a process is described by its status or its signal") {
  CHECK(elgen::ending_text(ProcessEnding::exited, 3) == "exits 3");
  CHECK(elgen::ending_text(ProcessEnding::signalled, 128 + SIGABRT) ==
        "was ended by signal 6 (Aborted)");
  CHECK(elgen::ending_text(ProcessEnding::signalled, 128 + SIGXFSZ) ==
        "was ended by signal 25 (File size limit exceeded)");
  CHECK(elgen::ending_text(ProcessEnding::signalled, 128 + 40) ==
        "was ended by signal 40 (Real-time signal 6)");
  CHECK(elgen::words_of_command(" python3  mine.py ") ==
        std::vector<std::string>{"python3", "mine.py"});
}

TEST_CASE_METHOD(Fixture, "no shell reads the arguments") {
  const auto result = run({"printf", "%s", "a b; $HOME 'c' \"d\""});
  CHECK(result.status == 0);
  CHECK(result.output == "a b; $HOME 'c' \"d\"");
}

TEST_CASE_METHOD(Fixture, "a program with spaces in its path runs") {
  const auto script = path() / "with space" / "say it";
  std::filesystem::create_directory(script.parent_path());
  std::ofstream(script) << "#!/bin/sh\necho here\n";
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  CHECK(run({script.string()}).output == "here\n");
}

TEST_CASE_METHOD(Fixture, "a program has temporary files of its own and our environment") {
  const ScopedVariable ours("ELGEN_TEST", "here");
  const ScopedVariable temporary("TMPDIR", "/elsewhere");
  const std::vector<std::string> command{"sh", "-c", "echo $ELGEN_TEST $TMPDIR"};
  CHECK(run(command).output == "here /elsewhere\n");
  CHECK(elgen::run_process(command, 60, "/tmp/x y").output == "here /tmp/x y\n");
}

TEST_CASE_METHOD(Fixture, "a missing program does not start") {
  CHECK(run({"/nonexistent/program"}).ending == ProcessEnding::not_started);
  CHECK(run({}).ending == ProcessEnding::not_started);
}

TEST_CASE_METHOD(Fixture, "a signal is reported as 128 + its number") {
  const auto result = run({"sh", "-c", "kill -9 $$"});
  CHECK(result.ending == ProcessEnding::signalled);
  CHECK(result.status == 137);
}

TEST_CASE_METHOD(Fixture, "standard input is empty, not ours") {
  const auto result = run({"cat"});
  CHECK(result.status == 0);
  CHECK(result.output.empty());
}

TEST_CASE_METHOD(Fixture, "long output does not block, and its beginning is kept") {
  const auto result = run({"sh", "-c", "yes 0123456789 | head -n 200000"});
  CHECK(result.succeeded());
  CHECK(result.output.size() == 16384);
  CHECK(result.output.substr(0, 11) == "0123456789\n");
}

TEST_CASE_METHOD(Fixture, "a program that takes too long is ended with its children") {
  const auto started = path() / "started";
  const std::string script =
      "(sleep 100 & echo $! > '" + started.string() + "'; wait) & wait; sleep 100";
  const auto begin = std::chrono::steady_clock::now();
  const auto result = elgen::run_process({"sh", "-c", script}, 1);
  CHECK(result.ending == ProcessEnding::out_of_time);
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(20));
  pid_t inner = 0;
  std::ifstream(started) >> inner;
  REQUIRE(inner > 0);
  CHECK(ends(inner));
}

TEST_CASE_METHOD(Fixture, "children that a program leaves running are ended") {
  const auto result = run({"sh", "-c", "sleep 22222 & echo $!; exit 3"});
  CHECK(result.status == 3);
  const pid_t left = std::stoi(result.output);
  REQUIRE(left > 0);
  CHECK(ends(left));
}

TEST_CASE("a program with endless output is ended at the time limit") {
  const auto begin = std::chrono::steady_clock::now();
  CHECK(elgen::run_with_input({"yes"}, 1, 100).ending == ProcessEnding::out_of_time);
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(20));
}

TEST_CASE("numbers beyond the range of double are read as infinity or 0") {
  const auto numbers = elgen::parse_numbers("[1e400, -1e400, [1e-400, -1e310], 1e308, 1e-310]");
  const double infinite = std::numeric_limits<double>::infinity();
  REQUIRE(numbers);
  CHECK(*numbers == std::vector<double>{infinite, -infinite, 0, -infinite, 1e308, 1e-310});
  CHECK_FALSE(elgen::parse_numbers("[1e400, ready]"));
}

TEST_CASE("output of other programs is shown in indented lines") {
  CHECK(elgen::indent_output("elgen: ok\n::error::x\n") == ":\n    elgen: ok\n    ::error::x");
  CHECK(elgen::indent_output("a") == ":\n    a");
  CHECK(elgen::indent_output("").empty());
}

TEST_CASE_METHOD(Fixture, "an interrupt ends the program and is then delivered") {
  interrupts = 0;
  const auto before = std::signal(SIGTERM, count_interrupt);
  const std::string parent = std::to_string(getpid());
  const auto result = run({"sh", "-c", "kill -TERM " + parent + "; sleep 100"});
  CHECK(result.ending == ProcessEnding::interrupted);
  CHECK(interrupts == 1);
  std::signal(SIGTERM, before);
}

TEST_CASE_METHOD(Fixture, "the status is returned even if SIGCHLD is ignored") {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  CHECK(run({"sh", "-c", "exit 3"}).status == 3);
  std::signal(SIGCHLD, before);
}

TEST_CASE("escape sequences and control characters are removed") {
  CHECK(sanitize_output("a\x1b[01;31mb\x1b[K\tc\r\nd\a") == "abc\nd");
  CHECK(sanitize_output("a\x1b]8;;file://x\ab\x1b]0;title\x1b\\c") == "abc");
  CHECK(sanitize_output("a\x1b"
                        "7b\x1b") == "ab");
  CHECK(sanitize_output("a\x1b[31\nb") == "a\nb");
  CHECK(sanitize_output("a\u202eb\u200bc") == "abc");
  CHECK(sanitize_output("‘é’\n") == "‘é’\n");
}

TEST_CASE("long texts and binary data are cut off") {
  const std::string cut = sanitize_output(std::string(100'000, 'x'));
  CHECK(cut.size() < 4100);
  CHECK(mentions(cut, "…\n"));
  CHECK(sanitize_output("a\xff\xfe") == "a…\n");
}
