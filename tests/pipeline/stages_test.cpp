// A stage runs once, after the stages it needs, and its faults become diagnostics.
#include "pipeline/stages.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

namespace elgen::test {

namespace {

struct Number {
  int value;
};

std::string dump(const Number& number) { return std::to_string(number.value); }

Result<Number> one() { return Number{1}; }

}  // namespace

TEST_CASE("a stage runs when it is first needed, and only then") {
  PipelineOptions options;
  options.dump = Goal::check;
  StageRunner run(options);
  int count = 0;
  const auto add = [&count](const Number& number) {
    ++count;
    return Number{number.value + 1};
  };
  Stage<Number> first(run, Goal::parse, std::tie(), one);
  Stage<Number> second(run, Goal::check, std::tie(first), add);
  CHECK(count == 0);
  for (int i = 0; i < 2; ++i) REQUIRE(second.get() != nullptr);
  CHECK(second.product->value == 2);
  CHECK(count == 1);
  CHECK(run.dump_text == "2");
  REQUIRE(run.times.size() == 2);
  CHECK(run.times[1].stage == "check");
}

TEST_CASE("a goal runs its stage") {
  const PipelineOptions options;
  StageRunner run(options);
  Stage<Number> first(run, Goal::parse, std::tie(), one);
  Stage<Number> second(run, Goal::check, std::tie(first),
                       [](const Number& number) { return number; });
  run.run_through(Goal::check);
  CHECK(second.product);
}

TEST_CASE("a stage with a given product does not run") {
  const PipelineOptions options;
  StageRunner run(options);
  Stage<Number> first(run, Goal::parse, std::tie(), one);
  first.set({7});
  REQUIRE(first.get() != nullptr);
  CHECK(first.get()->value == 7);
  CHECK(run.times.empty());
}

TEST_CASE("a stage may take the limits as its last argument") {
  PipelineOptions options;
  options.limits.seconds = 5;
  StageRunner run(options);
  Stage<Number> first(run, Goal::parse, std::tie(), one);
  Stage<Number> second(run, Goal::check, std::tie(first),
                       [](const Number& number, const Limits& limits) {
                         return Number{number.value + static_cast<int>(limits.seconds)};
                       });
  REQUIRE(second.get() != nullptr);
  CHECK(second.product->value == 6);
}

TEST_CASE("an exception of a stage is reported with the stage's name and ends the run") {
  const PipelineOptions options;
  StageRunner run(options);
  const auto fail = []() -> Result<Number> { throw std::logic_error("a wheel came off"); };
  Stage<Number> thrower(run, Goal::parse, std::tie(), fail);
  Stage<Number> later(run, Goal::check, std::tie(), one);
  CHECK(thrower.get() == nullptr);
  REQUIRE(run.diagnostics.size() == 1);
  CHECK(run.diagnostics.front().code == Code::E912);
  CHECK(run.diagnostics.front().message == "internal error in `parse`: a wheel came off");
  CHECK(later.get() == nullptr);
}

TEST_CASE("numbers too large for CLN are no internal error") {
  const PipelineOptions options;
  StageRunner run(options);
  const auto fail = []() -> Result<Number> {
    throw cln::runtime_exception("Out of virtual memory.");
  };
  Stage<Number> thrower(run, Goal::parse, std::tie(), fail);
  CHECK(thrower.get() == nullptr);
  REQUIRE(run.diagnostics.size() == 1);
  CHECK(run.diagnostics.front().code == Code::E910);
}

TEST_CASE("exhausted memory is no internal error") {
  const PipelineOptions options;
  StageRunner run(options);
  const auto fail = []() -> Result<Number> { throw std::bad_alloc(); };
  Stage<Number> stage(run, Goal::parse, std::tie(), fail);
  CHECK_THROWS_AS(stage.get(), std::bad_alloc);
}

}  // namespace elgen::test
