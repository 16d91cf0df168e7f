#include "pages/replay.hpp"

#include <catch2/catch.hpp>

namespace elgen::test {

namespace {

void run_commands(const Fence& fence, const Runner& run) {
  for (const std::string& line : split_lines(fence.text)) {
    CHECK(failure_of(run(line)) == "");
  }
}

void run_console(const Fence& fence, const Runner& run) {
  for (const Exchange& exchange : exchanges(fence.text)) {
    const std::string printed = run("{ " + exchange.command + "\n} 2>&1").output;
    INFO("$ " << exchange.command << "\n" << printed << "--- expected\n" << exchange.output);
    CHECK(agrees(exchange.output, printed));
  }
}

void check_excerpt(const Fence& fence, const std::filesystem::path& folder) {
  const std::string text = read_text(folder / fence.file);
  INFO(fence.text << "--- in\n" << text);
  CHECK(agrees("…\n" + fence.text + "…\n", text));
}

}  // namespace

void replay(const Fence& fence, const std::filesystem::path& folder, const Runner& run) {
  if (fence.kind == FenceKind::commands) run_commands(fence, run);
  if (fence.kind == FenceKind::console) run_console(fence, run);
  if (fence.kind == FenceKind::excerpt) check_excerpt(fence, folder);
  if (fence.kind == FenceKind::file) write_text(folder / fence.file, fence.text);
}

}  // namespace elgen::test
