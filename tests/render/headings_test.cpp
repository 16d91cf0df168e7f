#include "render/headings.hpp"

#include <catch2/catch.hpp>

#include "choose/chosen.hpp"
#include "render/small_sheet.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;
using elgen::testing::has;

TEST_CASE("every output of the table has a symbol and a sentence") {
  const Chosen c = chosen(everything_text());
  for (const Function& function : c.choice.program.functions) {
    INFO(function.name);
    CHECK_FALSE(rendering::heading(c.checked.model, function).symbol.empty());
    CHECK(rendering::output_doc(c.checked.model, function).back() == '.');
  }
}
