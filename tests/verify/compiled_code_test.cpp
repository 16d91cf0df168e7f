// Compiled code against the program: equal bits hold, one changed bit or sign is seen.
#include "verify/compiled_code.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "verify/changed_code.hpp"
#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

template <class Scalar>
std::vector<CertificateRow> rows_of(const System& system, const Changed& compiled,
                                    const std::string& types = {}) {
  return check_compiled(system.subject(), {types, false, std::make_unique<Changed>(compiled)},
                        sample_states<Scalar>(system.subject(), {4, 1, true}));
}

std::size_t failing(const std::vector<CertificateRow>& rows) {
  std::size_t count = 0;
  for (const CertificateRow& row : rows) count += row.verdict == Verdict::fails ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("equal code holds, function by function, in both scalars") {
  const System system = cart_pole_system();
  const Changed same(system.program, "", [](double x) { return x; });
  CHECK(rows_of<double>(system, same).size() == system.program.functions.size());
  CHECK(failing(rows_of<double>(system, same)) == 0);
  CHECK(failing(rows_of<float>(system, same)) == 0);
}

TEST_CASE("rows say which types the functions are on") {
  const System system = cart_pole_system();
  const Changed same(system.program, "", [](double x) { return x; });
  CHECK(rows_of<double>(system, same).front().subject == "mass_matrix (double)");
  CHECK(rows_of<float>(system, same, "Eigen").front().subject == "mass_matrix (float, Eigen)");
}

TEST_CASE("the last bit and the sign of zero count") {
  const System system = cart_pole_system();
  const Changed last_bit(system.program, "bias", [](double x) { return std::nextafter(x, 1e9); });
  const auto rows = rows_of<double>(system, last_bit);
  CHECK(failing(rows) == 1);
  for (const CertificateRow& row : rows) {
    if (row.verdict == Verdict::fails) CHECK(row.where.find("q = (") == 0);
  }
  const Changed sign(system.program, "drift", [](double x) { return -x; });
  CHECK(failing(rows_of<float>(system, sign)) == 1);
}

TEST_CASE("numbers that are declared otherwise than the model says are named") {
  const DeclaredNumber right{"m (double)", 0.1, 0.1};
  const CertificateRow holding = check_declared({right, {"l (double)", 2, 2}});
  CHECK(holding.verdict == Verdict::holds);
  CHECK(holding.samples == 2);
  const CertificateRow failing = check_declared({right, {"l (double)", 0.5, 2}});
  CHECK(failing.verdict == Verdict::fails);
  CHECK(failing.worst == "1 of 2 numbers differ");
  CHECK(failing.where == "l (double) is 0.5, the model says 2");
}

TEST_CASE("batches are compared with the polynomials of their sines and cosines") {
  const System system = cart_pole_system();
  const CompiledHeader batch{
      "batch", true, std::make_unique<Changed>(system.program, "", [](double x) { return x; })};
  const auto rows =
      check_compiled(system.subject(), batch, sample_states<float>(system.subject(), {4, 1, true}));
  CHECK(failing(rows) > 0);  // the library's sines are not the polynomials'
}

TEST_CASE("a function that gives no entries differs") {
  const System system = cart_pole_system();
  const Program nothing;
  const Changed empty(nothing, "", [](double x) { return x; });
  CHECK(failing(rows_of<double>(system, empty)) == system.program.functions.size());
}
