#include "oracle/schedule.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "elgen/references.hpp"
#include "oracle/samples.hpp"

using namespace elgen;
using namespace elgen::oracle;
using namespace elgen::test;

namespace {

void check_operands_first(const Model& model, const Schedule& schedule) {
  for (std::size_t slot = 0; slot < schedule.order.size(); ++slot) {
    for (const ExpressionId reference : references(model, schedule.order[slot])) {
      CHECK(schedule.slots[reference] < slot);
    }
  }
}

}  // namespace

TEST_CASE("operands, definitions and points precede their users, each once") {
  const ModelBuilder b = rotating_hoop("W*t");
  const ExpressionId root = b.model.points[0].at[0];
  const Schedule schedule = make_schedule(b.model, {{root, 0}, {root, 0}});
  check_operands_first(b.model, schedule);
  CHECK(schedule.order.back() == root);
  std::vector<ExpressionId> sorted = schedule.order;
  std::sort(sorted.begin(), sorted.end());
  CHECK(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());
}

TEST_CASE("only what the roots need is scheduled") {
  ModelBuilder b;
  b.coordinate("x").coordinate("y");
  const ExpressionId root = b.expression("x + 1");
  b.expression("sin(y)");
  CHECK(make_schedule(b.model, {{root, 0}}).order.size() == 3);
}

TEST_CASE("time orders count the time derivatives above an expression") {
  ModelBuilder b;
  b.coordinate("x");
  const ExpressionId root = b.expression("ddt(x*ddt(x))");
  const Schedule schedule = make_schedule(b.model, {{root, 1}});
  std::vector<unsigned> of_x;
  for (std::size_t slot = 0; slot < schedule.order.size(); ++slot) {
    const Expression& e = b.model.expressions[schedule.order[slot]];
    if (e.kind == ExpressionKind::coordinate) of_x.push_back(schedule.time_orders[slot]);
  }
  std::sort(of_x.begin(), of_x.end());
  CHECK(of_x == std::vector<unsigned>{2, 3});
}

TEST_CASE("a chain of thousands of links is ordered without recursion") {
  const ModelBuilder b = chain(5000);
  const Schedule schedule = make_schedule(b.model, {{b.model.points.back().at[0], 1}});
  CHECK(schedule.order.size() > 15'000);
  CHECK(schedule.order.back() == b.model.points.back().at[0]);
}
