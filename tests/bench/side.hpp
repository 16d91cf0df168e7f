// Functions of two emitted headers, before and now; each header is compiled separately.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace bench {

struct Timed {
  std::string name;
  std::size_t result_size;
  bool has_operations;
  std::function<void(int)> repeat;
};

std::vector<Timed> before();
std::vector<Timed> now();

}  // namespace bench
