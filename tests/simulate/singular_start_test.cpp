// Starts at which no acceleration is determined.
#include "simulate/singular_start.hpp"

#include <catch2/catch.hpp>

#include "simulate/compiled_model.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// What is said of a start of a point on a sphere, with or without its `singular`.
std::string start_refusal(const std::string& start, const std::string& singular) {
  const CompiledSystem compiled(model_text("sphere", R"toml([[coordinate]]
name = "theta"
)toml" + singular + R"toml([[coordinate]]
name = "phi"
[energy]
T = "1/2*dot(theta)^2 + 1/2*sin(theta)^2*dot(phi)^2"
)toml"),
                                start_options(start));
  System system(compiled.checked(), compiled.program(), &compiled.functions());
  const Diagnostics refused = refuse_start(system, system.start(), 0);
  return refused.empty() ? "" : refused.front().message;
}

const std::string stated = "singular = \"sin(theta)\"\n";

}  // namespace

TEST_CASE("where a stated factor is zero, up to the rounding of pi, the chart breaks") {
  const std::string broken = "the chart of `theta` breaks at the start, where `sin(theta)` is zero";
  CHECK(start_refusal("theta=0", stated) == broken);
  CHECK(start_refusal("theta=pi", stated) == broken);
  CHECK(start_refusal("theta=1e-7", stated).empty());
}

TEST_CASE("where M is singular the pivot is named") {
  CHECK(start_refusal("theta=1e-9", "").empty());
  const std::string broken = start_refusal("theta=0", "");
  CHECK(broken.starts_with("M is singular at the start: the relative pivot of `dot(phi)` is "));
}
