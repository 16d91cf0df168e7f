"""Numbers with the restrictions of tracers (JAX, CasADi's SX): no truth value, no conversion; a comparison is a tracer.

Every function of every model runs on them and gives the bits of `math`."""
import inspect
import math
import types

from generated import flat, functions_of, models, module_of, root, state, value_at


def forbidden(name):
    def call(self, *others):
        raise AssertionError(f"{name} of a tracer")

    return call


class Traced:
    __slots__ = ("value",)

    def __init__(self, value):
        self.value = value


for name in "bool float int index complex len iter contains eq ne le ge hash round trunc floor ceil pow".split():
    setattr(Traced, f"__{name}__", forbidden(name))


def value_of(x):
    return x.value if isinstance(x, Traced) else x


def operation(name):
    compute = getattr(float, f"__{name}__")
    return lambda *x: Traced(compute(*(float(value_of(each)) for each in x)))


for name in "add sub mul truediv radd rsub rmul rtruediv neg pos".split():
    setattr(Traced, f"__{name}__", operation(name))


def comparison(name):
    compute = getattr(float, f"__{name}__")
    return lambda x, y: Traced(compute(x.value, float(value_of(y))))


for name in ("lt", "gt"):
    setattr(Traced, f"__{name}__", comparison(name))


def where(is_first, x, y):
    return Traced(float(value_of(x) if is_first.value else value_of(y)))


def function(name):
    compute = getattr(math, name)

    def call(*x):
        assert any(isinstance(each, Traced) for each in x), "a plain number"
        return Traced(compute(*map(value_of, x)))

    return call


space = types.ModuleType("tracers")
for name in dir(math):
    if callable(getattr(math, name)) and not name.startswith("_"):
        setattr(space, name, function(name))
space.where = where


def traced(value):
    return [Traced(each) for each in value] if isinstance(value, list) else Traced(value)


def check(module, each, values):
    expected = value_at(each, values)
    if expected is None:
        return 0
    compared = 0
    for are_parameters_traced in (False, True):
        given = {name: value if name == "p" else traced(value) for name, value in values.items()}
        if are_parameters_traced:
            given["p"] = module.Parameters(*(traced(list(x)) if isinstance(x, tuple) else Traced(x) for x in values["p"]))
        call = getattr(module.on(space), each.__name__)
        found = flat(call(*(given[name] for name in inspect.signature(each).parameters)))
        assert [value_of(x).hex() for x in found] == [x.hex() for x in expected], (module.__name__, each.__name__)
        compared += len(found)
    return compared


compared = 0
for path in [*models, root / "tests/emit/compiled/functions.toml"]:
    module = module_of(path)
    for seed in (1, 2):
        compared += sum(check(module, each, state(module, seed)) for each in functions_of(module))
print(f"{compared} entries of {len(models)} models")
assert compared > 30000
