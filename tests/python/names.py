"""Names that Python reserves or the module needs: some are changed, others refused."""
import ast
import builtins
import keyword
import math
import os
import pathlib
import subprocess
import tempfile

from generated import functions_of, models, module_at, module_of, path_of, root, state, value_at, written

rotor = """format = 1
[model]
name = "rotor"
[[coordinate]]
name = "{coordinate}"
unit = "rad"
range = [-1, 1]
[parameters]
J = {{ value = 2, unit = "kg*m^2", assume = "positive" }}
k = {{ value = 3, unit = "J" }}
{parameters}
[energy]
T = "1/2*J*dot({coordinate})^2"
V = "k*cos({coordinate})*(1{sum})"
{outputs}
"""


def model(coordinate="angle", parameters=(), outputs=(), arrays=()):
    lines = [f'{name} = {{ value = {i + 2}, unit = "1" }}' for i, name in enumerate(parameters)]
    lines += [f'{name} = {{ value = [2, 3], size = 2, unit = "1" }}' for name in arrays]
    added = [*parameters, *(f"{name}[1]" for name in arrays)]
    own = [f'[[output]]\nname = "{name}"\nvalue = ["J*{coordinate}", "k*sin({coordinate})"]' for name in outputs]
    return rotor.format(
        coordinate=coordinate,
        parameters="\n".join(lines),
        sum="".join(f" + {name}" for name in added),
        outputs="\n".join(own),
    )


def refusals(text):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "rotor.toml"
        path.write_text(text)
        words = [os.environ.get("ELGEN", "elgen"), "generate", "--language", "python", "-o", folder, str(path)]
        return subprocess.run(words, capture_output=True, text=True).stderr


def has_values(module):
    values = state(module, 1)
    assert all(value_at(each, values) for each in functions_of(module))


def check_parameters():
    """A reserved word gets an underscore. Fields may hide methods of tuples."""
    reserved = [name for name in keyword.kwlist if name == name.lower() and "[E204]" not in refusals(model(parameters=[name]))]
    assert {"lambda", "in", "is", "def", "pass", "with", "yield", "from"} <= set(reserved)
    others = ["None", "True", "tuple", "list", "count", "index", "end", "self", "cls", "type", "q", "v", "p", "Parameters"]
    module = written(model(parameters=reserved + others, arrays=["masses"]))
    assert module.parameter_names[2:] == (*reserved, *others, "masses")
    spelt = {name: f"{name}_" for name in [*reserved, "None", "True", "tuple"]}
    assert list(module.Parameters._fields[2:]) == [spelt.get(name, name) for name in module.parameter_names[2:]]
    given = module.Parameters(lambda_=7.0, count=8.0, index=9.0)
    assert (given.lambda_, given.count, given.index) == (7.0, 8.0, 9.0)
    has_values(module)
    assert module_of("foucault_pendulum").Parameters().lambda_ == 0.8526


def check_coordinates():
    for name in ("end", "lambda", "count", "index", "None"):
        module = written(model(coordinate=name))
        assert module.coordinate_names == (name,)
        has_values(module)


def check_outputs():
    module = written(model(outputs=["lambda", "count", "index", "end", "None", "format", "code", "v"]))
    assert {"lambda_", "count", "index", "end", "None_", "format", "code", "v"} <= set(module.Dynamics._fields)
    has_values(module)


def used_names(path):
    """The names of Python that a module uses."""
    tree = ast.parse(path.read_text())
    read = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)}
    return read & set(dir(builtins))


def check_entries():
    """A parameter with the name of an unpacked entry hides no entry."""
    text = model(coordinate="x", parameters=["q_0", "v_0"])
    text = text.replace("J*dot(x)^2", "J*q_0^2*v_0^2*dot(x)^2").replace("cos(x)", "cos(q_0^2*x + v_0^2)")
    module = written(text)
    p = module.Parameters(J=1.0, k=1.0, q_0=3.0, v_0=0.5)
    assert abs(module.momentum(p, [0.7], [0.2])[0] - 9.0 * 0.25 * 0.2) < 1e-15
    assert abs(module.gravity(p, [0.7])[0] + 9.0 * math.sin(9.0 * 0.7 + 0.25) * (1.0 + 3.0 + 0.5)) < 1e-13


def check_version():
    """The version has the hashes of the model and of the scene; a comment changes neither."""
    whole, scene = (module_of(each).__version__.split(".") for each in ("cart_pole", root / "models/scenes/balance.scene.toml"))
    assert whole[0] == scene[0] and whole[1] != scene[1]
    texts = (model(), "# rotor\n" + model(), model(parameters=["a"]))
    first, commented, other = (written(text).__version__ for text in texts)
    assert first == commented != other


def check_taken():
    """An output is refused if its name is used by the module."""
    used = set().union(*map(used_names, map(path_of, ("cart_pole", "quadrotor", "chain"))))
    own = {"on", "stack", "blocks", "exact", "Parameters", "is_regular", "digits_left"}
    own |= {"Any", "Callable", "Iterable", "NamedTuple", "coordinate_names", "parameter_units", "start_rates"}
    assert len(used) > 10
    for name in sorted(used | own):
        said = refusals(model(outputs=[name]))
        spelt = name == "tuple" or keyword.iskeyword(name)
        assert spelt or "[E701]" in said or "[E204]" in said, f"an output may be called {name}"


def check_called():
    """An output is refused if its name is a function called by the module."""
    force = '[[force]]\non = "angle"\nvalue = "-k*abs(angle)"\n'
    assert "[E701]" in refusals(model(outputs=["fabs"]) + force)
    assert "[E" not in refusals(model(outputs=["fabs"]))


def check_imports():
    """Modules import only the functions that they call, and export every other public name."""
    for path in map(path_of, models):
        tree = ast.parse(path.read_text())
        imports = [node for node in ast.walk(tree) if isinstance(node, (ast.Import, ast.ImportFrom))]
        names = [node.module for node in imports]
        assert [name for name in names if name != "math"] == ["__future__", "functools", "sys", "typing", "importlib"], path
        named = {alias.asname or alias.name for node in imports for alias in node.names}
        read = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
        assert named - read == {"annotations"}, (path, named - read)
        module = module_at(path)
        public = {name for name in vars(module) if not name.startswith("_")}
        assert set(module.__all__) == public - named - set(module._library) and list(module.__all__) == sorted(module.__all__), path
    far = "*".join(["10^64"] * 5)
    beyond = model().replace("range = [-1, 1]", f'range = [-1, 1]\nrate_range = ["-{far}", "{far}"]')
    assert written(beyond).rate_ranges == ((-math.inf, math.inf),)


def check_shapes():
    """A matrix is a list of rows, even with one column. A vector is a list, a number a number."""
    cart = module_of("cart_pole")
    p, q, v = cart.Parameters(), [0.0, 0.1], [0.0, 0.0]
    assert [len(row) for row in cart.mass_matrix(p, q)] == [2, 2]
    assert cart.input_matrix(p, q) == [[1.0], [0.0]]
    assert [type(x) for x in cart.gravity(p, q)] == [float, float]
    assert isinstance(cart.potential_energy(p, q), float)
    assert cart.forward_dynamics(p, q, v, [0.0])._fields == ("acceleration", "relative_pivots")


def check_literals():
    """CPython folds no constant of a module: each occurs in its text, so that on(sympy) finds it."""
    for path in map(path_of, models):
        tree = ast.parse(path.read_text())
        written_down = {node.value for node in ast.walk(tree) if isinstance(node, ast.Constant) and isinstance(node.value, float)}
        module = module_at(path)
        for function in module._functions:
            for constant in function.__code__.co_consts:
                for each in constant if isinstance(constant, tuple) else (constant,):
                    assert not isinstance(each, float) or abs(each) in written_down, (path, function, each)


check_parameters()
check_coordinates()
check_outputs()
check_entries()
check_version()
check_taken()
check_called()
check_imports()
check_shapes()
check_literals()
