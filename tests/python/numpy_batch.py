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


def check_pivots():
    """The tests of pivots have one result for each state."""
    code = module_of("double_pendulum")
    found = [numpy.array([1.0, 0.5, numpy.nan, 1.0]), numpy.array([1e-3, 1e-17, 1.0, 1e-15])]
    ones = list(zip(*found))
    functions = code.on(numpy)
    assert functions.is_regular(found).tolist() == [True, False, False, True] == [*map(code.is_regular, ones)]
    assert numpy.allclose(functions.digits_left(found), [*map(code.digits_left, ones)], rtol=1e-15, atol=0.0)
    assert functions.digits_left([1.0, 0.5]) == code.digits_left([1.0, 0.5])


def check_stack():
    """Axes of states, then rows, then columns; entries that are numbers are repeated for every state."""
    module = module_of("cart_pole")
    code, p = module.on(numpy), module.Parameters()
    theta = numpy.linspace(-3.0, 3.0, 7)
    rows = code.linearization(p, [0.0, theta], [0.0, 0.5], [0.0]).A
    matrix = code.stack(rows)
    assert matrix.shape == (7, 4, 4)
    for i in range(4):
        for j in range(4):
            assert (matrix[:, i, j] == rows[i][j]).all(), (i, j)
    assert rows[3][1].shape == (7,) and rows[0][2] == 1.0 and rows[2][0] == 0.0
    assert code.stack(code.gravity(p, [0.0, theta])).shape == (7, 2)
    assert code.stack(code.mass_matrix(p, [0.0, theta.reshape(7, 1)])).shape == (7, 1, 2, 2)
    assert code.stack(code.mass_matrix(p, [0.0, 0.3])).shape == (2, 2)
    found = code.stack(code.forward_dynamics(p, [0.0, theta], [0.0, 0.0], [0.0]))
    assert found.acceleration.shape == found.relative_pivots.shape == (7, 2)
    assert code.stack([[], []]).shape == (2, 0)


def parts_of(value):
    return [part for each in value for part in parts_of(each)] if isinstance(value, (list, tuple)) else [value]


def check_blocks():
    """Blocks give the structure and the bits of all states at once, also if the last block is shorter."""
    module = module_of("cart_pole")
    code = module.on(numpy)
    chance = numpy.random.default_rng(1)
    q, v, u = (chance.normal(size=(rows, 1000)) for rows in (2, 2, 1))
    p = module.Parameters(m=chance.uniform(0.1, 1.0, 1000))
    for name in ("mass_matrix", "forward_dynamics", "linearization", "input_matrix", "potential_energy"):
        function = getattr(code, name)
        given = arguments(function, {"p": p, "q": q, "v": v, "u": u})
        whole = function(*given)
        sizes = []

        def counted(*x):
            sizes.append(x[1][1].shape[-1])
            return function(*x)

        for size in (1, 300, 999, 1000, 8192):
            sizes.clear()
            found = code.blocks(counted, *given, size=size)
            assert max(sizes) <= size and sum(sizes) == 1000, (name, size)
            assert type(found) is type(whole)
            for one, other in zip(parts_of(found), parts_of(whole), strict=True):
                assert numpy.array_equal(one, other) and type(one) is type(other), (name, size)
    # A number, and a single state with its 2 entries in one array, belong to all blocks.
    one = code.blocks(code.bias, module.Parameters(), numpy.array([0.1, 0.2]), [0.3, v[1]], size=100)
    assert numpy.array_equal(one[0], code.bias(module.Parameters(), [0.1, 0.2], [0.3, v[1]])[0])
    assert code.blocks(code.gravity, p, [0.0, 0.1], size=7)[1].shape == (1000,)


check_entries_that_are_numbers()
check_pivots()
check_stack()
check_blocks()
check_arrays_of_parameters()
check_singular()
check_all()
