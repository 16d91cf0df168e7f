// StepContext: the leaves that every method starts from.
#include "integrate/methods.hpp"

namespace elgen {

StepContext::StepContext(const Model& the_model, const OutputRequest& request,
                         const Program& the_calls, Composition& composition)
    : model(the_model),
      calls(the_calls),
      compose(composition),
      iterations(request.iterations),
      h(compose.leaf(Opcode::step)),
      start{compose.leaves(Opcode::coordinate, model.coordinates.size()),
            compose.leaves(Opcode::velocity, model.velocities.size()),
            model.uses_time ? compose.leaf(Opcode::time) : 0},
      half(compose.add(Opcode::multiply, compose.number(cln::cl_RA(1) / 2), h)) {}

std::uint32_t StepContext::time_after(std::uint32_t c) const {
  return model.uses_time ? compose.add(Opcode::add, start.t, c) : 0;
}

void StepContext::name(const CallPoint& at) const {
  compose.name(at.q, Opcode::coordinate, at.number);
  compose.name(at.v, Opcode::velocity, at.number);
}

}  // namespace elgen
