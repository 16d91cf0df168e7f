"""Numbers that no double represents, with `on(sympy)` and `on(mpmath)`: large and small numbers, long decimals,
different numbers with the same double."""
import pathlib
import tempfile
from fractions import Fraction

from generated import functions_of, module_of, needs, state, value_at, written

needs("sympy", "mpmath")
import mpmath
import sympy

R = sympy.Rational
x = sympy.Symbol("x")

head = """format = 1
[model]
name = "{name}"
[[coordinate]]
name = "x"
[parameters]
{parameters}
[energy]
T = "1/2*m*dot(x)^2"
V = "{V}"
"""


def check_text(module):
    """Entries are integers or a decimal. Names belong to numbers of the module or to parameters."""
    for key, value in module.exact.items():
        if isinstance(value, tuple):
            assert all(type(part) in (int, bool) for part in value) and len(value) in (2, 3), (key, value)
            nearest = value[0] / value[1] * (float(mpmath.pi) if len(value) == 3 else 1)
        else:
            nearest = float(value)
        if isinstance(key, str) and key.startswith("p."):
            continue
        double = getattr(module, key) if isinstance(key, str) else key
        assert abs(double - nearest) <= 4e-16 * nearest, (key, value)


def check_potential(name, parameters, text, V, named=0):
    """V and dV/dx equal the typed formulas."""
    module = written(head.format(name=name, parameters=parameters, V=text))
    check_text(module)
    assert sum(isinstance(key, str) for key in module.exact) == named, module.exact
    code = module.on(sympy)
    p = code.Parameters()
    assert sympy.expand(code.potential_energy(p, [x]) - V) == 0, name
    assert sympy.expand(code.gravity(p, [x])[0] - sympy.diff(V, x)) == 0, name
    with mpmath.workdps(60):
        code = module.on(mpmath)
        for place in ("0.7", "-1.3"):
            at = {x: R(place)}
            for found, exact in (
                (code.potential_energy(code.Parameters(), [mpmath.mpf(place)]), V),
                (code.gravity(code.Parameters(), [mpmath.mpf(place)])[0], sympy.diff(V, x)),
            ):
                exact = exact.subs(at)
                exact = mpmath.mpf(exact.p) / exact.q
                assert abs(found - exact) <= mpmath.mpf("1e-55") * abs(exact), (name, found, exact)
    return module, p


def check_large_and_small():
    module, p = check_potential("kb", "k = 1.380649e-23\nm = 1", "k*x^2 + 1e25*x^3", R(1380649, 10**29) * x**2 + 10**25 * x**3)
    assert p.k == R(1380649, 10**29) and module.exact[3e25] == (3 * 10**25, 1)


def check_long_decimals():
    """Three times 0.333... (34 digits) is not equal to m = 1."""
    third = "0.3333333333333333333333333333333333"
    V = (
        R("2.71828182845904523536028747135266") * x**2
        + R(third) * x**3
        + 12345678901234567890123456789 * x**4
        + 123456789012345678901234567890 * x
        + 10**25 * x**5
        + R("1.5e-30") * x**6
        + R(100000000000000000000001, 3) * x**7
    )
    module, p = check_potential(
        "table",
        'k = 2.71828182845904523536028747135266\nm = 1\nbig = { value = "123456789012345678901234567890" }',
        f"k*x^2 + {third}*x^3 + 12345678901234567890123456789*x^4 + big*x + 1e25*x^5 + 1.5e-30*x^6"
        " + 100000000000000000000001*x^7/3",
        V,
        named=2,  # 0.99... and its double; 1 and 2 exist already
    )
    assert p.m == 1 and p.big == 123456789012345678901234567890


def check_parameters_with_one_double():
    tenth = "0.10000000000000000000001"
    _, p = check_potential(
        "tenths",
        f"m = 1\na = {tenth}\nb = 0.1\nc = {{ size = 3, value = [0.1, {tenth}, -0.1] }}",
        "a*x^2 + b*x^3 + c[1]*x^4 + c[2]*x^5 + c[3]*x^6",
        R(tenth) * x**2 + R(1, 10) * x**3 + R(1, 10) * x**4 + R(tenth) * x**5 - R(1, 10) * x**6,
        named=3,  # b, c[1] and c[3]; a exists already
    )
    assert (p.a, p.b, p.c) == (R(tenth), R(1, 10), (R(1, 10), R(tenth), R(-1, 10)))
    root = written(head.format(name="root", parameters='m = 1\nk = "sqrt(2)"', V="k*x^2")).on(sympy)
    assert abs(root.Parameters().k - sympy.sqrt(2)) < sympy.Float("1e-50")


def check_functions():
    """SymPy lacks expm1, log1p and hypot: the module writes them by other functions."""
    text = head.format(name="grow", parameters="m = 1", V="expm1(x)^2 + log1p(x^2) + hypot(x, 2)")
    code = written(text).on(sympy)
    V = (sympy.exp(x) - 1) ** 2 + sympy.log(1 + x**2) + sympy.sqrt(x**2 + 4)
    assert sympy.expand(code.potential_energy(code.Parameters(), [x]) - V) == 0
    assert sympy.expand(code.gravity(code.Parameters(), [x])[0] - sympy.diff(V, x)) == 0


tilted = """format = 1
[model]
name = "tilted"
[[coordinate]]
name = "q1"
[[frame]]
name = "L1"
parent = "world"
rotate = [[[1, 2, 2], "q1 + pi/2"]]
[[coordinate]]
name = "q2"
[[frame]]
name = "L2"
parent = "L1"
translate = ["q2 + p9", "-0.999", "p8"]
[[body]]
name = "b2"
frame = "L2"
[[coordinate]]
name = "q3"
[[frame]]
name = "L3"
parent = "L2"
rotate = [[[0, 3, 4], "q3"]]
[[body]]
name = "b3"
frame = "L3"
mass = "1.8"
com = ["p14", "0", "p15"]
[[output]]
name = "sensed"
jacobian = true
value = ["dot(vx(b2, L3))", "dot(dot(q3))*axis(b3, 3, 1)", "vy(L2, world)*axis(L2, 1, 3)"]
[parameters]
p8 = 0.98
p9 = 0.318
p14 = -0.226
p15 = 0.296
"""


def check_forms_of_one_number():
    """2/9 sin(pi/2) + 2/3 cos(pi/2) = 2/9, and the module has one number for both."""
    module = written(tilted)
    check_text(module)
    assert module.exact[2 / 3] == (2, 3) and module.exact[2 / 9] == (2, 9)
    assert not any(isinstance(key, str) for key in module.exact), module.exact


def check_composed_steps():
    """The weights of a composed step have 26 decimals, and add up to exactly 1."""
    folder = pathlib.Path(tempfile.mkdtemp())
    (folder / "model.toml").write_text(head.format(name="spring", parameters="m = 1\nk = 0.3", V="1/2*k*x^2"))
    scene = folder / "composed.scene.toml"
    scene.write_text(
        'format = 1\nmodel = "model.toml"\nname = "composed"\n'
        '[outputs]\nstep = { method = "verlet", order = 4 }\n'
    )
    module = module_of(scene)
    check_text(module)
    outer = Fraction("0.41449077179437573714235406")
    h, k, q, v = Fraction(1, 100), Fraction(3, 10), Fraction(7, 10), Fraction(-11, 10)
    for weight in (outer, outer, 1 - 4 * outer, outer, outer):
        v -= weight * h / 2 * k * q
        q += weight * h * v
        v -= weight * h / 2 * k * q
    q, v = (R(each.numerator, each.denominator) for each in (q, v))
    code = module.on(sympy)
    found = code.step(code.Parameters(), [R(7, 10)], [R(-11, 10)], [], R(1, 100))
    assert sympy.expand(found.coordinates[0] - q) == 0 and sympy.expand(found.rates[0] - v) == 0
    with mpmath.workdps(60):
        code = module.on(mpmath)
        start = (mpmath.mpf(7) / 10, -mpmath.mpf(11) / 10)
        found = code.step(code.Parameters(), [start[0]], [start[1]], [], mpmath.mpf(1) / 100)
        assert abs(found.coordinates[0] - mpmath.mpf(q.p) / q.q) < mpmath.mpf("1e-55")


def check_doubles():
    """The functions in double use the nearest doubles of these numbers."""
    module = written(head.format(name="near", parameters="m = 1", V="0.99999999999999999999*x + x^2/2"))
    assert list(module.exact) == ["_number_1"] and module._number_1 == 1.0
    assert all(value_at(each, state(module, 1)) for each in functions_of(module))
    assert module.gravity(module.Parameters(), [0.5]) == [1.5]
    assert module.on(sympy).gravity((1,), [R(1, 2)]) == [R(3, 2) - R(1, 10**20)]


check_large_and_small()
check_long_decimals()
check_functions()
check_parameters_with_one_double()
check_forms_of_one_number()
check_composed_steps()
check_doubles()
