// elgen verify --foreign: constrained models, outputs with several fields, and steps.
#include <catch2/catch.hpp>

#include "cli/foreign_testing.hpp"

namespace elgen::test {
namespace {

/// A model of a bob on a rod; `stabilise` is empty or the key that stabilises the constraint.
std::string rod(const std::string& stabilise = "") {
  return R"toml(format = 1
[model]
name = "rod"
[[coordinate]]
name = "x"
unit = "m"
start = { value = 0.6, rate = 0 }
[[coordinate]]
name = "y"
unit = "m"
start = { value = -0.8, rate = 0 }
[parameters]
m = { value = 2, unit = "kg", assume = "positive" }
l = { value = 1, unit = "m", assume = "positive" }
g = { value = 9.81, unit = "m/s^2" }
[[point]]
name = "bob"
at = ["x", "y"]
mass = "m"
[gravity]
vector = ["0", "-g"]
[[constraint]]
name = "rod"
equation = "x^2 + y^2 = l^2"
)toml" + stabilise;
}

/// A program that prints `answer`, an expression in p, x, y, vx, vy and k, for each state.
/// k = (vx^2 + vy^2 - g y)/`length`; `length` is an expression for the square of the rod's length.
std::string on_the_rod(const std::string& length, const std::string& answer) {
  return "import json, sys\n"
         "for line in sys.stdin:\n"
         "  call = json.loads(line)\n"
         "  p, (x, y), (vx, vy) = call['p'], call['q'], call['v']\n"
         "  k = (vx * vx + vy * vy - p['g'] * y) / (" +
         length + ")\n  print(json.dumps(" + answer + "))\n";
}

const std::string accelerations = "[-k * x, -p['g'] - k * y]";
const std::string with_multiplier = "[-k * x, -p['g'] - k * y, -p['m'] * k / 2]";
const std::string forward = "--function forward_dynamics";

}  // namespace

TEST_CASE("code of a constrained model is compared at states on the constraints") {
  const Foreign folder;
  folder.write("rod.toml", rod());
  const auto compared = [&](const std::string& length, const std::string& answer) {
    return folder.compare_command(on_the_rod(length, answer), forward, "rod.toml");
  };
  const Outcome right = compared("p['l'] ** 2", accelerations);
  INFO(right.output << right.errors);
  CHECK(right.status == 0);
  CHECK(mentions(right.output, "agrees at 60 states to "));
  CHECK(mentions(right.output, " in acceleration\n"));
  CHECK(mentions(right.output, "1e-09 of the largest entry, at states on the constraints\n"));
  CHECK(compared("x * x + y * y", accelerations).status == 0);
  const Outcome sign = compared("p['l'] ** 2", "[-k * x, p['g'] - k * y]");
  INFO(sign.output);
  CHECK(sign.status == 1);
  CHECK(mentions(sign.output, "found      wrong even at rest\n"));
  const Outcome length = compared("p['l']", accelerations);
  INFO(length.output);
  CHECK(length.status == 1);
  CHECK(mentions(length.output, "only if parameters are varied"));
}

TEST_CASE("multipliers are compared, also with the gains of `stabilise`") {
  const Foreign folder;
  folder.write("rod.toml", rod());
  folder.write("stable.toml", rod("stabilise = { omega = 10, zeta = 1 }\n"));
  for (const char* const model : {"rod.toml", "stable.toml"}) {
    INFO(model);
    const auto compared = [&](const std::string& answer, const std::string& function) {
      return folder.compare_command(on_the_rod("p['l'] ** 2", answer), function, model);
    };
    const Outcome right = compared(with_multiplier, forward);
    INFO(right.output << right.errors);
    CHECK(right.status == 0);
    CHECK(mentions(right.output, " in acceleration, multipliers\n"));
    const Outcome wrong = compared(replaced(with_multiplier, "k / 2", "k"), forward);
    CHECK(wrong.status == 1);
    CHECK(mentions(wrong.output, "forward_dynamics.multipliers is "));
    const std::string alone = "[-p['m'] * k / 2]";
    CHECK(compared(alone, forward + ".multipliers").status == 0);
    CHECK(compared(alone, forward).status == 0);
  }
}

TEST_CASE("constraint residuals are compared off the constraints") {
  const Foreign folder;
  folder.write("rod.toml", rod());
  const auto compared = [&](const std::string& rate) {
    return folder.compare_command(on_the_rod("1", "[x * x + y * y - p['l'] ** 2, " + rate + "]"),
                                  "--function constraint_residual", "rod.toml");
  };
  const Outcome right = compared("2 * (x * vx + y * vy)");
  INFO(right.output << right.errors);
  CHECK(right.status == 0);
  CHECK_FALSE(mentions(right.output, "on the constraints"));
  CHECK(compared("x * vx + y * vy").status == 1);
}

TEST_CASE("code that is right off the constraints holds, although all digits cancel on them") {
  const Foreign folder;
  folder.write("rod.toml", rod() + "[[output]]\nname = \"stretch\"\nvalue = \"x^2 + y^2 - l^2\"\n");
  const auto compared = [&](const std::string& answer) {
    const std::string text =
        "import json, sys\nfor line in sys.stdin:\n  call = json.loads(line)\n"
        "  p, (x, y) = call['p'], call['q']\n  print(json.dumps([";
    return folder.compare_command(text + answer + "]))\n", "--function stretch", "rod.toml");
  };
  CHECK(failure_of(compared("x * x + y * y - p['l'] ** 2")) == "");
  CHECK(compared("x * x - y * y - p['l'] ** 2").status == 1);
}

TEST_CASE("states that cannot be projected onto the constraints are counted") {
  const Foreign folder;
  folder.write("wall.toml",
               replaced(replaced(rod(), "l = { value = 1,", R"(d = { value = 1, unit = "m" }
l = { value = 1.05,)"),
                        "x^2 + y^2 = l^2", "x^2 + d^2 = l^2"));
  const Outcome outcome = folder.compare_command(
      "import json, sys\nfor line in sys.stdin:\n"
      "  print([0, -json.loads(line)['p']['g']])\n",
      forward, "wall.toml");
  INFO(outcome.output << outcome.errors);
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.output, " not projected onto the constraints\n"));
  CHECK_FALSE(mentions(outcome.output, "agrees at 60 states"));
}

TEST_CASE("all fields of an output are compared, or one by its name") {
  const Foreign folder;
  folder.write("upright.toml", R"toml(format = 1
[model]
name = "upright"
[[coordinate]]
name = "theta"
unit = "rad"
[parameters]
m = { value = 0.57288, unit = "kg" }
l = { value = 0.5, unit = "m" }
g = { value = 9.81, unit = "m/s^2" }
[[point]]
name = "bob"
at = ["l*sin(theta)", "-l*cos(theta)"]
mass = "m"
[gravity]
vector = ["0", "-g"]
[[input]]
name = "tau"
unit = "N*m"
on = "theta"
)toml");
  const auto compared = [&](const std::string& answer, const std::string& function) {
    return folder.compare_command(
        "import json, math, sys\nfor line in sys.stdin:\n  call = json.loads(line)\n"
        "  p, q = call['p'], call['q']\n  m, l = p['m'], p['l']\n"
        "  a = -p['g'] / l * math.cos(q[0])\n  print(json.dumps(" +
            answer + "))\n",
        "--function " + function, "upright.toml");
  };
  const std::string right = "[0, 1 / (m * l * l)]";
  const std::string wrong = "[0, 1 / (m * l)]";
  const std::string a_alone = "[[0, 1], [a, 0]]";
  CHECK(compared(a_alone, "linearization").status == 0);
  CHECK(compared(a_alone, "linearization.A").status == 0);
  CHECK(compared(right, "linearization.B=my_B").status == 0);
  const Outcome both = compared("[0, 1, a, 0] + " + right, "linearization");
  INFO(both.output << both.errors);
  CHECK(both.status == 0);
  CHECK(mentions(both.output, " in A, B\n"));
  for (const Outcome& outcome :
       {compared(wrong, "linearization"), compared(wrong, "linearization.B"),
        compared("[0, 1, a, 0] + " + wrong, "linearization")}) {
    INFO(outcome.output << outcome.errors);
    CHECK(outcome.status == 1);
    CHECK(mentions(outcome.output, "linearization.B[dot(theta)] is "));
  }
  const Outcome count = compared("[1, 2, 3]", "linearization");
  CHECK(mentions(count.output, "gives 3 numbers for 2 x 2 entries\n"));
  CHECK(mentions(count.output, "found      its fields are A (4), B (2)\n"));
  CHECK(mentions(compared(right, "linearization.C").errors,
                 "error[E601]: `linearization` has no field `C`"));
  CHECK(mentions(compared(right, "gravity.B").errors, "error[E601]: `gravity` has no field `B`"));
}

TEST_CASE("code that returns 0 is right if terms cancel to 0") {
  const Foreign folder;
  const auto compared = [&](const std::string& answer) {
    return folder.compare_command("import sys\nfor line in sys.stdin:\n  print(" + answer + ")\n",
                                  "--function drift", models + "/heavy_top.toml");
  };
  CHECK(failure_of(compared("[0, 0, 0]")) == "");
  const Outcome other = compared("[0, 0.001, 0]");
  CHECK(other.status == 1);
  CHECK(mentions(other.output, "drift[theta] is 0.001, the oracle says 0\n"));
}

TEST_CASE("a step and its derivatives are those of the scene") {
  const Foreign folder;
  folder.write("forced.toml", R"toml(format = 1
[model]
name = "forced"
[[coordinate]]
name = "q"
unit = "rad"
range = [-2, 2]
rate_range = [-3, 3]
[parameters]
J = { value = 1, unit = "kg*m^2" }
k = { value = 4, unit = "N*m" }
w = { value = 3, unit = "rad/s" }
[energy]
T = "1/2*J*dot(q)^2"
V = "-k*(1 + 0.5*cos(w*t))*cos(q)"
[[input]]
name = "u"
unit = "N*m"
on = "q"
)toml");
  folder.write("rk4.scene.toml", R"toml(format = 1
model = "forced.toml"
name = "rk4"
[outputs]
step = { method = "rk4", rename = "advance" }
step_derivatives = { method = "rk4" }
)toml");
  // One step, and its derivatives by complex-step differentiation, which loses no digits.
  const std::string step = R"py(import cmath, json, sys

def advanced(x, t, h, u, p):
    f = lambda x, t: [x[1], (u - p["k"] * (1 + 0.5 * cmath.cos(p["w"] * t)) * cmath.sin(x[0])) / p["J"]]
    moved = lambda k, s: [x[0] + s * k[0], x[1] + s * k[1]]
    k1 = f(x, t)
    k2 = f(moved(k1, h / 2), t + h / 2)
    k3 = f(moved(k2, h / 2), t + h / 2)
    k4 = f(moved(k3, h), t + h)
    return [x[i] + h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]) for i in range(2)]

for line in sys.stdin:
    c = json.loads(line)
    x, t, h, u, p = c["q"] + c["v"], c["t"], c["h"], c["u"][0], c["p"]
    tiny = 1e-100j
    along = lambda x, u: [y.imag / 1e-100 for y in advanced(x, t, h, u, p)]
    a, b, d = along([x[0] + tiny, x[1]], u), along([x[0], x[1] + tiny], u), along(x, u + tiny)
    if c["function"] == "step_derivatives":
        print(json.dumps([a[0], b[0], a[1], b[1], d[0], d[1]]))
    else:
        print(json.dumps([y.real for y in advanced(x, t, h, u, p)]))
)py";
  const auto compared = [&](const std::string& text, const std::string& function,
                            const std::string& input = "rk4.scene.toml") {
    return folder.compare_command(text, "--function " + function, input);
  };
  for (const char* const function : {"step", "advance", "step_derivatives"}) {
    CHECK(failure_of(compared(step, function)) == "");
  }
  const Outcome wrong =
      compared(replaced(step, "moved(k3, h), t + h)", "moved(k3, h), t)"), "step");
  CHECK(wrong.status == 1);
  CHECK(mentions(wrong.output, "  FAILS    "));
  CHECK(mentions(compared(step, "step", "forced.toml").errors, "error[E105]"));
  const Outcome evaluated = folder.run("elgen evaluate rk4.scene.toml --what step --state h=0.01");
  INFO(evaluated.output << evaluated.errors);
  CHECK(evaluated.status == 0);
  CHECK(mentions(evaluated.output, "step.coordinates"));
  CHECK(folder.run("elgen evaluate forced.toml --what step").status == 2);
  const Outcome vectors = folder.run("elgen vectors rk4.scene.toml --outputs step --samples 2");
  INFO(vectors.output << vectors.errors);
  CHECK(vectors.status == 0);
  CHECK(mentions(vectors.output, "\"function\": \"step\""));
}

TEST_CASE("without inputs a command gets an empty list and a library an unused pointer") {
  const Foreign folder;
  folder.write("mass.toml",
               "format = 1\n[model]\nname = \"mass\"\n[[coordinate]]\nname = \"x\"\nunit = \"m\"\n"
               "[parameters]\nm = { value = 2, unit = \"kg\" }\nk = { value = 3, unit = \"N/m\" }\n"
               "[energy]\nT = \"1/2*m*dot(x)^2\"\nV = \"1/2*k*x^2\"\n");
  CHECK(failure_of(folder.compare_command(
            "import json, sys\nfor line in sys.stdin:\n  c = json.loads(line)\n"
            "  assert c['u'] == []\n  print([-c['p']['k'] / c['p']['m'] * c['q'][0]])\n",
            forward, "mass.toml")) == "");
  folder.write("mass.c",
               "void forward_dynamics(const double *p, const double *q, const double *v,\n"
               "                      const double *u, double *a) {\n"
               "  (void)v, (void)u;\n  a[0] = -p[1] / p[0] * q[0];\n}\n");
  folder.prepare("cc -std=c99 -fPIC -shared mass.c -o mass.so");
  CHECK(failure_of(folder.run("elgen verify --foreign ./mass.so " + forward + " mass.toml")) == "");
}

}  // namespace elgen::test
