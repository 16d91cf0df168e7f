// SPDX-License-Identifier: 0BSD
// Balances a reaction wheel pendulum at 1 kHz for five seconds, from 0.05 rad to below 2e-3 rad.
// The control law is in controller.c. The pendulum is simulated here: on a real board reading the
// encoders replaces `plant_step`.
#include "board.h"
#include "controller.h"
#include "reaction_wheel_pendulum_firmware/reaction_wheel_pendulum_firmware.h"

enum { STEPS = 5000 };

// With `-icount shift=5` QEMU advances time by 2^5 ns per instruction, and a tick of the 25 MHz
// timer is 40 ns. So t ticks are t 40/32 instructions, including one reading of the timer.
static uint32_t instructions_a_step(uint32_t ticks) { return ticks * 5 / 4 / STEPS; }

static uint32_t millionths(float number) {
  return (uint32_t)((number < 0.0F ? -number : number) * 1e6F + 0.5F);
}

int main(void) {
  const plant_parameters parameters = PLANT_DEFAULT_PARAMETERS;
  plant_step_result state = {{0.05F, 0.0F}, {0.0F, 0.0F}};
  uint32_t controlling = 0, simulating = 0, settled = 0;
  for (uint32_t i = 1; i <= STEPS; ++i) {
    const uint32_t before = timer();
    const float torque = motor_torque(state.coordinates, state.rates);
    const uint32_t between = timer();
    const plant_step_result last = state;
    plant_step(&parameters, last.coordinates, last.rates, &torque, 1e-3F, &state);
    simulating += (between - timer()) & 0xFFFFFF;
    controlling += (before - between) & 0xFFFFFF;
    if (millionths(state.coordinates[0]) >= 2000) settled = i;
  }
  const uint32_t angle = millionths(state.coordinates[0]);
  print("angle ", angle, " urad after 5 s, ");
  print("below 2000 urad from ", settled, " ms on\n");
  print("control law: ", instructions_a_step(controlling), " instructions a step, ");
  print("simulated pendulum: ", instructions_a_step(simulating), "\n");
  return angle < 2000 ? 0 : 1;
}
