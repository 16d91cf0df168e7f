"""Functions that branch on a number: values in `math`, and a choice for each element of arrays, tensors and symbols."""
import types
import warnings

from generated import flat, functions_of, module_of, root, state, value_at, written

code = module_of(root / "tests/emit/compiled/functions.toml")
orders = (1, 2, 3, 4, 7, 21, 40, -1, -2, -3, -4, -7, -21, -40)


def angles(order):
    """0, and numbers on both sides of the end of the series of stumpff."""
    border = (abs(order) * (abs(order) - 1) or 1) ** 0.5
    near = [border * (1 + part) for part in (-0.3, -1e-15, 0.0, 1e-15, 0.3)]
    return [0.0, -0.0, 1e-300, -1e-9, 20.0, -43.0, *near, *(-x for x in near)]


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


def check_series():
    """Arrays keep the digits of numbers on both sides, without warnings. numpy's sinh has an error of 4 ulp."""
    numpy = installed("numpy")
    if numpy is None:
        return
    stumpff = code.on(numpy)._stumpff
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for order in orders:
            found = stumpff(numpy.array(angles(order)), order)
            expected = [code._stumpff(x, order) for x in angles(order)]
            assert found.dtype == float and (abs(found / expected - 1) <= 4e-15).all(), (order, found, expected)
        assert (stumpff(numpy.array([0, 1, -5]), 2) == stumpff(numpy.array([0.0, 1.0, -5.0]), 2)).all()
        assert (abs(stumpff(numpy.array([1e160, -1e300]), 2)) < 1e-300).all()


def check_tensors():
    """Values and slopes of tensors. At 0 no branch gives NaN."""
    torch = installed("torch")
    if torch is None:
        return
    functions = code.on(torch)
    for order in orders:
        x = torch.tensor(angles(order), dtype=torch.float64, requires_grad=True)
        found = functions._stumpff(x, order)
        found.sum().backward()
        sign = 1 if order > 0 else -1
        for at, value, slope in zip(angles(order), found.tolist(), x.grad.tolist()):
            assert abs(value / code._stumpff(at, order) - 1) <= 4e-15, (order, at)
            next_ones = [code._stumpff(at, order + sign * i) for i in (1, 2)] if abs(order) < 39 else None
            if next_ones:
                expected = at * (order * next_ones[1] - sign * next_ones[0])
                assert abs(slope - expected) <= 1e-12 * max(abs(expected), abs(value)), (order, at, slope, expected)
    rate = torch.tensor([0.5, -0.5, 0.0], dtype=torch.float32)
    assert functions._sign_of(rate).tolist() == [1.0, -1.0, 0.0] and functions._sign_of(rate).dtype == torch.float32
    assert functions._larger(rate, 0.25).tolist() == [0.5, 0.25, 0.25]


def check_symbols():
    space = installed("sympy")
    if space is None:
        return
    x, functions = space.Symbol("x"), code.on(space)
    for order in (1, 2, 3, -1, -4):
        found = functions._stumpff(x, order)
        for at in (space.Rational(1, 10), space.Integer(9)):
            assert abs(found.subs(x, at).evalf(15) / code._stumpff(float(at), order) - 1) < 1e-14
        one, two = space.factorial(abs(order)), space.factorial(abs(order) + 2)
        assert found.subs(x, 0) == functions._stumpff(0, order) == 1 / one
        assert space.diff(found, x, 2).subs(x, 0) == (-2 if order > 0 else 2) / two
    assert [functions._sign_of(x).subs(x, at) for at in (-3, 0, 2)] == [-1, 0, 1]
    assert [functions._smaller(x, 1).subs(x, at) for at in (-3, 2)] == [-3, 1]
    assert functions.applied_force(functions.Parameters(), [0, 0], [x, 0])[0].subs(x, 1) == space.Rational(-1, 5)
    assert functions.mass_matrix(code.Parameters(), [0.0, 0.0])[0][0] == 0.6
    assert code.on(space) is code.on(space)


def check_integers():
    """Integers are exact in mpmath, too."""
    mpmath = installed("mpmath")
    if mpmath is not None:
        with mpmath.workdps(40):
            assert abs(code.on(mpmath)._stumpff(0, 3) * 6 - 1) < mpmath.mpf("1e-39")


def check_overflow():
    """A value too large for double is inf, as in C, and its reciprocal 0."""
    text = 'format = 1\n[model]\nname = "steep"\n[[coordinate]]\nname = "x"\n[energy]\nT = "1/2*dot(x)^2"\n'
    entries = '"1/(1 + exp(x))", "sinh(x)", "cosh(x)", "expm1(x)"'
    steep = written(f'{text}[[output]]\nname = "values"\nvalue = [{entries}]\n')
    infinity = float("inf")
    assert steep.values([1000.0]) == [0.0, infinity, infinity, infinity]
    assert steep.values([-1000.0]) == [1.0, -infinity, infinity, -1.0]
    assert steep.values([-infinity]) == [1.0, -infinity, infinity, -1.0]


def check_missing():
    """A function missing in a namespace is reported when it is called, not before."""
    cart_pole = module_of("cart_pole")
    poor = types.ModuleType("poor")
    functions = cart_pole.on(poor)
    assert functions.dissipation(cart_pole.Parameters(), [poor, poor], [poor, poor]) == [0.0, 0.0]
    try:
        functions.gravity(cart_pole.Parameters(), [poor, poor])
    except AttributeError as error:
        assert str(error) == "poor has no sin", error
    else:
        raise AssertionError("sin of nothing has a value")
    numpy = installed("numpy")
    if numpy is None:
        return
    try:
        code.on(poor)._sign_of(numpy.array([1.0]))
    except AttributeError as error:
        assert str(error) == "poor has no where", error
        return
    raise AssertionError("a choice by nothing has a value")


check_values()
check_arrays()
check_series()
check_tensors()
check_symbols()
check_integers()
check_overflow()
check_missing()
