// The certificate as people read it.
#include <catch2/catch.hpp>

#include "elgen/certificate.hpp"

using namespace elgen;

namespace {

Certificate sample() {
  return {"cart_pole",
          "full",
          7,
          {{"program vs oracle", "mass_matrix (double)", "|x - x*| / (u B)", 276, "1.2 u B",
            "q = (1, 2)", "8 u B", Verdict::holds},
           {"program vs oracle", "bias (double)", "|x - x*| / (u B)", 276, "9 u B", "q = (3, 4)",
            "8 u B", Verdict::fails},
           {"mass matrix positive definite", "mass_matrix", "D_i/M_ii > 0", 0, "no regular state",
            "", "> 0", Verdict::skipped}}};
}

}  // namespace

TEST_CASE("rows are aligned under their check, the summary comes last") {
  CHECK(to_text(sample()) == R"(certificate of cart_pole, scene full, seed 7

program vs oracle
  holds    mass_matrix (double)  1.2 u B
           formula    |x - x*| / (u B)
           samples    276
           worst at   q = (1, 2)
           tolerance  8 u B
  FAILS    bias (double)         9 u B
           formula    |x - x*| / (u B)
           samples    276
           worst at   q = (3, 4)
           tolerance  8 u B

mass matrix positive definite
  skipped  mass_matrix           no regular state
           formula    D_i/M_ii > 0
           samples    0
           tolerance  > 0

1 checks hold, 1 fail, 1 skipped
)");
}

TEST_CASE("a certificate holds when no row fails") {
  Certificate certificate = sample();
  CHECK_FALSE(holds(certificate));
  certificate.rows[1].verdict = Verdict::holds;
  CHECK(holds(certificate));
}
