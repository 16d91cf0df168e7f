"""Results of `on` are pickled by name, so that another process gets the same functions."""
import os
import pickle
import subprocess
import sys

from generated import needs, path_of

needs("numpy", "mpmath", "sympy")
import mpmath
import numpy
import sympy

folder = str(path_of("cart_pole").parent)
sys.path.insert(0, folder)
import cart_pole

q = [0.0, 0.3]
reader = "import pickle, sys; code, p, q = pickle.load(sys.stdin.buffer); print(code.gravity(p, q)[1])"


def elsewhere(code, p):
    """gravity(p, q)[1], computed by a new process that unpickles its arguments."""
    done = subprocess.run(
        [sys.executable, "-c", reader],
        input=pickle.dumps((code, p, q)),
        capture_output=True,
        env={**os.environ, "PYTHONPATH": folder},
    )
    assert done.returncode == 0, done.stderr.decode()
    return done.stdout.decode().strip()


def check_processes():
    for space in (numpy, sympy):
        code = cart_pole.on(space)
        assert pickle.loads(pickle.dumps(code)) is code
        p = code.Parameters()
        assert elsewhere(code, p) == str(code.gravity(p, q)[1])


def check_precision():
    """The functions for mpmath keep the precision of their numbers."""
    with mpmath.workdps(50):
        code = cart_pole.on(mpmath)
    again = pickle.loads(pickle.dumps(code))
    assert again is code and again is not cart_pole.on(mpmath)
    assert pickle.loads(pickle.dumps(code.Parameters())).m._mpf_ == code.Parameters().m._mpf_


def check_results():
    found = cart_pole.on(numpy).forward_dynamics(cart_pole.Parameters(), q, [0.1, 0.2], [0.5])
    again = pickle.loads(pickle.dumps(found))
    assert again == found and type(again) is cart_pole.ForwardDynamics


check_processes()
check_precision()
check_results()
