// Program against oracle: correct programs pass, wrong ones fail. Code compiled with users' flags
// may round differently, within the running errors of the program.
#include "verify/bounds/accuracy.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "verify/changed_code.hpp"
#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

template <class Scalar>
std::vector<CertificateRow> rows_of(const System& system, std::size_t count = 16,
                                    bool extremes = true) {
  return check_accuracy(system.subject(),
                        sample_states<Scalar>(system.subject(), {count, 1, extremes}));
}

const CertificateRow& row_of(const std::vector<CertificateRow>& rows, const std::string& subject) {
  for (const CertificateRow& row : rows) {
    if (row.subject == subject) return row;
  }
  FAIL("no row " << subject);
  return rows.front();
}

template <class Scalar>
void check_all_hold(const System& system) {
  for (const CertificateRow& row : rows_of<Scalar>(system)) {
    INFO(row.subject << ": " << row.worst_value << " at " << row.worst_state);
    CHECK(row.verdict == Verdict::holds);
  }
}

/// The implicit midpoint rule for x'' = -x, with one fixed-point iteration.
System stepped_spring() {
  ModelBuilder builder;
  builder.coordinate("x").T("x_d^2/2").V("x^2/2");
  return system_of(builder.model,
                   "coordinates x\nstep\nfunction step = step 2 1\n  0 = coordinate x\n"
                   "  1 = velocity x\n  2 = step\n  3 = constant 1/2\n  4 = multiply 3 2\n"
                   "  5 = multiply 4 1\n  6 = add 0 5\n  7 = multiply 4 6\n  8 = subtract 1 7\n"
                   "  9 = multiply 4 8\n  10 = add 0 9\n  11 = multiply 4 10\n"
                   "  12 = subtract 1 11\n  13 = subtract 8 12\n  14 = multiply 2 8\n"
                   "  15 = add 0 14\n  16 = multiply 2 10\n  17 = subtract 1 16\n"
                   "  result coordinates 1 1 = 15\n  result rates 1 1 = 17\n"
                   "  result residual 1 1 = 13\n");
}

/// V0 = m l g (1 - cos th) - m l g of a pendulum, with 1 - cos th computed directly.
const char* cancelling =
    "parameters m l g\ncoordinates th\nfunction potential_energy\n"
    "  0 = parameter m\n  1 = parameter l\n  2 = parameter g\n  3 = coordinate th\n"
    "  4 = cos 3\n  5 = constant 1\n  6 = subtract 5 4\n  7 = multiply 0 1\n  8 = multiply 7 2\n"
    "  9 = multiply 8 6\n  10 = subtract 9 8\n  result 1 1 = 10\n";

/// The row of cart_pole's code, with `change` applied to the first entry of its bias.
template <class Scalar>
CertificateRow row_with(const std::function<double(double)>& change,
                        const SamplingOptions& sampling) {
  const System system = cart_pole_system();
  const Changed code(system.program, "bias", change);
  AccuracyOptions options;
  options.check_options.user_code = &code;
  const auto states = sample_states<Scalar>(system.subject(), sampling);
  for (CertificateRow& row : check_accuracy(system.subject(), states, options)) {
    if (row.check == "as users compile") return std::move(row);
  }
  FAIL("no such row");
  return {};
}

/// Code that computes in long double, with `change` applied to the first entry of its bias.
class InLongDouble final : public CompiledModel {
 public:
  InLongDouble(const Program& program, std::function<double(double)> change)
      : program_(program), change_(std::move(change)) {}

  [[nodiscard]] DriverFunction<double> find(std::string_view) const override { return nullptr; }
  [[nodiscard]] std::vector<double> call(std::string_view name,
                                         const Arguments<double>& arguments) const override {
    std::vector<double> values;
    for (const Function& function : program_.functions) {
      if (function.name != name) continue;
      const auto wide = map_leaves([](double x) { return static_cast<long double>(x); }, arguments);
      for (const long double x : evaluate(program_, function, wide)) {
        values.push_back(static_cast<double>(x));
      }
    }
    if (name == "bias") values.at(0) = change_(values.at(0));
    return values;
  }
  [[nodiscard]] std::vector<float> call(std::string_view, const Arguments<float>&) const override {
    return {};
  }
  [[nodiscard]] bool has(ScalarKind scalar) const override {
    return scalar == ScalarKind::double_precision;
  }

 private:
  const Program& program_;
  std::function<double(double)> change_;
};

/// Verlet's method for x'' = -x^3, with accelerations in float.
System mixed_step() {
  ModelBuilder builder;
  builder.coordinate("x").T("x_d^2/2").V("x^4/4");
  System system = system_of(
      builder.model,
      "coordinates x\nstep\nfunction step = step 1\n  0 = coordinate x\n  1 = velocity x\n"
      "  2 = step\n  3 = constant 1/2\n  4 = multiply 3 2\n  5 = multiply 0 0\n"
      "  6 = multiply 5 0\n  7 = negate 6\n  8 = multiply 4 7\n  9 = add 1 8\n"
      "  10 = multiply 2 9\n  11 = add 0 10\n  12 = multiply 11 11\n  13 = multiply 12 11\n"
      "  14 = negate 13\n  15 = multiply 4 14\n  16 = add 9 15\n"
      "  result coordinates 1 1 = 11\n  result rates 1 1 = 16\n");
  for (const std::size_t inner : {5U, 6U, 7U, 12U, 13U, 14U}) {
    system.program.functions.front().instructions[inner].is_inner = true;
  }
  system.scene.numerics.inner = InnerScalar::single_precision;
  return system;
}

/// The step of mixed_step() with its state in Number, and accelerations in float.
template <class Number>
class StepWithState final : public CompiledModel {
 public:
  [[nodiscard]] DriverFunction<double> find(std::string_view) const override { return nullptr; }
  [[nodiscard]] std::vector<double> call(std::string_view,
                                         const Arguments<double>& arguments) const override {
    const auto acceleration = [](Number x) {
      const auto y = static_cast<float>(x);
      return static_cast<Number>(-(y * y * y));
    };
    const auto h = static_cast<Number>(arguments.h);
    auto x = static_cast<Number>(arguments.q[0]);
    auto v = static_cast<Number>(arguments.v[0]);
    v += h / 2 * acceleration(x);
    x += h * v;
    v += h / 2 * acceleration(x);
    return {x, v};
  }
  [[nodiscard]] std::vector<float> call(std::string_view, const Arguments<float>&) const override {
    return {};
  }
  [[nodiscard]] bool has(ScalarKind scalar) const override {
    return scalar == ScalarKind::double_precision;
  }
};

/// The row of code in Numerics::inner, at steps of length h.
CertificateRow mixed_row(const CompiledModel& code, const CompiledModel& packs, double h) {
  const System system = mixed_step();
  AccuracyOptions options;
  options.check_options.wide_code = &code;
  options.check_options.wide_pack_code = &packs;
  auto states = sample_states<double>(system.subject(), {8, 1, false});
  for (auto& state : states) state.values.h = h;
  for (CertificateRow& row : check_accuracy(system.subject(), states, options)) {
    if (row.check == "in float") return std::move(row);
  }
  FAIL("no such row");
  return {};
}

CertificateRow wide_row(const std::function<double(double)>& change, bool extremes) {
  System system = cart_pole_system();
  system.scene.numerics.inner = InnerScalar::long_double;
  const InLongDouble code(system.program, change);
  AccuracyOptions options;
  options.check_options.wide_code = &code;
  const auto states = sample_states<double>(system.subject(), {8, 1, extremes});
  for (CertificateRow& row : check_accuracy(system.subject(), states, options)) {
    if (row.check == "in long double") return std::move(row);
  }
  FAIL("no such row");
  return {};
}

}  // namespace

TEST_CASE("a correct program passes at ordinary and extreme states") {
  check_all_hold<double>(cart_pole_system());
  check_all_hold<float>(cart_pole_system());
}

TEST_CASE("the result of an iteration is correct and has no loss of digits") {
  const System system = stepped_spring();
  check_all_hold<double>(system);
  const auto samples = sample_states<double>(system.subject(), {16, 1, true});
  std::size_t looked_at = 0;
  for (const CertificateRow& row : check_accuracy(
           system.subject(), samples, {{ComparisonMode::entries, LossStates::everywhere}, {}})) {
    if (row.check != "digits lost") continue;
    ++looked_at;
    CHECK_FALSE(mentions(row.worst_value, "residual"));
  }
  CHECK(looked_at == 1);
}

TEST_CASE("the result of an iteration is compared by its running error, in a row of its own") {
  const auto rows = rows_of<double>(stepped_spring());
  CHECK(mentions(row_of(rows, "step.residual (double)").worst_value, " u E"));
  CHECK(mentions(row_of(rows, "step.rates (double)").worst_value, " ulp"));
}

TEST_CASE("each output and field has a row, dynamics too") {
  const auto rows = rows_of<double>(cart_pole_system(), 2, false);
  CHECK(rows.size() == 21);
  CHECK(row_of(rows, "forward_dynamics.relative_pivots (double)").samples == 2);
  CHECK(row_of(rows, "dynamics.bias (double)").verdict == Verdict::holds);
}

TEST_CASE("a wrong program fails, with both values and the state") {
  for (const auto& [function, from, to] :
       {std::tuple{"bias", "23 = add 19 20", "23 = subtract 19 20"},
        std::tuple{"mass_matrix", "10 = add 0 1", "10 = subtract 0 1"},
        std::tuple{"potential_energy", "= 13", "= 11"},
        std::tuple{"drift", "13 = constant 0", "13 = constant 1/1000000000000000000"}}) {
    const auto rows = rows_of<double>(with_mistake(function, from, to), 2, false);
    const auto& row = row_of(rows, std::string(function) + " (double)");
    CHECK(row.verdict == Verdict::fails);
    CHECK(mentions(row.worst_value, "the oracle says"));
    CHECK(row.worst_state.find("q = (") == 0);
  }
}

TEST_CASE("a program that is undefined where the oracle has a value fails") {
  for (const auto& [function, from, to, field] :
       {std::tuple{"gravity", "15 = negate 14\n  16 = constant 0\n",
                   "15 = constant 0\n  16 = divide 14 15\n", "gravity"},
        std::tuple{"forward_dynamics", "31 = divide 30 28", "31 = divide 30 17",
                   "forward_dynamics.acceleration"},
        std::tuple{"dynamics", "21 = multiply 15 3", "21 = divide 15 17", "dynamics.bias"}}) {
    const auto rows = rows_of<double>(with_mistake(function, from, to), 4, false);
    const auto& row = row_of(rows, std::string(field) + " (double)");
    CHECK(row.verdict == Verdict::fails);
    CHECK(mentions(row.worst_value, " is undefined, the oracle says "));
    CHECK(row.worst_state.find("q = (") == 0);
  }
}

TEST_CASE("`dynamics` is compared in rows of its own") {
  const auto rows = rows_of<double>(with_mistake("dynamics", "= 23 22", "= 23 21"), 2, false);
  CHECK(row_of(rows, "dynamics.bias (double)").verdict == Verdict::fails);
  CHECK(row_of(rows, "dynamics.mass_matrix (double)").verdict == Verdict::holds);
  CHECK(row_of(rows, "bias (double)").verdict == Verdict::holds);
}

TEST_CASE("cancellation in the exact formula is reported, and is no failure") {
  const auto rows = rows_of<double>(system_of(pendulum().model, cancelling));
  CHECK(row_of(rows, "potential_energy (double)").verdict == Verdict::holds);
}

TEST_CASE("overflows are reported, and are no failures") {
  const auto rows = rows_of<double>(cart_pole_system(), 0);
  const auto& row = row_of(rows, "kinetic_energy (double)");
  CHECK(row.verdict == Verdict::holds);
  REQUIRE_FALSE(row.skipped.empty());
  CHECK(row.skipped.front().reason == SkipReason::overflow);
}

TEST_CASE("states outside the domain are counted, and a row without states does not pass") {
  const Model model = pendulum().V("sqrt(-1 - th^2)").model;
  const System system = system_of(model, cancelling);
  const auto rows = rows_of<double>(system, 4, false);
  CHECK(rows.front().verdict == Verdict::skipped);
  CHECK(rows.front().skipped == std::vector<SkippedStates>{{SkipReason::undefined, 4}});
}

TEST_CASE("the build with users' flags has one row for all outputs") {
  const auto same = [](double x) { return x; };
  const CertificateRow row = row_with<double>(same, {4, 1, false});
  CHECK(row.verdict == Verdict::holds);
  CHECK(row.subject == "all outputs (double)");
  CHECK(row.samples == 4);
  CHECK(row.worst_value.find("21 outputs within 0 u E") == 0);
  CHECK(row_with<float>(same, {4, 1, true}).subject == "all outputs (float)");
}

TEST_CASE("different rounding passes, an error that rounding does not explain fails and is named") {
  const SamplingOptions ordinary{4, 1, false};
  const auto last_bit = [](double x) { return std::nextafter(x, 1e9); };
  CHECK(row_with<double>(last_bit, ordinary).verdict == Verdict::holds);
  const auto wrong = [](double x) { return x * (1 + 1e-12); };
  const CertificateRow row = row_with<double>(wrong, ordinary);
  CHECK(row.verdict == Verdict::fails);
  CHECK(row.worst_value.find("bias (double): entry 1 is ") == 0);
  CHECK(mentions(row.worst_value, " u E"));
  CHECK(row.worst_state.find("q = (") == 0);
}

TEST_CASE("code that returns no entries fails") {
  const System system = cart_pole_system();
  const Program nothing;
  const Changed empty(nothing, "", [](double x) { return x; });
  AccuracyOptions options;
  options.check_options.user_code = &empty;
  const auto states = sample_states<double>(system.subject(), {1, 1, false});
  const CertificateRow row = check_accuracy(system.subject(), states, options).back();
  CHECK(row.verdict == Verdict::fails);
  CHECK(mentions(row.worst_value, "entry 1 is nan instead of "));
}

TEST_CASE("code in a wider scalar may differ by one rounding from the exact values") {
  const auto same = [](double x) { return x; };
  const CertificateRow row = wide_row(same, true);
  INFO(row.worst_value << " at " << row.worst_state);
  CHECK(row.verdict == Verdict::holds);
  CHECK(row.subject == "all outputs (double)");
  CHECK(row.worst_value.find("21 outputs within ") == 0);
  const auto next = [](double x) { return std::nextafter(std::nextafter(x, 1e9), 1e9); };
  const CertificateRow wrong = wide_row(next, false);
  CHECK(wrong.verdict == Verdict::fails);
  CHECK(wrong.worst_value.find("bias (double): entry 1 is ") == 0);
  CHECK(mentions(wrong.worst_value, " of the tolerance"));
}

TEST_CASE("a step may compute its accelerations in float, but not its state") {
  const StepWithState<double> mixed{};
  const StepWithState<float> in_float{};
  for (const double h : {0.0, 0x1p-20, 0.05}) {
    const CertificateRow row = mixed_row(mixed, mixed, h);
    INFO(row.worst_value << " at " << row.worst_state);
    CHECK(row.verdict == Verdict::holds);
    CHECK(row.samples >= 4);
    if (h == 0) CHECK(mentions(row.worst_value, "2 outputs within 0 of the tolerance"));
  }
  for (const double h : {0.0, 0x1p-20}) {
    CHECK(mixed_row(in_float, mixed, h).verdict == Verdict::fails);
    CHECK(mixed_row(mixed, in_float, h).verdict == Verdict::fails);
  }
}

TEST_CASE("the square of a difference of 0 may round to the square of its error") {
  // At x = y a fused multiply-add leaves the rounding of x x in x x - y y.
  ModelBuilder builder;
  builder.coordinate("x").coordinate("y").T("(x_d^2 + y_d^2)/2").V("(x^2 - y^2)^2");
  const System system = system_of(
      builder.model,
      "coordinates x y\nfunction potential_energy\n  0 = coordinate x\n  1 = coordinate y\n"
      "  2 = multiply 0 0\n  3 = multiply 1 1\n  4 = subtract 2 3\n  5 = multiply 4 4\n"
      "  result 1 1 = 5\n");
  auto states = sample_states<double>(system.subject(), {1, 1, false});
  states.front().values.q = {0.7, 0.7};
  const auto verdict_of = [&](double error) {
    const Changed code(system.program, "potential_energy", [error](double x) { return x + error; });
    AccuracyOptions options;
    options.check_options.user_code = &code;
    return check_accuracy(system.subject(), states, options).back().verdict;
  };
  CHECK(verdict_of(7e-34) == Verdict::holds);
  CHECK(verdict_of(1e-30) == Verdict::fails);
}

TEST_CASE("NaN fails where exact arithmetic has a number") {
  for (const double value : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    const auto no_number = [value](double) { return value; };
    const CertificateRow row = row_with<double>(no_number, {4, 1, false});
    CHECK(row.verdict == Verdict::fails);
    CHECK(row.worst_value.find("bias (double): ") == 0);
    CHECK(row.worst_state.find("q = (") == 0);
  }
}

TEST_CASE("a program with large rounding errors passes, and its lost digits are reported") {
  const System system = badly_rounded();
  const auto samples = sample_states<double>(system.subject(), {4, 1, false});
  const auto rows = check_accuracy(system.subject(), samples,
                                   {{ComparisonMode::entries, LossStates::inside_ranges}, {}});
  CHECK(row_of(rows, "potential_energy (double)").verdict == Verdict::holds);
  CHECK(rows.back().check == "digits lost");
  CHECK(rows.back().loss.value_or(0) > 1e3);
}

TEST_CASE("without states no loss is reported") {
  const CertificateRow row = row_with<double>([](double x) { return x; }, {0, 1, false});
  CHECK(row.verdict == Verdict::skipped);
  CHECK(row.worst_value == "no state to compare");
}
