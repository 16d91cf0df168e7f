// Model texts -> the program of their step, and its values.
#pragma once

#include <cln/real.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "elgen/evaluate.hpp"
#include "elgen/oracle.hpp"
#include "elgen/pipeline.hpp"
#include "evaluate/subject.hpp"
#include "support/models.hpp"

namespace elgen::test {

/// A scene whose one output is a step by the method.
inline Products stepped(const std::string& model, const std::string& method) {
  const std::string scene =
      "format = 1\nmodel = \"test.toml\"\nname = \"next\"\n[outputs]\nstep = { method = \"" +
      method + "\" }\n";
  PipelineOptions options;
  options.goals = {"choose"};
  return run_pipeline({make_source("test.toml", model), make_source("next.scene.toml", scene)},
                      options);
}

/// The step as a function of states; throws what is wrong.
class Stepped {
 public:
  Stepped(const std::string& model, const std::string& method) : products_(stepped(model, method)) {
    if (!products_.program) throw std::runtime_error(format(products_.diagnostics));
  }

  [[nodiscard]] const Model& model() const { return products_.checked->model; }
  [[nodiscard]] const Program& program() const { return *products_.program; }
  [[nodiscard]] const Function& function() const { return program().functions.back(); }
  /// Parameters at their values, the rest 0.
  [[nodiscard]] State origin() const { return nominal_state(model(), products_.checked->scene); }

  /// q, then v.
  template <class Scalar>
  [[nodiscard]] std::vector<Scalar> values(const State& state) const {
    return evaluate(program(), function(), arguments_at<Scalar>(state));
  }

  /// `count` steps over the time state.h, in 60 digits.
  [[nodiscard]] State after(State state, int count) const {
    const cln::cl_R whole = state.h;
    state.h = whole / count;
    for (int i = 0; i < count; ++i) {
      const std::vector<cln::cl_R> next = *defined_values(values<Real>(state));
      const auto middle = next.begin() + static_cast<std::ptrdiff_t>(state.q.size());
      state.q.assign(next.begin(), middle);
      state.v.assign(middle, next.end());
      state.t = state.t + state.h;
    }
    state.h = whole;
    return state;
  }

 private:
  Products products_;
};

/// By how many powers of 2 the error of one step falls where the step is halved: its order plus 1.
inline double local_order(const Stepped& step, State state, const cln::cl_RA& h) {
  const auto error = [&](const cln::cl_R& length) {
    state.h = length;
    const State once = step.after(state, 1);
    const State truth = step.after(state, 64);
    cln::cl_R largest = 0;
    for (std::size_t i = 0; i < once.q.size(); ++i) {
      largest = cln::max(largest, cln::abs(once.q[i] - truth.q[i]));
    }
    for (std::size_t i = 0; i < once.v.size(); ++i) {
      largest = cln::max(largest, cln::abs(once.v[i] - truth.v[i]));
    }
    return largest;
  };
  return cln::double_approx(cln::log(error(h) / error(h / 2), 2));
}

}  // namespace elgen::test
