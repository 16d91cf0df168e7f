// Compiled code against the program: equal bits hold, one changed bit or sign is seen.
#include "verify/compiled_code.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// The interpreter in the place of compiled code, with one function's first entry changed.
class Changed final : public CompiledModel {
 public:
  Changed(const Program& program, std::string function, std::function<double(double)> change)
      : program_(program), function_(std::move(function)), change_(std::move(change)) {}

  [[nodiscard]] DriverFunction<double> find(std::string_view) const override { return nullptr; }
  [[nodiscard]] std::vector<double> call(std::string_view function,
                                         const Arguments<double>& arguments) const override {
    return changed(function, arguments);
  }
  [[nodiscard]] std::vector<float> call(std::string_view function,
                                        const Arguments<float>& arguments) const override {
    return changed(function, arguments);
  }
  [[nodiscard]] bool has(ScalarKind /*scalar*/) const override { return true; }

 private:
  template <class Scalar>
  std::vector<Scalar> changed(std::string_view name, const Arguments<Scalar>& arguments) const {
    for (const Function& function : program_.functions) {
      if (function.name != name) continue;
      std::vector<Scalar> values = evaluate(program_, function, arguments);
      if (name == function_) values[0] = static_cast<Scalar>(change_(values[0]));
      return values;
    }
    return {};
  }

  const Program& program_;
  std::string function_;
  std::function<double(double)> change_;
};

template <class Scalar>
std::vector<CertificateRow> rows_of(const System& system, const Changed& compiled,
                                    const std::string& types = {}) {
  return check_compiled(system.subject(), {types, std::make_unique<Changed>(compiled)},
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

TEST_CASE("a function that gives no entries differs") {
  const System system = cart_pole_system();
  const Program nothing;
  const Changed empty(nothing, "", [](double x) { return x; });
  CHECK(failing(rows_of<double>(system, empty)) == system.program.functions.size());
}
