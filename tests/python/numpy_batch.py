"""Arrays of states along the last axis: every function of every model, at five states together and one by one."""
from generated import arguments, flat, functions_of, models, module_of, needs, state, value_at

needs("numpy")
import numpy

# numpy's vectorised sines have errors up to 4 ulp, `math` up to 1 ulp. Solutions with mass matrices
# lose up to four more digits.
most = 1e-10


def batch(states):
    """One array per number of a state, with its values in all states."""
    first = states[0]
    return {
        name: value
        if name == "p"
        else numpy.array([each[name] for each in states])
        if isinstance(value, float)
        else [numpy.array(column) for column in zip(*(each[name] for each in states))]
        for name, value in first.items()
    }


def compare(module, function, states):
    ones = [value_at(function, each) for each in states]
    states = [each for each, value in zip(states, ones) if value is not None]
    ones = numpy.array([value for value in ones if value is not None])
    if not states:
        return 0
    together = getattr(module.on(numpy), function.__name__)
    entries = flat(together(*arguments(function, batch(states))))
    assert all(isinstance(each, (float, numpy.ndarray)) for each in entries), function
    arrays = numpy.array([numpy.broadcast_to(each, len(states)) for each in entries]).T
    scale = max(1.0, abs(ones).max(initial=0.0))
    assert abs(arrays - ones).max(initial=0.0) <= most * scale, (module.__name__, function.__name__)
    return arrays.size


def check_all():
    compared = 0
    for path in models:
        module = module_of(path)
        states = [state(module, seed) for seed in range(5)]
        compared += sum(compare(module, each, states) for each in functions_of(module))
    print(f"{compared} entries of {len(models)} models")
    assert compared > 10000


def check_entries_that_are_numbers():
    code = module_of("cart_pole")
    theta = numpy.linspace(-3.0, 3.0, 7)
    gravity = code.on(numpy).gravity(code.Parameters(), [0.0, theta])
    assert gravity[0] == 0.0 and isinstance(gravity[0], float)
    assert numpy.array(numpy.broadcast_arrays(*gravity)).shape == (2, 7)


def check_arrays_of_parameters():
    code = module_of("cart_pole")
    masses = numpy.array([0.1, 0.2, 0.3])
    lots = code.on(numpy).mass_matrix(code.Parameters(m=masses), [0.0, 0.3])
    for i, mass in enumerate(masses):
        one = code.mass_matrix(code.Parameters(m=float(mass)), [0.0, 0.3])
        assert lots[0][1][i] == one[0][1]


def check_singular():
    """A singular matrix raises an error in `math`, and gives NaN in an array."""
    code = module_of("double_pendulum")
    with numpy.errstate(all="ignore"):
        masses = numpy.array([0.0, 1.0])
        found = code.on(numpy).forward_dynamics(code.Parameters(m1=masses, m2=masses), [0.1, 0.2], [0.0, 0.0])
    assert numpy.isnan(found.acceleration[0][0]) and numpy.isfinite(found.acceleration[0][1])
    try:
        code.forward_dynamics(code.Parameters(m1=0.0, m2=0.0), [0.1, 0.2], [0.0, 0.0])
    except ZeroDivisionError:
        return
    raise AssertionError("no exception")


check_entries_that_are_numbers()
check_arrays_of_parameters()
check_singular()
check_all()
