// The forces that hold what a scene locks, from the model in which it still moves.
#pragma once

#include "elgen/oracle.hpp"

namespace elgen::oracle {

/// The state of the model before locking: what is locked stands at its functions of time.
[[nodiscard]] State unlocked_state(const Model& model, const State& state);

/// w.(M a + bias - B u) of that model for w along each locked velocity that wants it.
[[nodiscard]] std::vector<cln::cl_R> reaction(const Model& model, const State& state);

}  // namespace elgen::oracle
