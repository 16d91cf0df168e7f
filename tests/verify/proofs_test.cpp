#include "verify/structure/proofs.hpp"

#include <catch2/catch.hpp>

#include "elgen/equations_of_motion.hpp"
#include "elgen/lagrangian.hpp"
#include "elgen/lower.hpp"
#include "support/models.hpp"

using namespace elgen;

namespace {

struct Proved {
  explicit Proved(const std::string& expect)
      : checked(test::checked_model(test::model_text("pendulum", R"toml([[coordinate]]
name = "theta"
[parameters]
m = 2
l = 3
g = 9.81
[[point]]
name = "bob"
at = ["l*sin(theta)", "-l*cos(theta)"]
mass = "m"
[gravity]
vector = ["0", "-g"]
[[expect]]
)toml" + expect))) {
    const auto lagrangian = formulate(checked.model);
    const auto equations = derive(*lagrangian, checked.scene.outputs, {});
    program = *lower(*equations, checked.scene.outputs, {});
    forms = present(program);
  }

  bool equal() { return Proofs(subject(), &forms).equal(checked.model.expectations[0], 0); }
  bool conserved() { return Proofs(subject(), &forms).conserved(checked.model.expectations[0], 0); }
  Subject subject() const { return {checked.model, checked.scene, program}; }

  CheckedModel checked;
  Program program = {};
  ClosedForms forms = {};
};

}  // namespace

TEST_CASE("what is written in another form is proved, what is wrong is not") {
  CHECK(Proved("gravity = [\"m*g*l*sin(theta)\"]\n").equal());
  CHECK(Proved("gravity = [\"2*m*g*l*sin(theta/2)*cos(theta/2)\"]\n").equal());
  CHECK(Proved("mass_matrix = [[\"m*l^2*(sin(theta)^2 + cos(theta)^2)\"]]\n").equal());
  CHECK(Proved("forward_dynamics = [\"-g/l*sin(theta)\"]\n").equal());
  CHECK_FALSE(Proved("gravity = [\"m*g*l*cos(theta)\"]\n").equal());
}

TEST_CASE("conservation along the motion is proved") {
  CHECK(Proved("conserved = [\"1/2*m*l^2*dot(theta)^2 - m*g*l*cos(theta)\"]\n").conserved());
  CHECK_FALSE(Proved("conserved = [\"m*l^2*dot(theta)\"]\n").conserved());
}

TEST_CASE("without closed forms nothing is proved") {
  const Proved p("gravity = [\"m*g*l*sin(theta)\"]\n");
  const Subject subject = p.subject();
  CHECK_FALSE(Proofs(subject, nullptr).equal(p.checked.model.expectations[0], 0));
}

TEST_CASE("an entry that rests on a sampled zero is not proved") {
  Proved p("forward_dynamics = [\"-g/l*sin(theta)\"]\n");
  CHECK(p.equal());
  for (Function& function : p.program.functions) {
    if (function.kind == OutputKind::forward_dynamics) function.sampled_zeros = {0};
  }
  CHECK_FALSE(p.equal());
  Proved q("conserved = [\"1/2*m*l^2*dot(theta)^2 - m*g*l*cos(theta)\"]\n");
  for (Function& function : q.program.functions) function.sampled_zeros = {0};
  CHECK_FALSE(q.conserved());
}
