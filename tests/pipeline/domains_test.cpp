// Models that have a value at some states only.
#include <catch2/catch.hpp>

#include "elgen/pipeline.hpp"
#include "support/models.hpp"

namespace elgen::test {

TEST_CASE("states beyond the speed of light are drawn anew") {
  const std::string text = model_text("slow_light", R"toml(
[[coordinate]]
name = "x"
[parameters]
m = { value = 2, assume = "positive" }
c = { value = 1, assume = "positive" }
[energy]
L = "-m*c^2*sqrt(1 - dot(x)^2/c^2)"
)toml");
  const Products products = run_pipeline({make_source("model.toml", text)}, {});
  INFO(format(products.diagnostics));
  REQUIRE(products.self_check);
  CHECK(products.self_check->states == 32);
  CHECK(products.self_check->outside > 0);
}

}  // namespace elgen::test
