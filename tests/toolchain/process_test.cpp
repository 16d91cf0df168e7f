// Programs are run without a shell: arguments arrive as they are, output and status come back.
#include "toolchain/process.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "toolchain/temporary_directory.hpp"

namespace {

class Fixture {
 public:
  Fixture() : directory_(elgen::TemporaryDirectory::create()) { REQUIRE(directory_); }

 protected:
  [[nodiscard]] std::filesystem::path path() const { return directory_->path(); }
  [[nodiscard]] elgen::ProcessResult run(const std::vector<std::string>& command) const {
    return elgen::run(command, path() / "log");
  }

 private:
  std::optional<elgen::TemporaryDirectory> directory_;
};

}  // namespace

TEST_CASE_METHOD(Fixture, "output of both streams and the status are returned") {
  const auto result = run({"sh", "-c", "echo out; echo err >&2; exit 7"});
  CHECK(result.started);
  CHECK(result.status == 7);
  CHECK(result.output == "out\nerr\n");
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

TEST_CASE_METHOD(Fixture, "a missing program does not start") {
  CHECK_FALSE(run({"/nonexistent/program"}).started);
  CHECK_FALSE(run({}).started);
}

TEST_CASE_METHOD(Fixture, "a signal is told as 128 + its number") {
  CHECK(run({"sh", "-c", "kill -9 $$"}).status == 137);
}

TEST_CASE_METHOD(Fixture, "standard input is empty, not ours") {
  const auto result = run({"cat"});
  CHECK(result.status == 0);
  CHECK(result.output.empty());
}

TEST_CASE_METHOD(Fixture, "long output does not block") {
  const auto result = run({"sh", "-c", "yes 0123456789 | head -n 20000"});
  CHECK(result.output.size() == 20000 * 11);
}
