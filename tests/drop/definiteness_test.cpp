// Whether M without its small terms stays positive definite.
#include "drop/definiteness.hpp"

#include <catch2/catch.hpp>

#include "support/models.hpp"

using namespace elgen;
using namespace elgen::test;
using cln::cl_RA;

namespace {

/// M = [1, 3/5; 3/5, 1]: its smallest eigenvalue is 2/5.
Diagnostics found(const cl_RA& dropped) {
  const Model model = checked_model(model_text("pair", R"toml([[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[energy]
T = "1/2*dot(x)^2 + 1/2*dot(y)^2 + 3/5*dot(x)*dot(y)"
)toml"))
                          .model;
  Scene scene;
  scene.dropping = Dropping{};
  const EntryError none;
  const EntryError some{dropped, {}, {}};
  Reduction reduction;
  reduction.outputs = {{OutputKind::mass_matrix, 2, {none, some, some, none}}};
  return check_definiteness(model, scene, reduction);
}

}  // namespace

TEST_CASE("half of the smallest eigenvalue may be dropped") {
  CHECK(found(cl_RA(19) / 100).empty());
  const Diagnostics refused = found(cl_RA(21) / 100);
  REQUIRE(refused.size() == 1);
  CHECK(refused[0].code == Code::E618);
  CHECK(found(1).size() == 1);
}

TEST_CASE("nothing is sampled where nothing is dropped from M") {
  CHECK(check_definiteness({}, {}, {}).empty());
}
