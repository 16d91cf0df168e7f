// The entries of a function: their forms, rewritings that keep digits, and their instructions.
#include "choose/entries.hpp"

#include <catch2/catch.hpp>

#include "program/expression_leaves.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

struct Entries {
  explicit Entries(const Texts& texts) : program(program_of(texts)) {}

  Program program;
  Function shape = program.functions[0];
  ClosedForms forms = present(program);
  Points points = mixed_magnitude_points(program.leaves);
  ReadableEntries entries = read_entries(program, forms, 0, points);
};

}  // namespace

TEST_CASE("all entries of a function have a form") {
  const Entries e({"1 - cos(a)", "b"});
  REQUIRE(is_complete(e.entries));
  CHECK(total_length(e.entries) == e.entries[0]->length + e.entries[1]->length);
  CHECK_FALSE(is_complete({}));
  CHECK_FALSE(is_complete({e.entries[0], std::nullopt}));
}

TEST_CASE("a rewriting that keeps digits is chosen if the entry loses more than a limit") {
  Entries e({"1 - cos(a)", "b"});
  Arguments<double> point;
  point.q = {1e-8, 1e-16, 1, 1, 1};  // both entries are about 1e-16
  FormErrors text(e.program, e.shape, {point});
  e.entries = read_entries(e.program, e.forms, 0, e.points, {&text});
  CHECK(e.entries[0]->loss > 1e15);
  CHECK(e.entries[1]->loss <= 1);
  CHECK_FALSE(replace_lossy_entries(e.entries, 1e20));
  auto others = replace_lossy_entries(e.entries, tolerated_loss);
  REQUIRE(others);
  CHECK((*others)[0]->is_rewritten);
  CHECK_FALSE((*others)[1]->is_rewritten);
  CHECK(rewritten_entries(*others, 2) == std::vector<std::uint32_t>{0});
  CHECK(rewritten_entries(*others, 0).empty());
  show_computed_forms(*others, e.points);
  CHECK(texts_of((*others)[0]->readable).at(0) == "1 - cos(a)");
  CHECK(texts_of((*others)[0]->compact).at(0) == "2*sin(1/2*a)^2");
}

TEST_CASE("a rewriting is cheaper than one fraction of all terms") {
  Entries e({"b/(c - a)^2 - b/(c + a)^2 + d*a"});
  Arguments<double> point;
  point.q = {1e-8, 2, 0.7, 0.4, 1};
  FormErrors text(e.program, e.shape, {point});
  e.entries = read_entries(e.program, e.forms, 0, e.points, {&text});
  const ReadableForm& form = *e.entries[0];
  const Expressions& kept = form.precise ? *form.precise : form.compact;
  CHECK(text.loss_of(text.errors_of(kept), 0) <= tolerated_loss);
  CHECK(cost(counts_of(kept)) <= cost(count_operations(e.shape)));
}

TEST_CASE("entries lowered together share subexpressions, entries lowered one by one do not") {
  Entries e({"(a + b)*c", "(a + b)*d"});
  const Function together = lower_jointly(e.entries, e.shape, e.program, {}).function;
  CHECK(together.form == Form::closed);
  CHECK(count_operations(together).add == 1);
  const Function one_by_one = lower_separately(e.entries, e.shape, e.program);
  CHECK(count_operations(one_by_one).add == 2);
  REQUIRE(one_by_one.fields.size() == 1);
  CHECK(one_by_one.fields[0].entries.size() == 2);
}

TEST_CASE("a rewritten entry is emitted even if it costs more") {
  Entries e({"(a + b)*c", "(a + b)*d"});
  e.entries[0]->is_rewritten = true;
  e.entries[0]->compact.values = {e.entries[0]->compact.graph.leaf(Opcode::coordinate, 4)};
  const Function function = lower_jointly(e.entries, e.shape, e.program, {}).function;
  e.program.functions = {function};
  CHECK(text_of(equations(e.program, 0).entries.at(0).at(0)) == "e");
}
