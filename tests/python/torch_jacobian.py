"""The Jacobian of the accelerations by torch equals `linearization`."""
from generated import arguments, flat, module_of, needs, state

needs("torch")
import torch

# Both sides have a few hundred rounding errors of 1e-16, relative to the largest entry.
most = 1e-13


def tensors(values, names):
    return [torch.tensor(values[name], dtype=torch.float64, requires_grad=True) for name in names]


def check(model):
    module = module_of(model)
    code = module.on(torch)
    for seed in range(4):
        values = state(module, seed)
        u = values["u"]

        def rates(q, v, *inputs):
            found = code.forward_dynamics(values["p"], q, v, inputs[0] if inputs else u)
            return torch.stack([torch.as_tensor(x, dtype=torch.float64) for x in [*v, *found.acceleration]])

        names = ("q", "v", "u") if u else ("q", "v")
        blocks = torch.autograd.functional.jacobian(rates, tuple(tensors(values, names)))
        ours = module.linearization(*arguments(module.linearization, values))
        expected = torch.tensor(ours.A, dtype=torch.float64)
        if u:
            expected = torch.cat([expected, torch.tensor(ours.B, dtype=torch.float64)], dim=1)
        difference = (torch.cat(blocks, dim=1) - expected).abs().max()
        assert difference <= most * max(1.0, expected.abs().max()), (model, seed, difference)


def check_parameters():
    """A gradient by a parameter, with numbers and tensors mixed."""
    code = module_of("cart_pole")
    mass = torch.tensor(0.1, dtype=torch.float64, requires_grad=True)
    energy = code.on(torch).kinetic_energy(code.Parameters(m=mass), [0.0, 0.3], [0.2, 0.7])
    energy.backward()
    step = 0.01
    more, less = (code.kinetic_energy(code.Parameters(m=0.1 + h), [0.0, 0.3], [0.2, 0.7]) for h in (step, -step))
    assert abs(mass.grad.item() - (more - less) / (2 * step)) < 1e-12  # the energy is linear in m


def check_blocks():
    """Blocks of states, joined along the last axis."""
    code = module_of("cart_pole").on(torch)
    theta = torch.linspace(-1.0, 1.0, 10, dtype=torch.float64)
    whole, joined = (code.blocks(code.gravity, code.Parameters(), [0.0, theta], size=size) for size in (10, 3))
    assert whole[0] == joined[0] == 0.0 and torch.allclose(whole[1], joined[1], rtol=1e-14, atol=0.0)


def check_pairs():
    """Functions of two arguments accept a tensor and a number."""
    from generated import written

    code = written(
        """format = 1
[model]
name = "plane"
[[coordinate]]
name = "x"
unit = "m"
[[coordinate]]
name = "y"
unit = "m"
[parameters]
m = { value = 1, unit = "kg" }
l = { value = 0.3, unit = "m" }
k = { value = 2, unit = "J" }
[energy]
T = "1/2*m*(dot(x)^2 + dot(y)^2)"
V = "k*atan2(y, l)^2 + k*atan2(x, y)"
"""
    )
    q = torch.tensor([0.4, 0.7], dtype=torch.float64, requires_grad=True)
    code.on(torch).potential_energy(code.Parameters(), q).backward()
    expected = code.gravity(code.Parameters(), [0.4, 0.7])
    assert max(abs(one - other) for one, other in zip(q.grad.tolist(), expected)) < 1e-14


for model in ("cart_pole", "double_pendulum", "furuta_pendulum", "two_link_arm", "chain", "elastic_pendulum"):
    check(model)
check_parameters()
check_blocks()
check_pairs()
