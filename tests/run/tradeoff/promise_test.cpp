// Certificate rows of scenes with max_error. A row fails if the code exceeds max_error.
#include <catch2/catch.hpp>
#include <memory>

#include "run/tradeoff/derived.hpp"
#include "support/shell.hpp"
#include "verify/changed_code.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// The rows for code that returns the gravity of a pendulum times `factor`: the build as written,
/// then the build with users' flags.
std::vector<CertificateRow> rows_of(const std::string& numeric, double factor) {
  const Products products =
      derived(read_model("pushed_pendulum"), "gravity", "[numeric]\n" + numeric);
  const Changed code(*products.program, "gravity", [factor](double x) { return factor * x; });
  CompiledHeaders headers;
  headers.push_back({"", false, std::make_unique<Changed>(code)});
  headers.push_back({"Eigen", false, std::make_unique<Changed>(code)});
  headers.push_back({"", false, std::make_unique<Changed>(code), BuildFlags::user_flags});
  return check_max_error(*products.checked, *products.program, headers, {});
}

}  // namespace

TEST_CASE("rows hold for code within the scene's max_error") {
  const std::vector<CertificateRow> rows = rows_of("max_error = 1e-6\n", 1 + 0.9e-6);
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].check == "max_error");
  CHECK(rows[0].subject == "gravity (double)");
  CHECK(rows[1].subject == "gravity (double, as users compile)");
  for (const CertificateRow& row : rows) {
    CHECK(row.verdict == Verdict::holds);
    CHECK(row.worst_value == "9.00e-07 of the largest value");
    CHECK(row.samples == 1000);
    CHECK(mentions(row.worst_state, "q = ("));
  }
}

TEST_CASE("rows fail for code with a larger error") {
  for (const CertificateRow& row : rows_of("max_error = 1e-6\n", 1 + 2e-6)) {
    CHECK(row.verdict == Verdict::fails);
    CHECK(row.worst_value == "2.00e-06 of the largest value");
  }
}

TEST_CASE("max_error applies to the scalars of the scene") {
  const auto verdicts = [](const std::string& scalars) {
    std::vector<Verdict> found;
    for (const CertificateRow& row :
         rows_of("scalar = [" + scalars + "]\nmax_error = 1e-10\n", 1)) {
      found.push_back(row.verdict);
    }
    return found;
  };
  using enum Verdict;
  CHECK(verdicts("\"double\"") == std::vector{holds, holds});
  CHECK(verdicts("\"float\"") == std::vector{fails, fails});
  CHECK(verdicts("\"float\", \"double\"") == std::vector{fails, holds, fails, holds});
}

TEST_CASE("max_error applies to the ranges of the scene") {
  const std::vector<CertificateRow> rows =
      rows_of("max_error = 1\nranges = { q = [0.25, 0.25] }\n", 2);
  REQUIRE(rows.size() == 2);
  CHECK(mentions(rows[0].worst_state, "q = (0.25)"));
}

TEST_CASE("an output without values at most states is skipped") {
  const Products products = derived(model_text("root", R"toml([[coordinate]]
name = "x"
range = [-1, 1]
[energy]
T = "dot(x)^2"
V = "sqrt(x - 9/10)"
)toml"),
                                    "potential_energy", "[numeric]\nmax_error = 1e-6\n");
  const Changed code(*products.program, "", [](double x) { return x; });
  CompiledHeaders headers;
  headers.push_back({"", false, std::make_unique<Changed>(code)});
  const auto rows = check_max_error(*products.checked, *products.program, headers, {});
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].verdict == Verdict::skipped);
}

TEST_CASE("without max_error or without compiled code there are no rows") {
  CHECK(rows_of("prefer = \"speed\"\n", 2).empty());
  const Products products =
      derived(read_model("pushed_pendulum"), "gravity", "[numeric]\nmax_error = 1e-6\n");
  CHECK(check_max_error(*products.checked, *products.program, {}, {}).empty());
}
