"""`on(mpmath)` at 50 digits against the oracle, which evaluates the energies of the model directly."""
import inspect
import json

from generated import elgen, flat, functions_of, module_of, needs, root

needs("mpmath")
import mpmath

mpmath.mp.dps = 50
# The oracle prints 50 digits. Solutions with mass matrices lose up to four.
most = mpmath.mpf("1e-45")

# Both sides read the numbers of a state as decimals.
states = {
    "cart_pole": "theta=0.1,dot(x)=0.7,dot(theta)=2,dot(dot(x))=0.3,dot(dot(theta))=-0.7",
    "double_pendulum": "theta1=0.3,theta2=-1.1,dot(theta1)=0.7,dot(theta2)=0.2",
    "furuta_pendulum": "theta1=0.3,theta2=-1.1,dot(theta1)=0.7,dot(theta2)=0.2",
    "kepler_cartesian": "x=0.3,y=0.7,z=-0.2,dot(x)=0.1,dot(y)=0.9,dot(z)=0.3",
    "motor_pendulum": "theta=0.3,dot(theta)=0.7",
    "relativistic_particle": "x=0.3,dot(x)=0.7",
    "ur5": "q1=0.3,q2=-0.7,q3=1.1,q4=0.2,q5=-0.4,q6=0.9,dot(q1)=0.2,dot(q3)=-0.6",
    root / "tests/emit/compiled/functions.toml": "x=0.3,theta=0.7,dot(x)=0.1,dot(theta)=-0.9",
}


def given(text):
    """The numbers in the oracle's JSON, with all digits."""
    return json.loads(text, parse_float=mpmath.mpf, parse_int=mpmath.mpf)


def check(model, state):
    module = module_of(model)
    path = model if "/" in str(model) else root / "models" / f"{model}.toml"
    code = module.on(mpmath)
    names = ",".join(each.__name__ for each in functions_of(module) if each.__name__ != "dynamics")
    said = given(elgen("evaluate", "--state", state, "--what", names, "--digits", 50, "--format", "json", path))
    assert len(said["values"]) == len(names.split(","))
    for row in said["values"]:
        call = getattr(code, row["function"])
        values = {"p": code.Parameters(), "t": 0, **{name: row.get(name) for name in ("q", "v", "a", "u")}}
        found = flat(call(*(values[name] for name in inspect.signature(call).parameters)))
        largest = max(1, *(abs(x) for x in row["value"]))
        worst = max(abs(one - other) for one, other in zip(found, row["value"]))
        assert len(found) == len(row["value"]) and worst <= most * largest, (module.__name__, row["function"], worst)
    return len(said["values"])


def check_series():
    """The series and the recursion of stumpff against mpmath's series."""
    code = module_of(root / "tests/emit/compiled/functions.toml").on(mpmath)
    for x in ("0.01", "1.5", "9", "-17"):
        for order in range(1, 8):
            for sign in (1, -1):
                x_squared = -sign * mpmath.mpf(x) ** 2
                series = mpmath.nsum(lambda i: x_squared**i / mpmath.factorial(2 * i + order), [0, mpmath.inf])
                found = code._stumpff(mpmath.mpf(x), sign * order)
                assert abs(found - series) <= mpmath.mpf("1e-40") * abs(series), (x, order, sign, found, series)


def check_precision():
    """The precision is the precision of mpmath when on() is called."""
    module = module_of("cart_pole")
    assert module.on(mpmath).Parameters().g == mpmath.mpf("9.81")
    with mpmath.workdps(80):
        assert module.on(mpmath).Parameters().g == mpmath.mpf("9.81")
        assert module.on(mpmath) is module.on(mpmath)


check_series()
check_precision()
print(f"{sum(check(*each) for each in states.items())} outputs of {len(states)} models")
