// library_names: what a header cannot have as its namespace.
#include "emit/text/library_names.hpp"

#include <catch2/catch.hpp>

using elgen::is_library_name;

TEST_CASE("functions and types that the C library declares") {
  for (const char* name :
       {"abs", "system", "yn", "roundf", "remainderl", "clock_t", "main", "read", "link", "pipe"}) {
    INFO(name);
    CHECK(is_library_name(name));
  }
  for (const char* name : {"cart_pole", "a", "pendulum", "surf", "f", "zzz", "linkf"}) {
    INFO(name);
    CHECK_FALSE(is_library_name(name));
  }
}
