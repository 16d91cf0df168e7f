#include <catch2/catch.hpp>
#include <limits>

#include "choose/chosen.hpp"
#include "render/small_sheet.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;
using elgen::testing::has;

TEST_CASE("the page in the model language") {
  const Chosen c = chosen(cart_pole_text());
  const std::string page = text_page(c.checked.model, c.checked.scene, c.choice.program);
  CHECK(has(page, "  q = (x, theta)\n  v = dq/dt, a = dv/dt\n"));
  CHECK(has(page, "\nmass_matrix\n  mass_matrix[1,1] = M + m\n"));
  CHECK(has(page, "  potential_energy = m*l*g*cos(theta)\n"));
  CHECK_FALSE(has(page, "drift"));
  CHECK(has(text_page(c.checked.model, c.checked.scene, c.choice.program, {true}),
            "  drift[2] = 0\n"));
}

TEST_CASE("costs of both forms, the emitted one marked") {
  FormCosts row{.function = "bias", .recursive = {.add = 2}, .closed = OperationCounts{.mul = 1}};
  row.chosen = Form::closed;
  row.closed_loss = 0;
  row.recursive_loss = 1e3;
  CHECK(has(cost_page({row}),
            "bias      closed          0      1     0     0      0     0       1       0  emitted\n"
            "bias      recursive       2      0     0     0      0     0       2     3.0\n"));
  row.recursive_loss = std::numeric_limits<double>::infinity();
  CHECK(has(cost_page({row}), "     all\n"));
  row.is_asked_for = true;
  CHECK(has(cost_page({row}), "  asked for\n"));
}
