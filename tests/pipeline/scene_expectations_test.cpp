// [[expect]] of a scene describes the functions that the scene emits; [[expect]] of the model
// describes the model.
#include <catch2/catch.hpp>

#include "pipeline/pipeline_testing.hpp"
#include "support/models.hpp"
#include "verify/structure/expectations.hpp"

namespace elgen::test {
namespace {

const std::string pendulum = model_text("pendulum", R"toml([[coordinate]]
name = "theta"
[parameters]
m = 2
l = 3
g = 9.81
[[point]]
name = "bob"
mass = "m"
at = ["l*sin(theta)", "-l*cos(theta)"]
[gravity]
vector = ["0", "-g"]
)toml");

/// The verdicts on all entries, first those of the model: "holds, fails".
std::string verdicts(const std::string& model, const std::string& scene) {
  const Products products = derived(inputs_of(model, scene), "mass_matrix,gravity");
  const auto& [checked, of_scene] = *products.checked;
  ClosedForms forms = *products.closed_forms;
  const ExpectationReport report =
      check_expectations({checked, of_scene, *products.program}, &forms, 1);
  std::string text;
  for (const CertificateRow& row : report.rows) {
    text += text.empty() ? "" : ", ";
    text += row.verdict == Verdict::holds ? "holds" : "fails";
  }
  return text;
}

std::string expecting(const std::string& claim) { return "[[expect]]\n" + claim + "\n"; }

}  // namespace

TEST_CASE("fixed parameters have their values in the expectations of a scene") {
  const std::string fixed = "[parameters]\nfixed = { m = 5 }\n";
  CHECK(verdicts(pendulum, fixed + expecting("gravity = [\"5*g*l*sin(theta)\"]")) == "holds");
  CHECK(verdicts(pendulum, fixed + expecting("gravity = [\"2*g*l*sin(theta)\"]")) == "fails");
  CHECK(verdicts(pendulum, fixed + expecting("bias = [\"m*g*l*sin(theta)\"]")) == "holds");
  CHECK(verdicts(pendulum, fixed + expecting("bias = [\"5*g*l*sin(theta)\"]")) == "holds");
  CHECK(verdicts(pendulum, fixed + expecting("gravity = [147.15]\nat = { theta = \"pi/2\" }")) ==
        "holds");
  // In the model, m may have any value.
  CHECK(verdicts(pendulum + expecting("bias = [\"5*g*l*sin(theta)\"]"), fixed) == "fails");
}

TEST_CASE("expansions hold in the expectations of a scene only") {
  const std::string expanded = "[approximate]\norder = 1\nabout = { theta = 0 }\n";
  CHECK(verdicts(pendulum, expanded + expecting("gravity = [\"m*g*l*theta\"]")) == "holds");
  CHECK(verdicts(pendulum, expanded + expecting("gravity = [\"m*g*l*sin(theta)\"]")) == "fails");
  CHECK(verdicts(pendulum + expecting("gravity = [\"m*g*l*sin(theta)\"]"), expanded).empty());
}

TEST_CASE("locked coordinates are functions of time in the expectations of a scene") {
  const std::string locked = "[lock]\nx = { value = \"1/2*t^2\" }\n";
  const std::string cart = model_file("cart_pole");
  CHECK(verdicts(cart, locked + expecting("mass_matrix = [[\"m*l^2\"]]")) == "holds");
  const std::string pole = "bias = [\"m*l*cos(theta)*dot(dot(x)) - m*g*l*sin(theta)\"]";
  CHECK(verdicts(cart, locked + expecting(pole)) == "holds");
  const std::string wrong = "bias = [\"2*m*l*cos(theta)*dot(dot(x)) - m*g*l*sin(theta)\"]";
  CHECK(verdicts(cart, locked + expecting(wrong)) == "fails");
}

TEST_CASE("the expectations of a scene know its inputs, those of the model do not") {
  const std::string push = "[[input]]\nname = \"push\"\nat = \"bob\"\n";
  const std::string claim = "input_matrix = [[\"l*cos(theta)\", \"l*sin(theta)\"]]";
  const std::string fall = expecting("equations = [\"m*l^2*dot(dot(theta)) = -m*g*l*sin(theta)\"]");
  CHECK(verdicts(pendulum, push + expecting(claim)) == "holds, holds");
  // An equation has a second row, which says that the accelerations are determined.
  CHECK(verdicts(pendulum + fall, push) == "holds, holds");
  CHECK(verdicts(pendulum, push + fall) == "fails, holds");
}

}  // namespace elgen::test
