# SPDX-License-Identifier: 0BSD
# Equations as symbols of SymPy: the poles about the upright state, and M for a paper.
import sympy

import cart_pole

code = cart_pole.on(sympy)
M, m, l, g = sympy.symbols("M m l g", positive=True)
theta, s = sympy.symbols("theta s")
p = code.Parameters(M, m, l, g)

upright = sympy.Matrix(code.linearization(p, [0, 0], [0, 0], [0]).A)
print(sympy.factor((s * sympy.eye(4) - upright).det()))
print(sympy.latex(sympy.Matrix(code.mass_matrix(p, [0, theta]))))
print(code.Parameters())  # the model's values, exact
