// Compares outputs of imported arms with numbers on which three independent programs of rigid body
// dynamics agree in all digits. The state is q_i = 0.3 + 0.1 i, v_i = -0.2 + 0.15 i,
// a_i = 0.5 - 0.1 i for i = 0, 1, ...
#include <catch2/catch.hpp>
#include <cmath>

#include "elgen/oracle.hpp"
#include "elgen/urdf.hpp"
#include "support/models.hpp"
#include "support/shell.hpp"

namespace elgen::test {

namespace {

CheckedModel imported_model(const std::string& name) {
  const std::string path = std::string(ELGEN_SOURCE_DIR) + "/tests/urdf/robots/" + name + ".urdf";
  const SourcePointer source = make_source(path, read_text(path));
  const Result<ImportedModel> model = import_urdf(source, {});
  if (!model) throw std::runtime_error(format(model.diagnostics));
  return checked_model(model.value->text);
}

State state_of(const CheckedModel& checked) {
  State state = nominal_state(checked.model, checked.scene);
  for (std::size_t i = 0; i < state.q.size(); ++i) {
    const cln::cl_RA index = static_cast<unsigned long>(i);
    state.q[i] = cln::cl_RA(3) / 10 + index / 10;
    state.v[i] = cln::cl_RA(-2) / 10 + index * 15 / 100;
    state.a[i] = cln::cl_RA(5) / 10 - index / 10;
  }
  return state;
}

/// Compares the first entries of an output with the expected values.
void check_output(const CheckedModel& checked, const std::string& name,
                  const std::vector<double>& expected) {
  for (const OutputRequest& output : checked.scene.outputs) {
    if (output.name != name) continue;
    const OracleValues values = oracle_values(checked.model, output, state_of(checked));
    REQUIRE(values);
    REQUIRE(values->size() >= expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      INFO(name << " " << i);
      const double scale = std::max(1.0, std::abs(expected[i]));
      // The numbers below have 12 digits. 5e-12 is half a unit of the twelfth digit of 1.
      CHECK(std::abs(cln::double_approx((*values)[i]) - expected[i]) <= 5e-12 * scale);
    }
    return;
  }
  FAIL("no output " << name);
}

}  // namespace

TEST_CASE("the imported arm of seven joints has the forces and inertias of the reference") {
  const CheckedModel arm = imported_model("panda_like");
  check_output(arm, "inverse_dynamics",
               {0.168358967281, -9.73488419977, -0.511015422447, -8.26613307312, -0.214397629356,
                1.33298109005, -0.036328105421});
  check_output(arm, "mass_matrix",
               {0.2395900864, 0.112475024054, 0.03619652488, -0.127928161549, 0.0169522201871,
                -0.01047929967, -0.00277973851081});
  check_output(arm, "gravity",
               {0, -10.5294423546, -0.636329726894, -8.05419099332, -0.205076890587, 1.35947896355,
                -0.0353569869498});
}

TEST_CASE("the imported arm of six joints has the forces and inertias of the reference") {
  const CheckedModel arm = imported_model("ur5_like");
  check_output(arm, "inverse_dynamics",
               {1.34553285061, -41.1365187347, -7.25713849942, 1.6798611888, -0.260333004213,
                0.0119566925135});
  check_output(arm, "mass_matrix",
               {2.53797634056, 0.19050166574, 0.0502676568782, -0.0568282257358, -0.0216701153474,
                -0.0217341495557});
  check_output(arm, "gravity",
               {0, -43.1161631151, -8.18093216423, 1.46077671142, -0.263184544144, 0});
}

}  // namespace elgen::test
