"""Functions compiled by numba give the bits of CPython, without fast arithmetic; a division by zero is inf.

numba compiles `exp` of `math`, whose overflow is inf, and not `exp` of the module. It can return lists to Python, but crashes for a struct of lists, so compiled code selects the fields."""
import math

from generated import arguments, flat, functions_of, module_of, needs, root, state, value_at

needs("numba")
import numba

compiled = numba.njit(error_model="numpy")
taken = {
    "cart_pole": ("mass_matrix", "inverse_dynamics", "forward_dynamics", "linearization", "total_energy"),
    "double_pendulum": ("mass_matrix", "forward_dynamics"),
    "chain": ("bias", "mass_matrix"),
    "quadrotor": ("forward_dynamics",),
    root / "tests/emit/compiled/functions.toml": ("applied_force", "gravity", "forward_dynamics"),
}


def calls(module, name, struct):
    """The function compiled by numba, or a compiled function for each field of its struct."""
    setattr(module, name, compiled(getattr(module, name)))
    if struct is None:
        return [getattr(module, name)]
    texts = [f"lambda *x: {name}(*x).{field}" for field in struct._fields]
    return [compiled(eval(text, vars(module))) for text in texts]


def check(model, names):
    plain = {each.__name__: each for each in functions_of(module_of(model))}
    module = module_of(model)
    for each in module._library:
        setattr(module, each, getattr(math, each))
    for helper in module._functions:  # functions with kinks and series call these helpers
        if helper.__name__.startswith("_"):
            setattr(module, helper.__name__, compiled(helper))
    compared = 0
    for name in names:
        struct = getattr(module, "".join(word.capitalize() for word in name.split("_")), None)
        fields = calls(module, name, struct)
        for seed in range(4):
            values = state(module, seed)
            expected = value_at(plain[name], values)
            given = {each: tuple(value) if isinstance(value, list) else value for each, value in values.items()}
            found = flat([call(*arguments(plain[name], given)) for call in fields])
            assert [float(x).hex() for x in found] == [x.hex() for x in expected], (model, name, seed)
            compared += len(found)
    return compared


print(f"{sum(check(*each) for each in taken.items())} entries")
