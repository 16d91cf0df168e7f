// A stage runs once, after what it needs, and its mistakes become diagnostics.
#include "pipeline/stages.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

namespace elgen {

namespace {

struct Number {
  int value;
};

std::string dump(const Number& number) { return std::to_string(number.value); }

Result<Number> one() { return Number{1}; }

}  // namespace

TEST_CASE("a stage runs when it is first asked for, and only then") {
  PipelineOptions options;
  options.dump_stage = "second";
  StageRunner run(options);
  Stage<Number> first;
  Stage<Number> second;
  int count = 0;
  const auto add = [&count](const Number& number) {
    ++count;
    return Result<Number>(Number{number.value + 1});
  };
  for (int i = 0; i < 2; ++i) {
    Number* needed = run.product("first", first, one);
    REQUIRE(run.product("second", second, add, needed) != nullptr);
  }
  CHECK(second.product->value == 2);
  CHECK(count == 1);
  CHECK(run.dumped == "2");
  REQUIRE(run.times.size() == 2);
  CHECK(run.times[1].stage == "second");
}

TEST_CASE("what a stage throws is said with its name, and ends the run") {
  const PipelineOptions options;
  StageRunner run(options);
  Stage<Number> thrower;
  Stage<Number> later;
  const auto fail = []() -> Result<Number> { throw std::logic_error("a wheel came off"); };
  CHECK(run.product("first", thrower, fail) == nullptr);
  REQUIRE(run.diagnostics.size() == 1);
  CHECK(run.diagnostics.front().code == Code::E912);
  CHECK(run.diagnostics.front().message == "internal error in `first`: a wheel came off");
  CHECK(run.product("later", later, one) == nullptr);
}

TEST_CASE("memory that is used up is not a mistake of ours") {
  const PipelineOptions options;
  StageRunner run(options);
  Stage<Number> stage;
  const auto fail = []() -> Result<Number> { throw std::bad_alloc(); };
  CHECK_THROWS_AS(run.product("first", stage, fail), std::bad_alloc);
}

}  // namespace elgen
