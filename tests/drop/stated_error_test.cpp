// What a reduced output may be off by.
#include <catch2/catch.hpp>

#include "elgen/drop.hpp"

using namespace elgen;
using cln::cl_RA;

TEST_CASE("the constant, and a share of every acceleration") {
  Program program;
  State state;
  state.a = {-3, 2};
  CHECK(cln::zerop(stated_error(program, OutputKind::inverse_dynamics, 0, state).value()));
  program.reduction = Reduction{
      0, {}, {{OutputKind::inverse_dynamics, 1, {{5, {}, {}}, {1, {2, cl_RA(1) / 2}, {}}}}}};
  const cl_RA slack = 1 + cln::expt(cl_RA(2), -20);
  const auto error = [&](std::size_t entry) {
    return stated_error(program, OutputKind::inverse_dynamics, entry, state).value();
  };
  CHECK(error(0) == 5 * slack);
  CHECK(error(1) == 8 * slack);
  CHECK(cln::zerop(stated_error(program, OutputKind::bias, 0, state).value()));
}
