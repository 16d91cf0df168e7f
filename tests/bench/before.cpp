// before ROUNDS [any]: times the functions of two emitted headers in turn. Prints "FUNCTION
// NANOSECONDS_BEFORE NANOSECONDS_NOW", the minima of all rounds, or "FUNCTION - REASON" if the two
// versions of a function cannot be compared. With `any` the results may differ in size.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "side.hpp"
#include "timing.hpp"

namespace {

using bench::Timed;

/// Nanoseconds; 50 microseconds are much longer than a clock reading and shorter than a time slice.
constexpr double length_of_repetition = 5e4;

/// The number of calls: a multiple of state_count, so that every state occurs equally often.
int calls_of(const Timed& function) {
  const double visit =
      bench::state_count * bench::minima({function.repeat}, bench::state_count, 3)[0];
  return bench::state_count * std::max(1, static_cast<int>(length_of_repetition / visit));
}

const Timed* find(const std::vector<Timed>& functions, const std::string& name) {
  const auto found = std::find_if(functions.begin(), functions.end(),
                                  [&](const Timed& function) { return function.name == name; });
  return found == functions.end() ? nullptr : &*found;
}

void print(const Timed& before, const Timed& now, int rounds) {
  const std::vector<double> ns =
      bench::minima({before.repeat, now.repeat}, std::max(calls_of(before), calls_of(now)), rounds);
  std::printf("%s %.3f %.3f\n", before.name.c_str(), ns[0], ns[1]);
}

}  // namespace

int main(int count, char** words) {
  if (count < 2) return 2;
  const int rounds = std::atoi(words[1]);
  const bool may_differ = count > 2;
  const std::vector<Timed> all = bench::now();
  const std::vector<Timed> all_before = bench::before();
  for (const Timed& before : all_before) {
    const Timed* now = find(all, before.name);
    if (now == nullptr) {
      std::printf("%s - is there before only\n", before.name.c_str());
    } else if (now->result_size != before.result_size && !may_differ) {
      std::printf("%s - has another result now\n", before.name.c_str());
    } else if (now->has_operations || before.has_operations) {
      print(before, *now, rounds);
    }
  }
  for (const Timed& now : all) {
    if (find(all_before, now.name) == nullptr)
      std::printf("%s - is there now only\n", now.name.c_str());
  }
}
