"""Modules that elgen generates for a test, and states for their functions."""
import atexit
import importlib.util
import inspect
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parents[2]
models = sorted((root / "models").glob("*.toml"))
# Scripts of one test run share the generated modules.
_shared = os.environ.get("ELGEN_MODULES")
_folder = pathlib.Path(_shared or tempfile.mkdtemp(prefix="elgen_python_"))
if not _shared:
    atexit.register(shutil.rmtree, _folder)


def elgen(*words):
    """Runs the command and returns its output. If it fails, the test ends with its messages."""
    done = subprocess.run([os.environ.get("ELGEN", "elgen"), *map(str, words)], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"elgen {words[0]} {words[-1]}: {done.stderr}")
    return done.stdout


def path_of(model, *options):
    """The module of a scene or a model file; a name means a file in models/."""
    path = pathlib.Path(model if os.path.sep in str(model) else root / "models" / f"{model}.toml")
    folder = _folder / "-".join([str(path.relative_to("/")).replace("/", "-"), *options])
    if not folder.exists():
        elgen("generate", "-q", "--language", "python", "-o", folder, *options, path)
    return next(folder.glob("*/*.py"))


def module_at(path):
    spec = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def module_of(model, *options):
    return module_at(path_of(model, *options))


def written(text):
    """The module of a model text."""
    path = pathlib.Path(tempfile.mkdtemp(dir=_folder)) / "model.toml"
    path.write_text(text)
    return module_of(path)


def functions_of(module):
    """The functions of a module that compute outputs."""
    return [each for each in module._functions if not each.__name__.startswith("_")]


def _inside(chance, interval):
    low, high = (max(-1.5, interval[0]), min(1.5, interval[1]))
    return chance.uniform(low, high) if low < high else chance.uniform(*interval)


def state(module, seed):
    """A value for every argument, by name."""
    chance = random.Random(seed)
    moving = [_inside(chance, each) for each in module.rate_ranges]
    return {
        "p": module.Parameters(),
        "f": [chance.uniform(-1, 1) for _ in getattr(module, "open_value_names", ())],
        "q": [_inside(chance, each) for each in module.coordinate_ranges],
        "v": moving,
        "momenta": moving,
        "a": [chance.uniform(-1, 1) for _ in moving],
        "u": [chance.uniform(-1, 1) for _ in module.input_names],
        "t": chance.uniform(0, 1),
        "h": 0.01,
    }


def arguments(function, values):
    return [values[name] for name in inspect.signature(function).parameters]


def flat(value):
    """The entries of a result, row by row and field by field."""
    if isinstance(value, (list, tuple)):
        return [entry for each in value for entry in flat(each)]
    return [value]


def value_at(function, values):
    """The entries, or None if `math` raises an error."""
    try:
        return flat(function(*arguments(function, values)))
    except (ValueError, ZeroDivisionError, OverflowError):
        return None


def needs(*packages):
    """Skips the test if a package is missing."""
    for package in packages:
        try:
            __import__(package)
        except ImportError:
            print(f"skipped: {package} of Python is not installed")
            sys.exit(0)
