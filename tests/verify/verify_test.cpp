// The whole certificate: its order, options, diagnostics and reproducibility.
#include <catch2/catch.hpp>

#include "elgen/certificate.hpp"
#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Verification quick(const System& system, std::uint64_t seed = 1) {
  return verify(system.model, system.scene, system.program, {},
                {.samples = 4, .is_quick = true, .seed = seed});
}

bool has_check(const Certificate& certificate, const std::string& check) {
  for (const CertificateRow& row : certificate.rows) {
    if (row.check == check) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("a correct program has a certificate that passes") {
  const Verification result = quick(cart_pole_system());
  CHECK(holds(result.certificate));
  CHECK(result.diagnostics.empty());
  CHECK(result.certificate.scene == "full");
  CHECK(has_check(result.certificate, "program vs oracle"));
  CHECK(has_check(result.certificate, "power balance"));
  CHECK_FALSE(has_check(result.certificate, "compiled code vs program"));
}

TEST_CASE("a seed determines the text, for any number of processes") {
  const System system = cart_pole_system();
  CHECK(to_text(quick(system).certificate) == to_text(quick(system).certificate));
  CHECK(to_text(quick(system, 1).certificate) != to_text(quick(system, 2).certificate));
  const Verification shared =
      verify(system.model, system.scene, system.program, {}, {4, true, 1, 3});
  CHECK(to_full_text(shared.certificate) == to_full_text(quick(system).certificate));
}

TEST_CASE("a wrong program fails, and a wrong expectation too") {
  CHECK_FALSE(holds(quick(with_mistake("gravity", "= 16 15", "= 16 14")).certificate));
  ModelBuilder builder = pendulum();
  Expectation expectation;
  expectation.output = "mass_matrix";
  expectation.rows = expectation.columns = 1;
  expectation.entries = {builder.expression("m*l")};
  builder.model.expectations.push_back(expectation);
  const Verification result = quick(system_of(builder.model, ""));
  CHECK_FALSE(holds(result.certificate));
  CHECK(exit_code(result.diagnostics) == ExitCode::differs);
}

TEST_CASE("for a long program few states are visited, ordinary and extreme ones") {
  System system = cart_pole_system();
  // 20000 instructions, as for a big robot. The added instructions are unused and change no value.
  Function& mass = system.program.functions.front();
  mass.instructions.resize(20'000, mass.instructions.front());
  mass.names.resize(mass.instructions.size());
  std::vector<std::string> steps;
  VerifyOptions options{.is_quick = true};
  options.on_step = [&steps](const std::string& step) { steps.push_back(step); };
  const Verification result = verify(system.model, system.scene, system.program, {}, options);
  CHECK(holds(result.certificate));
  REQUIRE_FALSE(steps.empty());
  CHECK(steps.front() == "accuracy in double, state 1 of 12");
  // Structure is checked at the ordinary states among the 12 visited states.
  for (const CertificateRow& row : result.certificate.rows) {
    if (row.check != "mass matrix symmetric") continue;
    CHECK(row.samples >= 1);
    CHECK(row.samples <= 4);
  }
}

TEST_CASE("a kink that the states see only from one side is noted") {
  ModelBuilder builder = cart_pole();
  builder.force_on(0, "-max(x - 300, 0)");
  CHECK_FALSE(has_check(quick(system_of(builder.model, "")).certificate, "both sides of kinks"));
  builder.force_on(0, "-max(x^2 + 1, 0)");
  const Certificate certificate = quick(system_of(builder.model, "")).certificate;
  CHECK(has_check(certificate, "both sides of kinks"));
  CHECK(count_rows(certificate, Verdict::noted) == 1);
  CHECK(holds(certificate));
}
