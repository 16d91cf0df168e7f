"""Modules that elgen generates for a test, and states to call them at."""
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
# Scripts that run one after the other share what is generated.
_shared = os.environ.get("ELGEN_MODULES")
_folder = pathlib.Path(_shared or tempfile.mkdtemp(prefix="elgen_python_"))
if not _shared:
    atexit.register(shutil.rmtree, _folder)


def elgen(*words):
    """The output of the command; ends the test with its messages where it fails."""
    done = subprocess.run([os.environ.get("ELGEN", "elgen"), *map(str, words)], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"elgen {words[0]} {words[-1]}: {done.stderr}")
    return done.stdout


def path_of(model, *options):
    """The module of a model file (a name of one in models/ will do) or of a scene."""
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
    """The module of a model that a test writes."""
    path = pathlib.Path(tempfile.mkdtemp(dir=_folder)) / "model.toml"
    path.write_text(text)
    return module_of(path)


def functions_of(module):
    """The functions of outputs."""
    return [each for each in module._functions if not each.__name__.startswith("_")]


def _inside(chance, interval):
    low, high = (max(-1.5, interval[0]), min(1.5, interval[1]))
    return chance.uniform(low, high) if low < high else chance.uniform(*interval)


def state(module, seed):
    """A value for every argument, by its name."""
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
    """Entries, or None where `math` has no value for them."""
    try:
        return flat(function(*arguments(function, values)))
    except (ValueError, ZeroDivisionError, OverflowError):
        return None


def needs(*packages):
    """Ends the test where a package is missing."""
    for package in packages:
        try:
            __import__(package)
        except ImportError:
            print(f"skipped: {package} of Python is not installed")
            sys.exit(0)
