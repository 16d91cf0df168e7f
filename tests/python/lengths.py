"""Every call checks the lengths of its arguments, also for matrices of CasADi, which do not iterate."""
import inspect
import math
import types

from generated import arguments, flat, functions_of, models, module_of, state


def refusal(call, *values):
    try:
        call(*values)
    except ValueError as error:
        assert error.__cause__ is None and error.__suppress_context__, "two errors are shown"
        return str(error)
    raise AssertionError(f"{call.__name__} takes {values}")


def check_every_argument():
    """One entry more or less is an error in every function of every model."""
    refused = 0
    for path in models:
        module = module_of(path)
        values = state(module, 1)
        for function in functions_of(module):
            for name in inspect.signature(function).parameters:
                if not isinstance(values[name], list):
                    continue
                length = len(values[name])
                for wrong in ([*values[name], 0.5], values[name][1:]):
                    if len(wrong) == length:  # no entries
                        continue
                    said = refusal(function, *arguments(function, {**values, name: wrong}))
                    assert said == f"{function.__name__}: {name} needs length {length}, has {len(wrong)}", said
                    refused += 1
    print(f"{refused} calls of {len(models)} models are refused")
    assert refused > 4000


def check_messages():
    code = module_of("cart_pole")
    p = code.Parameters()
    assert refusal(code.gravity, p, [0.1]) == "gravity: q needs length 2, has 1"
    assert refusal(code.gravity, p, (0.1, 0.2, 0.3)) == "gravity: q needs length 2, has 3"
    assert refusal(code.gravity, p, 0.1) == "gravity: q needs length 2, has none (float)"
    assert refusal(code.gravity, p, None) == "gravity: q needs length 2, has 0"
    said = refusal(code.forward_dynamics, p, [0.1, 0.2], [0.0], [])  # two wrong arguments
    assert said == "forward_dynamics: v needs length 2, has 1"


def check_other_errors():
    """An error that is not about a length stays as it is."""

    class Broken:
        def __len__(self):
            return 2

        def __iter__(self):
            raise KeyError("mine")

    code = module_of("cart_pole")
    try:
        code.gravity(code.Parameters(), Broken())
    except KeyError as error:
        assert error.args == ("mine",)
        return
    raise AssertionError("no error")


def check_models_without_inputs():
    """Without inputs, u is () or None, and a last u may be missing."""
    code = module_of("double_pendulum")
    state_of = (code.Parameters(), [0.1, 0.2], [0.3, 0.4])
    expected = code.forward_dynamics(*state_of)
    assert all(code.forward_dynamics(*state_of, u) == expected for u in ((), [], None))
    assert refusal(code.forward_dynamics, *state_of, [1.0]) == "forward_dynamics: u needs length 0, has 1"
    lift = module_of("pendulum_in_lift")
    assert list(inspect.signature(lift.forward_dynamics).parameters) == ["p", "q", "v", "u", "t"]
    state_of = (lift.Parameters(), [0.1], [0.3])
    assert lift.forward_dynamics(*state_of, None, 0.5) == lift.forward_dynamics(*state_of, (), 0.5)


class SX:
    """A column like casadi.SX: it does not iterate, and has no length and no truth value."""

    __iter__ = None

    def __init__(self, *rows):
        self.rows = rows
        self.shape = (len(rows), 1)

    def __bool__(self):
        raise AssertionError("truth value of a symbol")


def value_of(x):
    assert not isinstance(x, SX) or len(x.rows) == 1, "arithmetic with a whole matrix"
    return x.rows[0] if isinstance(x, SX) else x


def operation(name):
    compute = getattr(float, f"__{name}__")
    return lambda *x: SX(compute(*(float(value_of(each)) for each in x)))


for each in "add sub mul truediv radd rsub rmul rtruediv neg pos gt".split():
    setattr(SX, f"__{each}__", operation(each))


def casadi():
    space = types.ModuleType("casadi")
    for name in ("sin", "cos", "sqrt", "fabs"):
        compute = getattr(math, name)
        setattr(space, name, lambda x, compute=compute: SX(compute(value_of(x))))
    space.logic_and = lambda x, y: SX(bool(value_of(x)) and bool(value_of(y)))
    space.vertsplit = lambda x, increment: [SX(row) for row in x.rows]
    return space


def check_casadi():
    space = casadi()
    for model in ("cart_pole", "pendulum_in_lift", "quadrotor"):
        module = module_of(model)
        code = module.on(space)
        values = state(module, 1)
        matrices = {name: SX(*x) if isinstance(x, list) else SX(x) for name, x in values.items() if name != "p"}
        matrices["p"] = values["p"]
        for function in functions_of(module):
            found = getattr(code, function.__name__)(*arguments(function, matrices))
            expected = flat(function(*arguments(function, values)))
            assert [value_of(x) for x in flat(found)] == expected, (model, function.__name__)
    code = module_of("cart_pole").on(space)
    p = code.Parameters()
    assert refusal(code.gravity, p, SX(0.1, 0.2, 0.3)) == "gravity: q needs length 2, has 3"
    regular = code.forward_dynamics(p, SX(0.1, 0.2), SX(0.3, 0.4), SX(0.5)).relative_pivots
    assert value_of(code.is_regular(regular)) is True
    assert value_of(code.is_regular([SX(0.0), SX(1.0)])) is False
    by_name = code.gravity(q=SX(0.1, 0.2), p=p)
    assert flat(by_name)[1].rows == code.gravity(p, [SX(0.1), SX(0.2)])[1].rows
    assert list(inspect.signature(code.gravity).parameters) == ["p", "q"]


def check_numpy():
    """The first axis of an array has the entries."""
    try:
        import numpy
    except ImportError:
        print("skipped: numpy of Python is not installed")
        return
    module = module_of("cart_pole")
    code, p = module.on(numpy), module.Parameters()
    states = numpy.linspace(-1.0, 1.0, 14).reshape(2, 7)
    assert code.gravity(p, states)[1].shape == (7,)
    assert module.gravity(p, states[:, 0]) == module.gravity(p, list(states[:, 0]))
    has = {"7": states.T, "1": states[:1], "none (float64)": states[0, 0], "none (ndarray)": numpy.array(0.5)}
    for text, wrong in has.items():
        assert refusal(code.gravity, p, wrong) == f"gravity: q needs length 2, has {text}"


check_every_argument()
check_messages()
check_other_errors()
check_models_without_inputs()
check_casadi()
check_numpy()
