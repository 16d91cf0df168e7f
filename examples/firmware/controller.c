// SPDX-License-Identifier: 0BSD
// After Spong, Corke, Lozano, Nonlinear control of the Reaction Wheel Pendulum, Automatica 37
// (2001). Only gravity changes the total angular momentum L about the axis:
// dL/dt = G sin(theta), G = m g l. The motor torque gives theta the acceleration
//   w = -(p^3/G) L - 3 p^2 theta - 3 p dtheta/dt,
// which near the upright position places three poles at -p = -6 /s. From rest at 0.05 rad this
// needs a torque of 0.045 N m.
#include "controller.h"

#include "reaction_wheel_pendulum_firmware/reaction_wheel_pendulum_firmware.h"

static const plant_parameters parameters = PLANT_DEFAULT_PARAMETERS;
static const float torque_limit = 0.05F;  // as in the model

float motor_torque(const float q[2], const float v[2]) {
  float momentum[2], gravity[2], mass[4];
  plant_momentum(&parameters, q, v, momentum);
  plant_gravity(&parameters, q, gravity);
  plant_mass_matrix(&parameters, q, mass);
  const float p = 6.0F, weight = parameters.m * parameters.g * parameters.l;
  const float wanted = -(p * p * p / weight * momentum[0] + 3 * p * p * q[0] + 3 * p * v[0]);
  // M a + g = (0, tau): no torque acts in the pendulum's row, which gives the wheel's acceleration.
  const float wheel = -(mass[0] * wanted + gravity[0]) / mass[1];
  const float torque = mass[2] * wanted + mass[3] * wheel;
  return torque > torque_limit ? torque_limit : torque < -torque_limit ? -torque_limit : torque;
}
