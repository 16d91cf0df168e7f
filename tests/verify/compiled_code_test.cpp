// Compiled code against the program: equal bits pass, and one changed bit or sign is detected.
// Sines of packs are within the requested error, or reported with their angle.
#include "verify/compiled_code.hpp"

#include <cln/rational.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "verify/changed_code.hpp"
#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

template <class Scalar>
std::vector<CertificateRow> rows_of(const System& system, const Changed& compiled,
                                    const std::string& types = {},
                                    BuildFlags build = BuildFlags::as_written) {
  return check_compiled_code(system.subject(),
                             {types, false, std::make_unique<Changed>(compiled), build},
                             sample_states<Scalar>(system.subject(), {4, 1, true}));
}

/// Code with std::sin(t) and `factor` std::cos(t) as its sine and cosine, only in double.
class LibrarySines final : public CompiledModel {
 public:
  explicit LibrarySines(double factor) : factor_(factor) {}

  [[nodiscard]] DriverFunction<double> find(std::string_view) const override { return nullptr; }
  [[nodiscard]] std::vector<double> call(std::string_view function,
                                         const Arguments<double>& arguments) const override {
    if (function != sine_and_cosine) return {};
    return {std::sin(arguments.t), factor_ * std::cos(arguments.t)};
  }
  [[nodiscard]] std::vector<float> call(std::string_view, const Arguments<float>&) const override {
    return {};
  }
  [[nodiscard]] bool has(ScalarKind scalar) const override {
    return scalar == ScalarKind::double_precision;
  }

 private:
  double factor_;
};

CertificateRow sine_row_of(double factor, BuildFlags build = BuildFlags::as_written) {
  System system = cart_pole_system();
  system.scene.numerics.trigonometry_error = cln::cl_RA(1) / 1'000'000;
  const auto rows = check_pack_sines(
      system.subject(), {"batch", true, std::make_unique<LibrarySines>(factor), build});
  REQUIRE(rows.size() == 1);
  return rows.front();
}

std::size_t failing(const std::vector<CertificateRow>& rows) {
  std::size_t count = 0;
  for (const CertificateRow& row : rows) count += row.verdict == Verdict::fails ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("equal code passes, function by function, in both scalars") {
  const System system = cart_pole_system();
  const Changed same(system.program, "", [](double x) { return x; });
  CHECK(rows_of<double>(system, same).size() == system.program.functions.size());
  CHECK(failing(rows_of<double>(system, same)) == 0);
  CHECK(failing(rows_of<float>(system, same)) == 0);
}

TEST_CASE("rows state the types of the functions' arguments") {
  const System system = cart_pole_system();
  const Changed same(system.program, "", [](double x) { return x; });
  CHECK(rows_of<double>(system, same).front().subject == "mass_matrix (double)");
  CHECK(rows_of<float>(system, same, "Eigen").front().subject == "mass_matrix (float, Eigen)");
  CHECK(rows_of<double>(system, same, "", BuildFlags::native).front().subject ==
        "mass_matrix (double, -O3 -march=native)");
}

TEST_CASE("bits are compared only without contraction") {
  const System system = cart_pole_system();
  const Changed last_bit(system.program, "bias", [](double x) { return std::nextafter(x, 1e9); });
  CHECK(failing(rows_of<double>(system, last_bit, "", BuildFlags::native)) == 1);
  CHECK(rows_of<double>(system, last_bit, "", BuildFlags::user_flags).empty());
}

TEST_CASE("a changed last bit or sign of zero fails") {
  const System system = cart_pole_system();
  const Changed last_bit(system.program, "bias", [](double x) { return std::nextafter(x, 1e9); });
  const auto rows = rows_of<double>(system, last_bit);
  CHECK(failing(rows) == 1);
  for (const CertificateRow& row : rows) {
    if (row.verdict == Verdict::fails) CHECK(row.worst_state.find("q = (") == 0);
  }
  const Changed sign(system.program, "drift", [](double x) { return -x; });
  CHECK(failing(rows_of<float>(system, sign)) == 1);
}

TEST_CASE("declared numbers that differ from the model's are named") {
  const DeclaredNumber right{"m (double)", 0.1, 0.1};
  const CertificateRow holding = check_declared_numbers({right, {"l (double)", 2, 2}});
  CHECK(holding.verdict == Verdict::holds);
  CHECK(holding.samples == 2);
  const CertificateRow failing = check_declared_numbers({right, {"l (double)", 0.5, 2}});
  CHECK(failing.verdict == Verdict::fails);
  CHECK(failing.worst_value == "1 of 2 numbers differ");
  CHECK(failing.worst_state == "l (double) is 0.5, in the model 2");
}

TEST_CASE("batches are compared with the polynomials of their sines and cosines") {
  const System system = cart_pole_system();
  const CompiledHeader batch{
      "batch", true, std::make_unique<Changed>(system.program, "", [](double x) { return x; })};
  const auto rows = check_compiled_code(system.subject(), batch,
                                        sample_states<float>(system.subject(), {4, 1, true}));
  CHECK(failing(rows) > 0);  // the library's sines are not the polynomials
}

TEST_CASE("sines of packs may differ by the scene's tolerance, in every build") {
  for (const BuildFlags build :
       {BuildFlags::as_written, BuildFlags::native, BuildFlags::user_flags}) {
    CHECK(sine_row_of(1 - 0.9e-6, build).verdict == Verdict::holds);
    const CertificateRow row = sine_row_of(1 + 1.5e-6, build);
    CHECK(row.verdict == Verdict::fails);
    CHECK(row.worst_value == "1.5e-06");
    CHECK(row.worst_state.find("x = ") == 0);
    CHECK(row.tolerance == "1e-06: the `max_error` of `trigonometry`");
  }
  CHECK(sine_row_of(std::nan("")).verdict == Verdict::fails);
  CHECK(sine_row_of(1, BuildFlags::user_flags).subject ==
        "sine and cosine (double, batch, -O3 -march=native, contraction on)");
}

TEST_CASE("the errors of emitted functions are within their documented bounds") {
  ModelBuilder builder;
  builder.coordinate("x").T("x_d^2/2").V("stumpff(x, 2) + stumpff(x, -2)");
  const System system = system_of(builder.model,
                                  "coordinates x\nfunction potential_energy\n"
                                  "  0 = coordinate x\n  1 = constant 2\n  2 = stumpff 0 1\n"
                                  "  3 = negate 1\n  4 = stumpff 0 3\n  5 = add 2 4\n"
                                  "  result 1 1 = 5\n");
  const auto rows = check_helper_functions(system.subject());
  REQUIRE(rows.size() == 4);
  for (const CertificateRow& row : rows) {
    INFO(row.worst_value << " at " << row.worst_state);
    CHECK(row.verdict == Verdict::holds);
    CHECK(row.samples == 256);
  }
  CHECK(rows[0].subject == "stumpff(x, -2) (double)");
  CHECK(rows[2].subject == "stumpff(x, 2) (double)");
  CHECK(check_helper_functions(cart_pole_system().subject()).empty());
}

TEST_CASE("missing code is skipped with the reason") {
  CompiledHeader eigen{"Eigen"};
  eigen.failure_reason = "<Eigen/Core> is not installed";
  const CertificateRow row = missing_code_row(eigen);
  CHECK(row.verdict == Verdict::skipped);
  CHECK(row.subject == "all outputs (Eigen)");
  CHECK(row.worst_value == "<Eigen/Core> is not installed");
  CompiledHeader late;
  late.failure_reason = "`c++` has not ended within 10 s";
  CHECK(missing_code_row(late).subject == "all outputs");
  CompiledHeader users;
  users.build = BuildFlags::user_flags;
  CHECK(missing_code_row(users).check == "as users compile");
}

TEST_CASE("a function that returns no entries fails") {
  const System system = cart_pole_system();
  const Program nothing;
  const Changed empty(nothing, "", [](double x) { return x; });
  CHECK(failing(rows_of<double>(system, empty)) == system.program.functions.size());
}
