// The inspection finds faults in models that are mechanically wrong and none in sound ones.
#include "elgen/inspect.hpp"

#include <catch2/catch.hpp>
#include <chrono>

#include "inspect/found.hpp"
#include "oracle/samples.hpp"
#include "support/frame_systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string findings(const Model& model) { return text_of(inspect(model, {})); }

}  // namespace

TEST_CASE("sound models have nothing to report") {
  CHECK(findings(pendulum().model).empty());
  CHECK(findings(cart_pole().model).empty());
  CHECK(findings(double_pendulum().model).empty());
  CHECK(findings(charged_particle().model).empty());
  CHECK(findings(rotating_hoop("W*t").model).empty());
  CHECK(findings(relativistic_particle().model).empty());
}

TEST_CASE("sound models of frames have nothing to report", "[frames]") {
  for (const auto& [name, text] : frame_systems()) {
    const CheckedModel checked = checked_model(text);
    Diagnostics found = inspect(checked.model, checked.scene);
    // These models share one list of parameters.
    std::erase_if(found, [](const Diagnostic& d) { return d.code == Code::E522; });
    CHECK(name + ": " + text_of(found) == name + ": ");
  }
}

TEST_CASE("everything found in one model is reported at once") {
  ModelBuilder b = spherical_pendulum();
  b.model.gravity.reset();
  b.V("-m*g*z(bob)");
  CHECK(findings(b.model) ==
        "E511: the mass matrix loses rank at `th` = 0, pi\n"
        "E512: V falls as `bob` rises");
}

TEST_CASE("a model that is singular everywhere is not searched for singular charts") {
  ModelBuilder b;
  b.coordinate("x").coordinate("y", "rad").T("(x_d + y_d)^2/2");
  CHECK(findings(b.model) == "E501: the motion `x : y = 1 : -1` has no kinetic energy");
}

TEST_CASE("the inspection is quick: two coordinates, a chain of 20, a chain of 1000") {
  const auto milliseconds = [](const Model& model) {
    const auto start = std::chrono::steady_clock::now();
    const Diagnostics none = inspect(model, {});
    CHECK(none.empty());
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
  };
  // Ten times what is promised for an idle machine: tests share theirs.
  CHECK(milliseconds(cart_pole().model) < 100);
  CHECK(milliseconds(chain(20).model) < 1000);
  CHECK(milliseconds(chain(1000).model) < 500);
}
