// Foreign code for models/cart_pole.toml, in C and in Python, and a folder in which it is compared.
#pragma once

#include <string>

#include "cli/cli_testing.hpp"

namespace elgen::test {

/// The accelerations of models/cart_pole.toml.
inline const std::string cart = R"c(#include <math.h>
#include <signal.h>
#include <unistd.h>
typedef double real;
void my_fd(const double *p, const double *q, const double *v, const double *u, double *result) {
  const real M = p[0], m = p[1], l = p[2], g = p[3];
  const real theta = q[1], w = v[1], force = u[0];
  const real s = sin(theta), c = cos(theta);
  const real a = (force + m * l * w * w * s - m * g * s * c) / (M + m * s * s);
  result[0] = a;
  result[1] = (g * s - c * a) / l;
}
)c";

/// A Python program that computes the same accelerations, and the mass matrix.
inline const std::string script = R"py(import json, math, sys

def forward_dynamics(p, q, v, u):
    s, c = math.sin(q[1]), math.cos(q[1])
    force = u[0] + p["m"] * p["l"] * v[1] ** 2 * s - p["m"] * p["g"] * s * c
    a = force / (p["M"] + p["m"] * s * s)
    return [a, (p["g"] * s - c * a) / p["l"]]

def mass_matrix(p, q):
    c = p["m"] * p["l"] * math.cos(q[1])
    return [[p["M"] + p["m"], c], [c, p["m"] * p["l"] ** 2]]

for line in sys.stdin:
    call = json.loads(line)
    print(json.dumps(globals()[call.pop("function")](**call)))
)py";

/// A folder with models and foreign code.
class Foreign : public Workspace {
 public:
  /// Compiles `text`, C code for the cart, and compares the code with the model.
  [[nodiscard]] Outcome compare_c(const std::string& text, const std::string& options = "") const {
    write("mine.c", text);
    prepare("cc -std=c99 -D_DEFAULT_SOURCE -O1 -fPIC -shared mine.c -o mine.so -lm");
    return run("elgen verify --foreign ./mine.so --function forward_dynamics=my_fd " + options +
               " " + models + "/cart_pole.toml");
  }
  /// Replaces `part` by `other` in the C code of the cart, and compares the code with the model.
  [[nodiscard]] Outcome compare_changed(const std::string& part, const std::string& other,
                                        const std::string& options = "") const {
    return compare_c(replaced(cart, part, other), options);
  }
  /// Runs `text`, a Python program, as a command and compares the program with `model`.
  [[nodiscard]] Outcome compare_command(const std::string& text, const std::string& functions,
                                        const std::string& model = models +
                                                                   "/cart_pole.toml") const {
    write("mine.py", text);
    return run("elgen verify --foreign 'python3 mine.py' " + functions + " " + model);
  }
};

}  // namespace elgen::test
