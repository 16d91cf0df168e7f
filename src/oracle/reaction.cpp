// Reaction: nothing of the locked model is used but which of its entries stand where.
#include "oracle/reaction.hpp"

#include "oracle/mechanics.hpp"

namespace elgen::oracle {
namespace {

using cln::cl_R;

/// Puts the entries of `from`, in order, where `to` is not taken.
void fill_free(std::vector<cl_R>& to, const std::vector<bool>& taken,
               const std::vector<cl_R>& from) {
  std::size_t next = 0;
  for (std::size_t i = 0; i < to.size(); ++i) {
    if (!taken[i]) to[i] = from[next++];
  }
}

}  // namespace

State unlocked_state(const Model& model, const State& state) {
  const Model& unlocked = *model.unlocked;
  State whole = state;
  whole.q.assign(unlocked.coordinates.size(), cl_R(0));
  whole.v.assign(unlocked.velocities.size(), cl_R(0));
  whole.a = whole.v;
  std::vector<bool> locked_coordinates(whole.q.size());
  std::vector<bool> locked_velocities(whole.v.size());
  for (const Lock& lock : unlocked.locks) {
    for (std::uint32_t i = 0; i < lock.values.size(); ++i) {
      locked_coordinates[lock.coordinate + i] = true;
      const Motion motion = motion_of(whole);
      Evaluation at(unlocked, motion);
      whole.q[lock.coordinate + i] = at.value(lock.values[i]).real();
      if (lock.is_rotation) continue;
      whole.v[lock.velocity] = at.rate(lock.values[i]).real();
      whole.a[lock.velocity] = at.second_rate(lock.values[i]).real();
    }
    for (std::uint32_t i = 0; i < lock.velocity_count(); ++i) {
      locked_velocities[lock.velocity + i] = true;
    }
  }
  fill_free(whole.q, locked_coordinates, state.q);
  fill_free(whole.v, locked_velocities, state.v);
  fill_free(whole.a, locked_velocities, state.a);
  return whole;
}

std::vector<cl_R> reaction(const Model& model, const State& state) {
  const std::vector<std::uint32_t> held = held_velocities(model);
  if (held.empty()) return {};
  const State whole = unlocked_state(model, state);
  Mechanics at(*model.unlocked, whole);
  std::vector<cl_R> values;
  for (const std::uint32_t velocity : held) {
    const Direction w = at.unit(velocity);
    values.push_back(at.inverse_dynamics(w, whole.a) -
                     (whole.u.empty() ? cl_R(0) : at.input_force(w, whole.u)));
  }
  return values;
}

}  // namespace elgen::oracle
