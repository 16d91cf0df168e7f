// The oracle against closed forms, published values and the laws of mechanics.
#include "elgen/oracle.hpp"

#include <cln/float_io.h>
#include <cln/real_io.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "oracle/samples.hpp"

using namespace elgen;
using namespace elgen::test;
using cln::cl_R;

namespace {

/// |x - y| <= 10^-digits max(|x|, |y|, floor)
bool agree(const cl_R& x, const cl_R& y, int digits, const cl_R& floor = 0) {
  const cl_R scale = cln::max(cln::max(cln::abs(x), cln::abs(y)), floor);
  return cln::abs(x - y) <= scale * cln::expt(cl_R(10), -digits);
}

std::vector<cl_R> reals(const nlohmann::json& texts) {
  std::vector<cl_R> values;
  for (const auto& text : texts) values.push_back(exact(text.get<std::string>()));
  return values;
}

nlohmann::json static_cases() {
  std::ifstream file(std::string(ELGEN_SOURCE_DIR) + "/tests/oracle/static_cases.json");
  return nlohmann::json::parse(file).at("cases");
}

ModelBuilder model_of(const nlohmann::json& c) {
  ModelBuilder b;
  std::uint32_t index = 0;
  for (const auto& name : c.at("coordinates"))
    b.coordinate(name).input("u_" + std::string(name), index++);
  for (const auto& [name, value] : c.at("parameters").items()) b.parameter(name, value);
  b.T(c.at("T")).V(c.at("V"));
  return b;
}

const std::map<std::string, OutputKind> kinds{
    {"mass_matrix", OutputKind::mass_matrix},
    {"gravity", OutputKind::gravity},
    {"bias", OutputKind::bias},
    {"kinetic_energy", OutputKind::kinetic_energy},
    {"potential_energy", OutputKind::potential_energy},
    {"acceleration", OutputKind::forward_dynamics},
};

}  // namespace

TEST_CASE("published values of ten systems, among them badly scaled and nearly singular ones") {
  for (const auto& c : static_cases()) {
    const ModelBuilder b = model_of(c);
    for (const auto& s : c.at("states")) {
      State state = nominal_state(b.model, {});
      state.q = reals(s.at("q"));
      state.v = reals(s.at("v"));
      state.u = reals(s.at("u"));
      for (const auto& [name, expected_texts] : s.at("expected").items()) {
        const auto expected = reals(expected_texts);
        const OracleValues values = value_of(b.model, kinds.at(name), state);
        REQUIRE(values);
        for (std::size_t i = 0; i < expected.size(); ++i) {
          CAPTURE(c.at("id").get<std::string>(), name, i);
          // 32 digits are printed; the last is rounded.
          CHECK(agree((*values)[i], expected[i], 31));
        }
      }
    }
  }
}
