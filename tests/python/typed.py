"""`mypy --strict` accepts the modules, and finds wrong types in a script that calls them."""
import os
import pathlib
import subprocess
import sys
import tempfile

from generated import needs, path_of, root

needs("mypy")

taken = ("cart_pole", "chain", "central_force_open", "pendulum_in_lift", "quadrotor")
scenes = [root / "models/scenes" / f"{name}.scene.toml" for name in ("balance", "cart_pole_prediction")]
paths = [path_of(each) for each in (*taken, *scenes, root / "tests/emit/compiled/functions.toml")]

right = """
import cart_pole
from cart_pole import *

p = Parameters(m=0.2)
a: list[float] = forward_dynamics(p, (0.0, 0.1), [0.0, 0.0], [0.5]).acceleration
M: list[list[float]] = mass_matrix(p, [0.0, 0.1])
V: float = potential_energy(p, range(2))
version: str = cart_pole.__version__
"""
wrong = """
import cart_pole
p = cart_pole.Parameters(m="0.2")
cart_pole.gravity([1.0], [0.0, 0.1])
cart_pole.gravity(p, 0.1)
cart_pole.gravity(p, [0.0, 0.1])[0][0]
cart_pole.forward_dynamics(p, [0.0, 0.1], [0.0, 0.0], [0.5]).accelerations
"""


def mypy(*files):
    """The exit status and the lines of errors."""
    with tempfile.TemporaryDirectory() as folder:
        words = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", folder, *map(str, files)]
        environment = {**os.environ, "MYPYPATH": str(path_of("cart_pole").parent)}
        done = subprocess.run(words, capture_output=True, text=True, cwd=folder, env=environment)
    return done.returncode, [line for line in done.stdout.splitlines() if ": error: " in line]


def script(folder, text):
    path = pathlib.Path(folder) / "script.py"
    path.write_text(text)
    return path


status, errors = mypy(*paths)
assert (status, errors) == (0, []), errors
with tempfile.TemporaryDirectory() as folder:
    status, errors = mypy(script(folder, right))
    assert (status, errors) == (0, []), errors
    status, errors = mypy(script(folder, wrong))
    places = [int(line.split(":")[1]) for line in errors]
    assert status == 1 and places == [3, 4, 5, 6, 7], errors
print(f"{len(paths)} modules")
