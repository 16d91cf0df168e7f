// Sentences of dimensions.
#include "tradeoff/sentences.hpp"

#include <catch2/catch.hpp>

#include "tradeoff/tables.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("a dimension is judged by pairs of rows that differ in nothing else") {
  CHECK(sentences_of(sample_table()) ==
        std::vector<std::string>{
            "scalar: float is up to 2 times as fast as double; float has up to 1e+09 times the "
            "error of double",
            "batch: packs is up to 10 times as fast as 1; packs has up to 2 times the error of 1"});
}

TEST_CASE("where quartiles overlap the times are noise") {
  CHECK(sentences_of({.dimensions = {"form"},
                      .rows = {row_of({"closed"}, 10, 1), row_of({"recursive"}, 10.5, 1)}}) ==
        std::vector<std::string>{"form: what it does to speed is noise; errors stay"});
}

TEST_CASE("errors of 0 and infinite ones have no ratio") {
  CHECK(sentences_of(
            {.dimensions = {"x"}, .rows = {row_of({"a"}, 1, 0), row_of({"b"}, 2, INFINITY)}}) ==
        std::vector<std::string>{"x: a is up to 2 times as fast as b; errors stay"});
}
