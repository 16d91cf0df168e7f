// Compiles the emitted step of a model, and calls the step repeatedly.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "elgen/toolchain.hpp"
#include "program/steps/stepping.hpp"

namespace elgen::test {

/// Compiles the emitted step and energies of a model, and integrates from its start.
class CompiledStep {
 public:
  /// The default method is midpoint. `wanted.outputs` is appended to the outputs that this class
  /// needs.
  explicit CompiledStep(StepScene wanted) : products_(stepped(emitted(std::move(wanted)))) {
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
  [[nodiscard]] double residual() const {
    return residual_;
  }  ///< largest |residual| of the last step
  [[nodiscard]] double energy() const { return code().call("energy_function", at_).front(); }
  [[nodiscard]] double momentum(std::size_t i) const { return code().call("momentum", at_)[i]; }

 private:
  static StepScene emitted(StepScene wanted) {
    if (wanted.method.empty()) wanted.method = "midpoint";
    wanted.outputs = "energy_function = true\nmomentum = true\n" + wanted.outputs;
    wanted.goal = Goal::emit;
    return wanted;
  }

  [[nodiscard]] const CompiledModel& code() const { return *headers_.front().functions; }

  Products products_;
  CompiledHeaders headers_;
  Arguments<double> at_;
  double residual_ = 0;
};

}  // namespace elgen::test
