// A CompiledModel that interprets the program, with the sines of compiled code, and changes the
// first entry of one function.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "elgen/toolchain.hpp"
#include "program/evaluate/sines.hpp"

namespace elgen::test {

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
      const SineEvaluator<Scalar> sines(Scene{}, SineArithmetic::numbers);
      std::vector<Scalar> values = evaluate_as_emitted(program_, function, arguments, sines);
      if (name == function_) values[0] = static_cast<Scalar>(change_(values[0]));
      return values;
    }
    return {};
  }

  const Program& program_;
  std::string function_;
  std::function<double(double)> change_;
};

}  // namespace elgen::test
