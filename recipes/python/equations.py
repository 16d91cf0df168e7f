# SPDX-License-Identifier: 0BSD
# Prints equations in SymPy symbols: characteristic polynomial about the upright state, and M in LaTeX.
import sympy

import cart_pole

code = cart_pole.on(sympy)
M, m, l, g = sympy.symbols("M m l g", positive=True)
theta, s = sympy.symbols("theta s")
p = code.Parameters(M, m, l, g)

upright = sympy.Matrix(code.linearization(p, [0, 0], [0, 0], [0]).A)
print(sympy.factor((s * sympy.eye(4) - upright).det()))
print(sympy.latex(sympy.Matrix(code.mass_matrix(p, [0, theta]))))
print(code.Parameters())  # exact values of the model file
