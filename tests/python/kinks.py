"""Functions that branch on a number: values in `math`, in mpmath, and element by element in numpy's arrays.
Symbols are refused with a message."""
from generated import arguments, flat, functions_of, module_of, root, state, value_at

code = module_of(root / "tests/emit/compiled/functions.toml")


def refusal(space, function):
    call = getattr(code.on(space), function)
    try:
        call(*arguments(getattr(code, function), state(code, 1)))
    except TypeError as error:
        return str(error)
    raise AssertionError(f"{function} has a value on {space.__name__}")


def check_values():
    p = code.Parameters()
    assert code.applied_force(p, [0.0, 0.0], [0.5, 0.0])[0] == -p.f - p.f
    assert code.applied_force(p, [0.0, 0.0], [-0.5, 0.0])[0] == p.f - p.f * (-0.5 / p.w)
    assert flat(code.applied_force(p, [0.0, 0.0], [0.0, 0.0])) == [0.0, 0.0]
    assert all(value_at(each, state(code, 1)) for each in functions_of(code))


def installed(package):
    try:
        return __import__(package)
    except ImportError:
        print(f"skipped: {package} of Python is not installed")
        return None


def check_arrays():
    numpy = installed("numpy")
    if numpy is None:
        return
    p = code.Parameters()
    functions = code.on(numpy)
    # stumpff(theta, -4) uses its series up to theta^2 = 12.
    angles = [-7.5, -3.4641, -1.0, -1e-300, 0.0, 0.25, 3.0, 3.5, 20.0]
    found = functions.gravity(p, [0.0, numpy.array([angles, angles])])[1]
    assert found.shape == (2, len(angles)) and found.dtype == float
    for column, angle in enumerate(angles):
        one = code.gravity(p, [0.0, angle])[1]
        assert max(abs(found[:, column] - one)) <= 1e-12 * abs(one), angle
    rates = [-2.0, -p.w / 3, 0.0, 0.0005, 7.0]
    found = functions.applied_force(p, [0.0, 0.0], [numpy.array(rates), 0.0])[0]
    assert list(found) == [code.applied_force(p, [0.0, 0.0], [rate, 0.0])[0] for rate in rates]
    # Numbers use `math`, which raises at inf. In an array only this element is NaN.
    assert functions.gravity(p, [0.0, 0.25]) == code.gravity(p, [0.0, 0.25])
    assert value_at(code.gravity, {"p": p, "q": [0.0, float("inf")]}) is None
    with numpy.errstate(all="ignore"):
        found = functions.gravity(p, [0.0, numpy.array([numpy.inf, 0.25])])[1]
    assert numpy.isnan(found[0]) and abs(found[1] / code.gravity(p, [0.0, 0.25])[1] - 1) < 1e-12


def check_refusals():
    space = installed("sympy")
    if space is None:
        return
    said = refusal(space, "applied_force")
    assert said in [f"{name} branches on one number: sympy has arrays or symbols" for name in ("sign", "min")]
    assert refusal(space, "gravity").startswith("stumpff branches on one number")
    assert code.on(space).mass_matrix(code.Parameters(), [0.0, 0.0])[0][0] == 0.6
    assert code.on(space) is code.on(space)


def check_missing():
    """A function missing in a namespace is reported when it is called, not before."""
    import types

    cart_pole = module_of("cart_pole")
    poor = types.ModuleType("poor")
    functions = cart_pole.on(poor)
    assert functions.dissipation(cart_pole.Parameters(), [poor, poor], [poor, poor]) == [0.0, 0.0]
    try:
        functions.gravity(cart_pole.Parameters(), [poor, poor])
    except AttributeError as error:
        assert str(error) == "poor has no sin", error
        return
    raise AssertionError("sin of nothing has a value")


check_values()
check_arrays()
check_refusals()
check_missing()
