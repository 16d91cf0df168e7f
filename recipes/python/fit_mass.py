# SPDX-License-Identifier: 0BSD
# Finds the mass of a bob from 200 measured accelerations with gradients of torch.
import random

import torch

import cart_pole

code = cart_pole.on(torch)
chance = random.Random(1)


def measurement(mass):
    """A random state and force, with accelerations as a noisy sensor measures them."""
    state = ([0.0, chance.uniform(-3, 3)], [chance.gauss(0, 1), chance.gauss(0, 3)], [chance.uniform(-20, 20)])
    a = cart_pole.forward_dynamics(cart_pole.Parameters(m=mass), *state).acceleration
    return (*state, [x + chance.gauss(0, 0.05) for x in a])


measurements = [measurement(mass=0.23) for _ in range(200)]
# The last axis numbers the states.
q, v, u, measured = (torch.tensor(each, dtype=torch.float64).T for each in zip(*measurements))

logarithm = torch.tensor(0.1, dtype=torch.float64).log().requires_grad_()  # keeps the mass positive
optimizer = torch.optim.LBFGS([logarithm], max_iter=50, line_search_fn="strong_wolfe")


def misfit():
    optimizer.zero_grad()
    p = cart_pole.Parameters(m=logarithm.exp())
    found = torch.stack(code.forward_dynamics(p, q, v, u).acceleration)
    loss = ((found - measured) ** 2).mean()
    loss.backward()
    return loss


optimizer.step(misfit)
print(f"m = {logarithm.exp().item():.3f} kg")
