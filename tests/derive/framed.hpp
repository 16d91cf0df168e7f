// A system of frames: its derived outputs as numbers with 60 digits, and the same outputs by the
// oracle, which knows frames only as positions and angular velocities in the world.
#pragma once

#include <algorithm>

#include "derive/lagrangian/derivation.hpp"
#include "elgen/equations_of_motion.hpp"
#include "elgen/oracle.hpp"
#include "elgen/specialise.hpp"
#include "support/systems.hpp"

namespace elgen::test {

using Reals = std::vector<cln::cl_R>;

/// A state in which no coordinate, rate, acceleration or input is 0.
inline State some_state(const CheckedModel& checked, int sample = 1) {
  const Model& model = checked.model;
  State state = nominal_state(model, checked.scene);
  int seed = 3 + 7 * sample;
  const auto next = [&] {
    seed += 5;
    return cln::cl_RA(1 + seed % 13) / 17;
  };
  for (cln::cl_R& q : state.q) q = next();
  for (cln::cl_R& v : state.v) v = next() - cln::cl_RA(1) / 3;
  for (cln::cl_R& a : state.a) a = next() - cln::cl_RA(1) / 2;
  for (cln::cl_R& u : state.u) u = next();
  state.t = next();
  return state;
}

inline bool nearly_equal(const Reals& a, const Reals& b, int digits = 40) {
  const cln::cl_R tolerance = cln::expt(cln::cl_RA(10), -digits);
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](const cln::cl_R& x, const cln::cl_R& y) {
                      return cln::abs(x - y) <= tolerance * (1 + cln::abs(y));
                    });
}

/// Evaluates expressions and their definitions at a state, in 60 digits.
class NumbersAt {
 public:
  NumbersAt(const Symbols& symbols, const Definitions& definitions, const State& state) {
    GiNaC::Digits = 60;
    set(symbols.parameters, state.parameters);
    set(symbols.q, state.q);
    set(symbols.v, state.v);
    set(symbols.a, state.a);
    set(symbols.u, state.u);
    set({symbols.t}, {state.t});
    for (const Definition& definition : definitions.list) {
      known_[definition.symbol] = number(definition.value);
    }
  }

  [[nodiscard]] cln::cl_R operator()(const GiNaC::ex& value) const {
    return cln::the<cln::cl_R>(GiNaC::ex_to<GiNaC::numeric>(number(value)).to_cl_N());
  }

  [[nodiscard]] Reals operator()(const RealVector& values) const {
    Reals result;
    for (const GiNaC::ex& value : values) result.push_back((*this)(value));
    return result;
  }

 private:
  void set(const std::vector<GiNaC::ex>& leaves, const Reals& values) {
    for (std::size_t i = 0; i < leaves.size(); ++i) known_[leaves[i]] = GiNaC::numeric(values[i]);
  }

  [[nodiscard]] GiNaC::ex number(const GiNaC::ex& value) const {
    return value.subs(known_, GiNaC::subs_options::no_pattern).evalf();
  }

  GiNaC::exmap known_;
};

class Framed {
 public:
  explicit Framed(const std::string& text, const SceneOptions& options = {})
      : checked(checked_model(text, options)),
        lagrangian(*specialise(*formulate(checked.model), checked)) {}

  [[nodiscard]] const OutputRequest& request(const std::string& name) const {
    for (const OutputRequest& output : checked.scene.outputs) {
      if (output.name == name) return output;
    }
    throw std::runtime_error(name + " is not an output of this model");
  }

  /// The derived entries of all fields of the output `name`.
  [[nodiscard]] RealVector derived(const std::string& name) {
    equations_ = *derive(lagrangian, {request(name)}, {});
    RealVector entries;
    for (const FieldEquations& field : equations_.outputs.front().fields) {
      entries.insert(entries.end(), field.entries.begin(), field.entries.end());
    }
    return entries;
  }

  /// The derived entries of the output `name` at `state`, as numbers with 60 digits.
  [[nodiscard]] Reals derived(const std::string& name, const State& state) {
    const RealVector entries = derived(name);
    return NumbersAt(equations_.symbols, equations_.definitions, state)(entries);
  }

  [[nodiscard]] Reals expected(const std::string& name, const State& state) const {
    const OutputRequest& wanted = request(name);
    const bool is_value =
        wanted.kind != OutputKind::user_jacobian && wanted.kind != OutputKind::user_bias;
    if (is_value || !checked.model.outputs[wanted.user].frame) {
      Reals values = *oracle_values(checked.model, wanted, state);
      if (wanted.kind == OutputKind::forward_dynamics) append_diagonal(values, state);
      return values;
    }
    const std::vector<ExpressionId>& twist = checked.model.outputs[wanted.user].twist;
    return wanted.kind == OutputKind::user_jacobian ? twist_slopes(twist, state)
                                                    : twist_rates(twist, state);
  }

  [[nodiscard]] bool agrees(const std::string& name) {
    const RealVector entries = derived(name);
    for (const int sample : {1, 2}) {
      const State state = some_state(checked, sample);
      const NumbersAt at(equations_.symbols, equations_.definitions, state);
      if (!nearly_equal(at(entries), expected(name, state))) return false;
    }
    return true;
  }

  [[nodiscard]] std::size_t size() const { return checked.model.velocities.size(); }

  /// The definitions of the last derived output.
  [[nodiscard]] const Definitions& definitions() const { return equations_.definitions; }

  CheckedModel checked;
  Lagrangian lagrangian;

 private:
  /// Appends the diagonal of M, which is derived together with the pivots.
  void append_diagonal(Reals& values, const State& state) const {
    const Reals mass = *oracle_values(checked.model, request("mass_matrix"), state);
    for (std::size_t i = 0; i < size(); ++i) values.push_back(mass[i * (size() + 1)]);
  }

  /// d(`twist`)/dv, row by row: the value at v_j = 1 and other v = 0, minus the value at v = 0.
  [[nodiscard]] Reals twist_slopes(const std::vector<ExpressionId>& twist, State state) const {
    Reals result;
    for (const ExpressionId entry : twist) {
      for (cln::cl_R& v : state.v) v = 0;
      const cln::cl_R at_rest = *oracle_expression_value(checked.model, entry, state);
      for (cln::cl_R& v : state.v) {
        v = 1;
        result.push_back(*oracle_expression_value(checked.model, entry, state) - at_rest);
        v = 0;
      }
    }
    return result;
  }

  [[nodiscard]] Reals twist_rates(const std::vector<ExpressionId>& twist, State state) const {
    for (cln::cl_R& a : state.a) a = 0;
    Reals result;
    for (const ExpressionId entry : twist) {
      result.push_back(*oracle_expression_rate(checked.model, entry, state));
    }
    return result;
  }

  EquationsOfMotion equations_;
};

}  // namespace elgen::test
