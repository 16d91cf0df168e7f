// SPDX-License-Identifier: 0BSD
#pragma once

/// The motor torque [N m] for angles q [rad] and rates v [rad/s] of the pendulum and the wheel.
float motor_torque(const float q[2], const float v[2]);
