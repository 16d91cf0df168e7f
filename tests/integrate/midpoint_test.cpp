// The implicit midpoint rule: its order, what it conserves, what it leaves.
#include <catch2/catch.hpp>
#include <cmath>

#include "elgen/toolchain.hpp"
#include "integrate/stepping.hpp"

namespace elgen::test {
namespace {

/// A cart on a ramp that a law lifts, with a damped pendulum of growing mass on it, in a field that
/// makes p more than M v.
const std::string lifted = model_text("lifted", R"toml([[coordinate]]
name = "x"
start = { value = 0.3, rate = 1 }
armature = 0.5
[[coordinate]]
name = "theta"
start = { value = -0.2, rate = 2 }
[define]
m = "1 + t/5"
[energy]
T = """dot(x)^2 + 1/2*m*((dot(x) + dot(theta)*cos(theta))^2 + dot(theta)^2*sin(theta)^2)
  + sin(3*t)*dot(theta)"""
V = "-m*cos(theta) + 3*x^2 - x*dot(theta)"
D = "1/10*dot(theta)^2"
[[input]]
name = "u"
on = "x"
[[force]]
on = "theta"
value = "u*sin(x) - dot(x)/5"
)toml");

/// The emitted step, compiled, with the energies, run on from where the model starts.
class Run {
 public:
  explicit Run(const std::string& model, const std::string& more = {},
               const std::string& emission = {})
      : products_(stepped({.model = model,
                           .method = "midpoint",
                           .more = more,
                           .outputs = "energy_function = true\nmomentum = true\n" + emission,
                           .goal = Goal::emit})) {
    if (!products_.files) throw std::runtime_error(format(products_.diagnostics));
    const CheckedModel& checked = *products_.checked;
    Result<CompiledHeaders> headers =
        compile(*products_.files, checked.model, checked.scene, *products_.program, {});
    if (!headers) throw std::runtime_error(format(headers.diagnostics));
    headers_ = std::move(*headers);
    at_ = arguments_at<double>(nominal_state(checked.model, checked.scene));
    for (std::size_t i = 0; i < at_.q.size(); ++i) {
      at_.q[i] = cln::double_approx(checked.model.coordinates[i].start_value);
      at_.v[i] = cln::double_approx(checked.model.velocities[i].start_rate);
    }
  }

  void step(double h) {
    at_.h = h;
    const std::vector<double> next = code().call("step", at_);
    const auto rates = next.begin() + static_cast<std::ptrdiff_t>(at_.q.size());
    const auto residual = rates + static_cast<std::ptrdiff_t>(at_.v.size());
    at_.q.assign(next.begin(), rates);
    at_.v.assign(rates, residual);
    at_.t += h;
    residual_ = 0;
    for (auto r = residual; r != next.end(); ++r) residual_ = std::max(residual_, std::abs(*r));
  }

  [[nodiscard]] const Arguments<double>& at() const { return at_; }
  [[nodiscard]] Arguments<double>& at() { return at_; }
  [[nodiscard]] double residual() const { return residual_; }  ///< the largest entry
  [[nodiscard]] double energy() const { return code().call("energy_function", at_).front(); }
  [[nodiscard]] double momentum(std::size_t i) const { return code().call("momentum", at_)[i]; }

 private:
  [[nodiscard]] const CompiledModel& code() const { return *headers_.front().functions; }

  Products products_;
  CompiledHeaders headers_;
  Arguments<double> at_;
  double residual_ = 0;
};

}  // namespace

TEST_CASE("one step of midpoint is off by h^3") {
  const cln::cl_RA h = cln::cl_RA(1) / 100;
  for (const std::string& model : {model_file("cart_pole"), model_file("double_pendulum"),
                                   model_file("charged_particle"), shaken, lifted}) {
    const Stepped step(model, "midpoint");
    CHECK(local_order(step, somewhere(step), h) == Approx(3).margin(0.15));
  }
}

TEST_CASE("in C the step has the same bits") {
  Run cpp(lifted);
  Run c(lifted, "", "[emit]\nlanguage = \"c99\"\n");
  for (int i = 0; i < 100; ++i) {
    cpp.step(0.01);
    c.step(0.01);
  }
  CHECK(c.at().q == cpp.at().q);
  CHECK(c.at().v == cpp.at().v);
  CHECK(c.residual() == cpp.residual());
}

TEST_CASE("the energy swings and does not drift in a long run") {
  Run run(model_file("double_pendulum"));
  const double start = run.energy();
  double first = 0;  // the largest change in the first half of the run, and in the second
  double second = 0;
  double residual = 0;
  for (int i = 0; i < 100000; ++i) {
    run.step(0.005);
    residual = std::max(residual, run.residual());
    double& worst = i < 50000 ? first : second;
    worst = std::max(worst, std::abs(run.energy() - start));
  }
  CAPTURE(start, first, second, residual);
  CHECK(first < 1e-3 * std::abs(start));
  CHECK(second < 1.2 * first);
  CHECK(residual < 1e-11);
}

TEST_CASE("the momentum of a cyclic coordinate stays, however few the iterations are") {
  Run run(model_file("cart_pole"), ", iterations = 1");
  run.at().v = {0.5, 3};
  run.at().q = {0, 1};
  const double start = run.momentum(0);
  for (int i = 0; i < 10000; ++i) run.step(0.01);
  CHECK(run.momentum(0) == Approx(start).epsilon(1e-13));
  CHECK(run.residual() > 1e-9);
}

TEST_CASE("residuals shrink by about h with every iteration, down to rounding") {
  double last = 1;
  for (const int iterations : {1, 2, 3, 4}) {
    Run run(lifted, ", iterations = " + std::to_string(iterations));
    run.step(0.01);
    CHECK(run.residual() < last / 20);
    last = run.residual();
  }
  Run run(lifted);
  run.step(0.01);
  CHECK(run.residual() < 1e-15);
}

TEST_CASE("an M of numbers costs nothing, and what does not move is computed once") {
  const OperationCounts counts = count_operations(Stepped(shaken, "midpoint").function());
  CHECK(counts.div == 0);
  CHECK(counts.sincos == 9 + 1);  // sin(3 (t + h/2)) is that of all iterations
}

}  // namespace elgen::test
