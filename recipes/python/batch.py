# SPDX-License-Identifier: 0BSD
# Finds the starts from which a regulator catches the pole: NumPy simulates 10 201 carts at once.
import numpy

import cart_pole

code = cart_pole.on(numpy)
p = code.Parameters()
K = (-1.0, -30.615, -2.245, -6.723)  # gains of x, theta, dot(x), dot(theta)
low, high = cart_pole.input_limits[0]
step = 2e-3

angles = numpy.linspace(-1.5, 1.5, 101)
rates = numpy.linspace(-5.0, 5.0, 101)
theta, dtheta = (grid.ravel() for grid in numpy.meshgrid(angles, rates))
q, v = [0.0, theta], [0.0, dtheta]  # the last axis numbers the states
for _ in range(2000):
    u = numpy.clip(-sum(k * each for k, each in zip(K, [*q, *v])), low, high)
    a = code.forward_dynamics(p, q, v, [u]).acceleration
    v = [rate + step * each for rate, each in zip(v, a)]
    q = [place + step * each for place, each in zip(q, v)]
caught = abs(q[1]) < 0.1
print(f"{caught.mean():.0%} of {caught.size} starts are caught")
print(f"at rest up to {max(theta[caught & (dtheta == 0.0)]):.2f} rad")
