#include <catch2/catch.hpp>

#include "choose/chosen.hpp"
#include "render/small_sheet.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;
using elgen::testing::has;

TEST_CASE("a sheet holds what is worth reading") {
  const Chosen c = chosen(cart_pole_text());
  const Sheet page = sheet(c.checked.model, c.checked.scene, c.choice.program);
  CHECK(page.coordinates.size() == 2);
  CHECK(page.coordinates[1].symbol == "\\theta");
  CHECK(page.parameters.size() == 4);
  for (const SheetOutput& output : page.outputs) {
    CHECK(output.function != "drift");
    CHECK(output.function != "dynamics");
  }
}

TEST_CASE("zeros are shown, and long outputs left out, where that is asked for") {
  const Chosen c = chosen(cart_pole_text());
  const auto count = [&](const PageOptions& options) {
    const Sheet page = sheet(c.checked.model, c.checked.scene, c.choice.program, options);
    std::size_t equations = 0;
    for (const SheetOutput& output : page.outputs) equations += output.equations.empty() ? 0 : 1;
    return equations;
  };
  CHECK(count({true}) > count({}));
  CHECK(count({false, 2}) < count({}));
}
