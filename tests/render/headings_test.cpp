#include "render/headings.hpp"

#include <catch2/catch.hpp>

#include "choose/chosen.hpp"
#include "render/small_sheet.hpp"
#include "support/frame_systems.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;
using elgen::testing::has;

TEST_CASE("every output of the table has a symbol and a sentence") {
  const Chosen c = chosen(everything_text());
  for (const Function& function : c.choice.program.functions) {
    INFO(function.name);
    CHECK_FALSE(elgen::heading(c.checked.model, function).symbol.empty());
    CHECK(output_doc(c.checked.model, function).back() == '.');
  }
}

TEST_CASE("where rotations turn the rates are v, and the equations those of v") {
  const auto definition_of = [](const std::string& text, OutputKind kind) {
    const Chosen c = chosen(text);
    for (const Function& function : c.choice.program.functions) {
      if (function.kind == kind) return elgen::heading(c.checked.model, function).definition;
    }
    FAIL("no such output");
    return std::string();
  };
  const std::string plain = everything_text();
  CHECK(definition_of(plain, OutputKind::gravity) == "g = \\frac{\\partial V_{0}}{\\partial q}");
  CHECK(definition_of(plain, OutputKind::inverse_dynamics) ==
        "\\tau = M \\ddot{q} + \\mathrm{bias}");
  const std::string body = tumbler_text();
  CHECK(definition_of(body, OutputKind::gravity) ==
        "g = N^{\\top} \\frac{\\partial V_{0}}{\\partial q}");
  CHECK(definition_of(body, OutputKind::inverse_dynamics) == "\\tau = M a + \\mathrm{bias}");
  CHECK(has(definition_of(body, OutputKind::coriolis_matrix), "[\\omega]_{\\times}"));
}
