// The worst of many: whatever the order, equal figures by their states.
#include "verify/screening/worst_figures.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace elgen;

TEST_CASE("the larger figure is worse, of equal ones that of the earlier state") {
  CHECK(is_worse({2, 3.0}, {1, 2.0}));
  CHECK(is_worse({1, 2.0}, {2, 2.0}));
  CHECK_FALSE(is_worse({2, 2.0}, {2, 2.0}));
}

TEST_CASE("the worst are the same in every order") {
  std::vector<ScreenedFigure> figures;
  for (std::uint64_t i = 0; i < 100; ++i) figures.push_back({i, static_cast<double>(i * 37 % 10)});
  const auto worst_of = [](const std::vector<ScreenedFigure>& all) {
    WorstFigures worst(12);
    for (const ScreenedFigure& figure : all) worst.add(figure);
    return worst.sorted();
  };
  const std::vector<ScreenedFigure> worst = worst_of(figures);
  REQUIRE(worst.size() == 12);
  CHECK(worst.front() == ScreenedFigure{7, 9.0});
  CHECK(worst[10].figure == 8.0);
  std::reverse(figures.begin(), figures.end());
  CHECK(worst_of(figures) == worst);
  CHECK(WorstFigures(3).sorted().empty());
}
