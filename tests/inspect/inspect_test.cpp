// The inspection reports mechanical faults of a model, and nothing for sound models.
#include "elgen/inspect.hpp"

#include <catch2/catch.hpp>
#include <chrono>

#include "inspect/found.hpp"
#include "oracle/samples.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string findings(const Model& model) { return text_of(inspect(model, {})); }

}  // namespace

TEST_CASE("nothing is reported for sound models") {
  CHECK(findings(pendulum().model).empty());
  CHECK(findings(cart_pole().model).empty());
  CHECK(findings(double_pendulum().model).empty());
  CHECK(findings(charged_particle().model).empty());
  CHECK(findings(rotating_hoop("W*t").model).empty());
  CHECK(findings(relativistic_particle().model).empty());
}

TEST_CASE("nothing is reported for sound models of frames", "[frames]") {
  for (const auto& [name, text] : frame_systems()) {
    const CheckedModel checked = checked_model(text);
    Diagnostics found = inspect(checked.model, checked.scene);
    // The models share one list of parameters, so models have unused parameters (E522).
    std::erase_if(found, [](const Diagnostic& d) { return d.code == Code::E522; });
    CHECK(name + ": " + text_of(found) == name + ": ");
  }
}

TEST_CASE("all faults of one model are reported at once") {
  ModelBuilder b = spherical_pendulum();
  b.model.gravity.reset();
  b.V("-m*g*z(bob)");
  CHECK(findings(b.model) ==
        "E511: the mass matrix loses rank at `th` = 0, pi\n"
        "E512: V falls as `bob` rises");
}

TEST_CASE("if M is singular everywhere, singular charts are not searched") {
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
  // Ten times the promised time of an idle machine, because tests run in parallel.
  CHECK(milliseconds(cart_pole().model) < 100);
  CHECK(milliseconds(chain(20).model) < 1000);
  CHECK(milliseconds(chain(1000).model) < 500);
}
