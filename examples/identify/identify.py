# SPDX-License-Identifier: 0BSD
"""Estimates the base parameters of an arm from noisy torques by least squares (Gautier, Khalil, IEEE Trans. Robotics
and Automation 6(3), 1990). In tau = Y(q, v, a) pi + rest only the columns of the base parameters are independent."""
import json
import sys

import numpy as np

import panda7_identify as arm

STATES = 200
NOISE = 0.05  # N*m, standard deviation of the torque noise


def samples(random):
    """Random states inside the ranges of the model: the rows of Y and the noisy torques minus the rest."""
    p = arm.Parameters()
    for _ in range(STATES):
        q, v = (random.uniform(*np.transpose(ranges)) for ranges in (arm.coordinate_ranges, arm.rate_ranges))
        a = random.uniform(-10, 10, len(q))
        y = arm.regressor(p, q, v, a)
        rows = np.reshape(y.matrix, (len(q), -1))
        torque = np.array(arm.inverse_dynamics(p, q, v, a)) + random.normal(0, NOISE, len(q))
        yield rows, torque - y.rest


def base_matrix(base):
    """The matrix B of beta = B pi: base parameters as combinations of all parameters."""
    matrix = np.zeros((len(base), len(arm.regressor_names)))
    for row, combination in zip(matrix, base):
        for name, factor in combination["parameters"].items():
            row[arm.regressor_names.index(name)] = factor
    return matrix


def main(file):
    with open(file) as text:
        base = json.load(text)["base"]
    kept = [arm.regressor_names.index(next(iter(each["parameters"]))) for each in base]
    truth = base_matrix(base) @ arm.regressor_parameters(arm.Parameters())
    rows, torques = map(np.concatenate, zip(*samples(np.random.default_rng(1))))
    y = rows[:, kept]
    found, *_ = np.linalg.lstsq(y, torques, rcond=None)
    deviations = NOISE * np.sqrt(np.diag(np.linalg.inv(y.T @ y)))
    worst = np.max(np.abs(found - truth) / deviations)
    exact = np.max(np.abs(y @ truth - rows @ arm.regressor_parameters(arm.Parameters())))
    print(f"{len(kept)} of {rows.shape[1]} parameters, condition {np.linalg.cond(y / np.linalg.norm(y, axis=0)):.0f}")
    print(f"forces of the base parameters differ by {exact:.0e} N*m at most")
    print(f"found from {STATES} states to {worst:.1f} standard deviations at most")
    return int(worst > 4 or exact > 1e-12)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
