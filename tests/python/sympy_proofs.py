"""Independent proofs of the closed forms in model files: `on(sympy)` of the module minus the expectation is 0.

SymPy only uses the generated module. The translator below reads the expectations."""
import ast
import inspect
import keyword
import operator
import re

from generated import flat, models, module_of, needs, written

needs("sympy", "tomllib")
import sympy
import tomllib

operations = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
}


class Expressions:
    """Expressions of a model file in SymPy: parameters, coordinates, their rates and accelerations are symbols."""

    def __init__(self, module, model):
        self.module, self.model = module, model
        self.known = {"t": sympy.Symbol("t", real=True), "pi": sympy.pi}
        self.sizes = {name: sympy.Integer(value) for name, value in model.get("sizes", {}).items()}
        rates = module.coordinate_names
        if len(rates) != len(module.rate_ranges):
            rates = module.velocity_names  # three for a quaternion
        self.arguments = {
            "p": module.on(sympy).Parameters(*map(self.parameter, module.parameter_names, module.Parameters())),
            "f": self.symbols(getattr(module, "open_value_names", ())),
            "q": self.symbols(module.coordinate_names),
            "v": self.symbols(f"dot({name})" for name in rates),
            "a": self.symbols(f"dot(dot({name}))" for name in rates),
            "u": self.symbols(module.input_names),
            "t": self.known["t"],
        }

        rotations = [row["name"] for row in model.get("coordinate", []) if row.get("kind") == "rotation"]
        quaternions = [[self.known[f"{name}_{axis}"] for axis in "wxyz"] for name in rotations]
        self.of_units = {w: 1 - x**2 - y**2 - z**2 for w, x, y, z in quaternions}

    def parameter(self, name, value):
        row = self.model["parameters"].get(name)
        assumed = {row["assume"]: True} if isinstance(row, dict) and "assume" in row else {}
        if isinstance(value, tuple):
            return tuple(self.symbols((f"{name}[{i + 1}]" for i in range(len(value))), assumed))
        return self.symbols([name], assumed)[0]

    def symbols(self, names, assumed={}):
        return [self.known.setdefault(name, sympy.Symbol(name, real=True, **assumed)) for name in names]

    def read(self, text):
        # Names of a model may be Python keywords, such as `lambda`.
        text = re.sub(r"[A-Za-z_]\w*", lambda word: f"{word[0]}_" if keyword.iskeyword(word[0]) else word[0], text)
        return self.value(ast.parse(" ".join(text.replace("^", "**").split()), mode="eval").body, {})

    def value(self, node, local):
        if isinstance(node, ast.Constant):
            return sympy.Rational(str(node.value))
        if isinstance(node, ast.BinOp):
            return operations[type(node.op)](self.value(node.left, local), self.value(node.right, local))
        if isinstance(node, ast.UnaryOp):
            value = self.value(node.operand, local)
            return -value if isinstance(node.op, ast.USub) else value
        if isinstance(node, ast.Call) and node.func.id != "dot":
            return self.called(node.func.id, node.args, local)
        return self.named(self.name(node, local), local)

    def name(self, node, local):
        if isinstance(node, ast.Call):
            return f"dot({self.name(node.args[0], local)})"
        if isinstance(node, ast.Subscript):
            return f"{node.value.id}[{self.value(node.slice, local)}]"
        return node.id[:-1] if keyword.iskeyword(node.id[:-1]) else node.id

    def named(self, name, local):
        for known in (local, self.known, self.sizes):
            if name in known:
                return known[name]
        texts = dict(self.model.get("define", {}))
        texts.update((row["name"], row["value"]) for row in self.model.get("prescribed", []))
        return self.read(texts[name])

    def called(self, function, operands, local):
        if function == "sum":
            first, last = (self.value(each, local) for each in operands[1:3])
            return sum(self.value(operands[3], {**local, operands[0].id: i}) for i in range(first, last + 1))
        if function == "dist2":
            places = [self.place(each.id) for each in operands]
            return sum((one - other) ** 2 for one, other in zip(*places))
        values = [self.value(each, local) for each in operands]
        if function == "delta":
            return sympy.Integer(values[0] == values[1])
        return getattr(sympy, {"max": "Max", "min": "Min"}.get(function, function))(*values)

    def place(self, point):
        return [self.read(text) for row in self.model["point"] if row["name"] == point for text in row["at"]]

    def entries(self, expected):
        """The entries of an expectation, which is a text, rows of texts, or a text for every index."""
        if not isinstance(expected, dict):
            return [self.read(text) for text in flat(expected)]
        loops = [expected["for"]] if isinstance(expected["for"], str) else expected["for"]
        scopes = [{}]
        for name, first, last in (re.fullmatch(r"(\w+) in (\w+)\.\.(\w+)", loop).groups() for loop in loops):
            indices = range(self.read(first), self.read(last) + 1)
            scopes = [{**scope, name: sympy.Integer(i)} for scope in scopes for i in indices]
        text = " ".join(expected["value"].replace("^", "**").split())
        return [self.value(ast.parse(text, mode="eval").body, scope) for scope in scopes]

    def output(self, name):
        """The first field of an output, or the multipliers."""
        call = getattr(self.module.on(sympy), "forward_dynamics" if name == "multipliers" else name)
        value = call(*(self.arguments[each] for each in inspect.signature(call).parameters))
        if hasattr(value, "_fields"):
            value = value.multipliers if name == "multipliers" else value[0]
        return flat(value)


def atoms_of(expression):
    """Replaces sines, cosines and roots by symbols; returns polynomials for their squares too."""
    squares, replaced = {}, {}
    expression = sympy.expand_trig(expression)
    for angle in {each.args[0] for each in expression.atoms(sympy.sin, sympy.cos)}:
        sine, cosine = sympy.Dummy("s"), sympy.Dummy("c")
        replaced.update({sympy.sin(angle): sine, sympy.cos(angle): cosine})
        squares[sine] = 1 - cosine**2
    expression = expression.xreplace(replaced)
    for root in sorted(expression.atoms(sympy.Pow), key=sympy.count_ops):
        base, exponent = root.args
        if exponent.is_Rational and exponent.q == 2 and base.is_polynomial():
            root_symbol = next((r for r, square in squares.items() if sympy.expand(square - base) == 0), None)
            if root_symbol is None:
                root_symbol = sympy.Dummy("r")
                squares[root_symbol] = base
            expression = expression.xreplace({root: root_symbol**exponent.p})
    return expression, squares


def is_zero(expression, of_units={}):
    """Decides by a normal form: the expanded numerator, with squares of sines, of roots and of the scalar parts of unit
    quaternions replaced."""
    expression, squares = atoms_of(sympy.sympify(expression))
    squares |= of_units
    numerator = sympy.fraction(sympy.together(expression))[0]

    def is_square(each):
        return each.is_Pow and each.base in squares and each.exp.is_Integer and each.exp >= 2

    while True:
        numerator = sympy.expand(numerator)
        if not any(is_square(each) for each in numerator.atoms(sympy.Pow)):
            return numerator == 0
        numerator = numerator.replace(is_square, lambda each: squares[each.base] ** (each.exp // 2) * each.base ** (each.exp % 2))


def check_output(path, expressions, output, expected):
    ours = expressions.output(output.removesuffix("_entry"))
    theirs = expressions.entries(expected)
    assert len(ours) == len(theirs), (path.stem, output)
    for one, other in zip(ours, theirs):
        assert is_zero(one - other, expressions.of_units), (path.stem, output, one, other)
    return len(ours)


def check_model(path):
    model = tomllib.loads(path.read_text())
    expected = [entry for entry in model.get("expect", []) if "at" not in entry]
    if not expected:
        return 0
    expressions = Expressions(module_of(path), model)
    not_outputs = ("conserved", "equations")
    return sum(
        check_output(path, expressions, output, value)
        for entry in expected
        for output, value in entry.items()
        if output not in not_outputs
    )


def check_exact():
    """Integers stay exact, also in list literals, which CPython folds into a constant."""
    code = module_of("cart_pole").on(sympy)
    half = sympy.Rational(1, 2)
    assert code.mass_matrix(code.Parameters(), [0, 0]) == [[11 * half / 5, half / 10], [half / 10, half / 20]]
    code = written(
        """format = 1
[model]
name = "rotor"
[[coordinate]]
name = "q"
unit = "rad"
[parameters]
J = { value = 2, unit = "kg*m^2" }
[energy]
T = "1/2*J*dot(q)^2"
[[output]]
name = "place"
value = ["0.1", "pi/3", "sqrt(2)", "-0.3"]
"""
    )
    place = code.on(sympy).place(code.on(sympy).Parameters(), [0])
    assert place[::3] == [sympy.Rational(1, 10), sympy.Rational(-3, 10)] and place[1] == sympy.pi / 3, place
    assert abs(place[2] - sympy.sqrt(2)) < sympy.Float("1e-50")


check_exact()
proved = {path.stem: check_model(path) for path in models}
print(f"{sum(proved.values())} entries of {sum(map(bool, proved.values()))} models")
assert sum(proved.values()) > 1400
