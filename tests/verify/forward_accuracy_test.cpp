// Accelerations by condition: right ones keep the bound, imprecise ones do not, singular charts are
// skipped.
#include "verify/forward_accuracy.hpp"

#include <catch2/catch.hpp>

#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

template <class Scalar>
std::optional<CertificateRow> row_of(const System& system) {
  return check_forward_accuracy(system.subject(),
                                sample_states<Scalar>(system.subject(), {16, 1, true}));
}

}  // namespace

TEST_CASE("accelerations of a right program keep the bound in both scalars") {
  for (const auto& row : {row_of<double>(cart_pole_system()), row_of<float>(cart_pole_system())}) {
    REQUIRE(row);
    INFO(row->worst);
    CHECK(row->verdict == Verdict::holds);
    CHECK(row->samples > 16);
  }
}

TEST_CASE("the row needs the functions its formula is made of") {
  System system = cart_pole_system();
  auto& functions = system.program.functions;
  functions.erase(functions.begin());
  CHECK_FALSE(row_of<double>(system));
}

TEST_CASE("an acceleration that loses digits breaks the bound") {
  // bias_1 = ((k s v2^2 + 1e12) - 1e12) ...: exactly the same equation, with 40 bits rounded away.
  const std::string text = cart_pole_program();
  const std::size_t start = text.find("function forward_dynamics");
  const std::string detour =
      with(with(text.substr(start), "  17 = constant 0\n", "  17 = constant 1000000000000\n"),
           "  22 = negate 21\n  23 = add 19 20\n", "  22 = add 19 17\n  23 = subtract 22 17\n");
  ModelBuilder undamped = cart_pole();
  undamped.parameter("c", "0");
  const System system = system_of(undamped.model, text.substr(0, start) + detour);
  const auto row = row_of<double>(system);
  REQUIRE(row);
  CHECK(row->verdict == Verdict::fails);
  CHECK(row->where.find("q = (") == 0);
}
