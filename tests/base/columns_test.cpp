// Cells stand in columns.
#include "base/columns.hpp"

#include <catch2/catch.hpp>

TEST_CASE("a column is as wide as its widest cell, and no line ends with blanks") {
  CHECK(elgen::aligned({{"a", " 1"}, {"bcd", " 2"}, {"e", ""}}) ==
        std::vector<std::string>{"a   1", "bcd 2", "e"});
}

TEST_CASE("the last cell of a row may be longer than its column") {
  CHECK(elgen::aligned({{"a  ", "b  ", "c"}, {"d  ", "long enough"}}) ==
        std::vector<std::string>{"a  b  c", "d  long enough"});
}
