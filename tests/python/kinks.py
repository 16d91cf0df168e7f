"""Functions that branch on a number: they have values in `math` and mpmath; arrays and symbols are refused in words."""
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


def check_refusals():
    for package in ("numpy", "sympy"):
        try:
            space = __import__(package)
        except ImportError:
            print(f"skipped: {package} of Python is not installed")
            continue
        said = refusal(space, "applied_force")
        assert said in [f"{name} branches on one number: {package} has arrays or symbols" for name in ("sign", "min")]
        assert refusal(space, "gravity").startswith("stumpff branches on one number")
        assert code.on(space).mass_matrix(code.Parameters(), [0.0, 0.0])[0][0] == 0.6
        assert code.on(space) is code.on(space)


def check_missing():
    """A function that a space lacks is named where it is called, and not before."""
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
check_refusals()
check_missing()
