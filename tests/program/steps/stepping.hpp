// Derives the program of a step from the text of a model, and evaluates the program.
#pragma once

#include <cln/real.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "elgen/evaluate.hpp"
#include "elgen/oracle.hpp"
#include "elgen/pipeline.hpp"
#include "program/evaluate/subject.hpp"
#include "support/models.hpp"
#include "support/shell.hpp"

namespace elgen::test {

/// A model, and a scene that requests a step.
struct StepScene {
  std::string model;
  std::string method = {};
  std::string more = {};     ///< further keys of the step's entry, starting with a comma
  std::string outputs = {};  ///< further lines of [outputs]
  Goal goal = Goal::choose;
};

inline Products stepped(const StepScene& wanted) {
  const std::string scene =
      "format = 1\nmodel = \"test.toml\"\nname = \"next\"\n[outputs]\nstep = { method = \"" +
      wanted.method + "\"" + wanted.more + " }\n" + wanted.outputs;
  return run_pipeline(
      {make_source("test.toml", wanted.model), make_source("next.scene.toml", scene)},
      {.goals = {wanted.goal}});
}

/// The step as a function of states. The constructor throws the diagnostics if there is no program.
class StepProgram {
 public:
  StepProgram(const std::string& model, const std::string& method, const std::string& more = {})
      : products_(stepped({model, method, more})) {
    if (!products_.program) throw std::runtime_error(format(products_.diagnostics));
  }

  [[nodiscard]] const Model& model() const { return products_.checked->model; }
  [[nodiscard]] const Program& program() const { return *products_.program; }
  [[nodiscard]] const Function& function() const { return program().functions.back(); }
  /// The state with the parameters' values; other numbers are 0, quaternions (1, 0, 0, 0).
  [[nodiscard]] State origin() const { return nominal_state(model(), products_.checked->scene); }

  /// The new q and v, then the residual of an implicit method.
  template <class Scalar>
  [[nodiscard]] std::vector<Scalar> values(const State& state) const {
    return evaluate(program(), function(), arguments_at<Scalar>(state));
  }

  /// The state after `count` equal steps that together last state.h, in 60 digits.
  [[nodiscard]] State after(State state, int count) const {
    const cln::cl_R whole = state.h;
    state.h = whole / count;
    for (int i = 0; i < count; ++i) {
      const std::vector<cln::cl_R> next = *to_oracle_values(values<Real>(state));
      const auto middle = next.begin() + static_cast<std::ptrdiff_t>(state.q.size());
      state.q.assign(next.begin(), middle);
      state.v.assign(middle, middle + static_cast<std::ptrdiff_t>(state.v.size()));
      state.t = state.t + state.h;
    }
    state.h = whole;
    return state;
  }

 private:
  Products products_;
};

inline const std::string shaken = read_model("shaken");

/// A generic state in motion, with inputs, at t = 2/7.
inline State generic_state(const StepProgram& step) {
  State state = step.origin();
  const cln::cl_RA part = cln::cl_RA(1) / 7;
  for (std::size_t i = 0; i < state.q.size(); ++i) state.q[i] = state.q[i] + part * (1 + i);
  for (std::size_t i = 0; i < state.v.size(); ++i) state.v[i] = 1 - part * (3 * i);
  for (std::size_t i = 0; i < state.u.size(); ++i) state.u[i] = part * (5 + i);
  state.t = part * 2;
  set_rational_quaternions(step.model(), state);
  return state;
}

/// log2(error(h)/error(h/2)) for the error of a single step: the order of the method plus 1.
inline double local_order(const StepProgram& step, State state, const cln::cl_RA& h) {
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
