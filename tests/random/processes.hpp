// Long searches: the numbers of a range are distributed to processes.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <thread>

namespace elgen::test {

struct SearchRange {
  std::uint64_t first = 0;
  std::uint64_t count = 1000;
  std::uint64_t processes = std::max(1U, std::thread::hardware_concurrency());
};

/// The range of the arguments [COUNT [FIRST [PROCESSES]]]. For the unit "SEED" absent arguments are
/// $ELGEN_SEEDS, $ELGEN_FIRST_SEED and $ELGEN_PROCESSES, or else 1000, `first` and the number of
/// cores.
inline SearchRange read_range(int argc, char** argv, const std::string& unit,
                              std::uint64_t first = 0) {
  const auto number_from = [&](int index, const std::string& variable, std::uint64_t otherwise) {
    const char* text = index < argc ? argv[index] : std::getenv(variable.c_str());
    return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
  };
  SearchRange range;
  range.count = number_from(1, "ELGEN_" + unit + "S", range.count);
  range.first = number_from(2, "ELGEN_FIRST_" + unit, first);
  range.processes = number_from(3, "ELGEN_PROCESSES", range.processes);
  return range;
}

/// Calls `succeeds(remainder)` in one process for each remainder modulo the number of processes.
/// The exit code is 1 if one call returned false.
template <class Search>
int run_in_processes(const SearchRange& range, const Search& succeeds) {
  for (std::uint64_t k = 0; k < range.processes; ++k) {
    if (fork() == 0) _exit(succeeds(k) ? 0 : 1);
  }
  int worst = 0;
  int status = 0;
  while (wait(&status) > 0) {
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) worst = 1;
  }
  return worst;
}

}  // namespace elgen::test
