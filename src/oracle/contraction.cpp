// Contractions: an output contracted with directions, so that a big matrix costs as little as one
// entry.
#include <cln/exception.h>

#include "elgen/oracle.hpp"
#include "mechanics.hpp"
#include "output_values.hpp"

namespace elgen {
namespace {

using cln::cl_R;
using oracle::Direction;
using oracle::Mechanics;

/// 2 C_ij = dM_ij/dt + R_ij - R_ji, dM/dt along v, R_ij = d/dq_j (M v)_i
cl_R coriolis(Mechanics& at, const Direction& w, const Direction& y) {
  const Direction& v = at.state().v;
  return (at.mass_gradient(v, w, y) + at.mass_gradient(y, w, v) - at.mass_gradient(w, y, v)) / 2;
}

cl_R bias(Mechanics& at, const Direction& w) {
  return at.inverse_dynamics(w, Direction(at.size(), cl_R(0)));
}

cl_R drift(Mechanics& at, const Direction& w) {
  return bias(at, w) - coriolis(at, w, at.state().v) - at.gravity(w) - at.dissipation_force(w) +
         at.applied_force(w);
}

cl_R input_force(Mechanics& at, const Direction& w, const Direction& y) {
  cl_R sum = 0;
  for (std::size_t k = 0; k < y.size(); ++k) sum = sum + y[k] * at.input_force(w, k);
  return sum;
}

cl_R contracted(const std::vector<cl_R>& entries, const Contraction& by) {
  cl_R sum = 0;
  const std::size_t columns = by.y.empty() ? 1 : by.y.size();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const cl_R term = by.w[i / columns] * entries[i];
    sum = sum + (by.y.empty() ? term : term * by.y[i % columns]);
  }
  return sum;
}

cl_R contraction(const Model& model, const OutputRequest& output, const State& state,
                 const Contraction& by) {
  Mechanics at(model, state);
  switch (output.kind) {
    case OutputKind::mass_matrix:
      return at.mass(by.w, by.y);
    case OutputKind::coriolis_matrix:
      return coriolis(at, by.w, by.y);
    case OutputKind::velocity_force:
      return coriolis(at, by.w, state.v);
    case OutputKind::gravity:
      return at.gravity(by.w);
    case OutputKind::drift:
      return drift(at, by.w);
    case OutputKind::dissipation:
      return at.dissipation_force(by.w);
    case OutputKind::applied_force:
      return at.applied_force(by.w);
    case OutputKind::bias:
      return bias(at, by.w);
    case OutputKind::momentum:
      return at.momentum(by.w);
    case OutputKind::input_matrix:
      return input_force(at, by.w, by.y);
    case OutputKind::inverse_dynamics:
      return at.inverse_dynamics(by.w, state.a);
    default:
      return contracted(oracle::output_values(model, output, state), by);
  }
}

}  // namespace

std::optional<cl_R> oracle_contraction(const Model& model, const OutputRequest& output,
                                       const State& state, const Contraction& by) {
  try {
    return contraction(model, output, state, by);
  } catch (const cln::runtime_exception&) {
    return std::nullopt;
  } catch (const oracle::OutsideDomain&) {
    return std::nullopt;
  }
}

}  // namespace elgen
