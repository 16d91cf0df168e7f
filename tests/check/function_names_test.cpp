// Every kind of function has its names here.
#include "check/names/function_names.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

namespace elgen {

TEST_CASE("functions of each table are known, and each once") {
  std::vector<std::string> names = function_names();
  for (const char* name : {"dot", "dist2", "sqrt", "sin", "atan2"}) {
    CHECK(std::count(names.begin(), names.end(), name) == 1);
  }
  std::sort(names.begin(), names.end());
  CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
}

}  // namespace elgen
