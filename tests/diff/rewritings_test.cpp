// Systems in two hand-written forms: bodies on frames and in the world, chains of three to seven
// links, different definitions. The two forms are equal; one inserted error makes them different.
#include <catch2/catch.hpp>
#include <sstream>

#include "diff/versions.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// A system in two hand-written forms.
struct Rewriting {
  const char* what;
  const char* coordinates;  ///< names of scalars; `attitude` is a rotation
  int links;                ///< if positive: a chain q[1] ... q[links] instead of `coordinates`
  const char* before;       ///< the model after [parameters]
  const char* after;
  const char* part;  ///< the part of `after` that `wrong` replaces
  const char* wrong;
};

std::string text_of(const Rewriting& pair, const char* rest) {
  std::string text;
  if (pair.links > 0) {
    text = "[sizes]\nn = " + std::to_string(pair.links) +
           "\n[[coordinate]]\nfor = \"i in 1..n\"\nname = \"q[i]\"\n";
  }
  std::istringstream names(pair.coordinates);
  for (std::string name; names >> name;) {
    text += "[[coordinate]]\nname = \"" + name + "\"\n";
    if (name == "attitude") text += "kind = \"rotation\"\n";
  }
  return model_text("pair", text + R"toml([parameters]
m = { value = 2, assume = "positive" }
l = { value = "1/2", assume = "positive" }
c = { value = 3, assume = "positive" }
k = 4
A = { value = "1/20" }
C = { value = "1/50" }
g = 9.81
)toml" + rest);
}

/// Checks that `after` is equal to `before`, and different if `wrong` replaces `part`.
void check_pairs(const Rewriting& pair) {
  INFO(pair.what);
  const std::string before = text_of(pair, pair.before);
  const std::string after = text_of(pair, pair.after);
  CHECK(impact_row(compared(before, after).impact).word == "equal");
  const std::string wrong = replaced(after, pair.part, pair.wrong);
  CHECK(impact_row(compared(before, wrong).impact).word == "different");
}

constexpr const char* bob = R"toml([[point]]
name = "bob"
at = ["l*sin(q)", "-l*cos(q)"]
mass = "m"
[gravity]
vector = ["0", "-g"]
)toml";

const Rewriting bodies[]{
    {"a point in the world, and on a frame that turns", "q", 0, bob,
     R"toml([[frame]]
name = "rod"
parent = "world"
rotate = [["z", "q"]]
[[point]]
name = "bob"
frame = "rod"
at = ["0", "-l"]
mass = "m"
[gravity]
vector = ["0", "-g"]
)toml",
     R"("-l"])", R"("-1.000000000001*l"])"},
    {"a body with a spin, and on a frame about its origin", "q", 0,
     R"toml([[body]]
name = "link"
mass = "m"
com = ["l*sin(q)", "-l*cos(q)"]
inertia = "A"
spin = "dot(q)"
[gravity]
vector = ["0", "-g"]
)toml",
     R"toml([[frame]]
name = "rod"
parent = "world"
rotate = [["z", "q"]]
[[body]]
name = "link"
frame = "rod"
mass = "m"
com = ["0", "-l"]
inertia = "A + m*l^2"
inertia_about = "origin"
[gravity]
vector = ["0", "-g"]
)toml",
     "A + m*l^2", "A + m*l^2/2"},
    {"a point, and its energies by hand", "q", 0, bob,
     "[energy]\nT = \"1/2*m*l^2*dot(q)^2\"\nV = \"-m*g*l*cos(q)\"\n", "-m*g*l", "m*g*l"},
    {"two rods of absolute angles, and of nested frames", "q1 q2", 0,
     R"toml([[point]]
name = "upper"
at = ["l*sin(q1)", "-l*cos(q1)"]
mass = "m"
[[point]]
name = "lower"
at = ["x(upper) + c*sin(q2)", "y(upper) - c*cos(q2)"]
mass = "2*m"
[gravity]
vector = ["0", "-g"]
)toml",
     R"toml([[frame]]
name = "first"
parent = "world"
rotate = [["z", "q1"]]
[[frame]]
name = "second"
parent = "first"
translate = ["0", "-l"]
rotate = [["z", "q2 - q1"]]
[[point]]
name = "upper"
frame = "first"
at = ["0", "-l"]
mass = "m"
[[point]]
name = "lower"
frame = "second"
at = ["0", "-c"]
mass = "2*m"
[gravity]
vector = ["0", "-g"]
)toml",
     "q2 - q1", "q2"},
    {"a rotary pendulum of bodies with spins, and on frames", "q1 q2", 0,
     R"toml([[body]]
name = "arm"
inertia = ["0", "A", "A"]
spin = ["0", "0", "dot(q1)"]
[[body]]
name = "pendulum"
mass = "m"
com = ["l*cos(q1) - c*sin(q2)*sin(q1)", "l*sin(q1) + c*sin(q2)*cos(q1)", "-c*cos(q2)"]
inertia = ["C", "2*C", "3*C"]
spin = ["-cos(q2)*dot(q1)", "sin(q2)*dot(q1)", "dot(q2)"]
[gravity]
vector = ["0", "0", "-g"]
)toml",
     R"toml([[frame]]
name = "arm"
parent = "world"
rotate = [["z", "q1"]]
[[frame]]
name = "pendulum"
parent = "arm"
translate = ["l", "0", "0"]
rotate = [["x", "q2"]]
[[body]]
name = "arm"
frame = "arm"
inertia = ["0", "A", "A"]
[[body]]
name = "pendulum"
frame = "pendulum"
mass = "m"
com = ["0", "0", "-c"]
inertia = ["3*C", "2*C", "C"]
[gravity]
vector = ["0", "0", "-g"]
)toml",
     R"("3*C", "2*C")", R"("3*C", "C")"},
    {"a top of Euler's angles, and on a frame", "phi theta psi", 0,
     R"toml([[body]]
name = "top"
inertia = ["A", "A", "C"]
spin = ["dot(phi)*sin(theta)*sin(psi) + dot(theta)*cos(psi)",
        "dot(phi)*sin(theta)*cos(psi) - dot(theta)*sin(psi)", "dot(phi)*cos(theta) + dot(psi)"]
[energy]
V = "m*g*l*cos(theta)"
)toml",
     R"toml([[frame]]
name = "axes"
parent = "world"
rotate = [["z", "phi"], ["x", "theta"], ["z", "psi"]]
[[body]]
name = "top"
frame = "axes"
inertia = ["A", "A", "C"]
[[point]]
name = "centre"
frame = "axes"
at = ["0", "0", "l"]
[energy]
V = "m*g*z(centre)"
)toml",
     R"(["z", "psi"])", R"(["y", "psi"])"},
    {"an eccentric mass as a body, and as a point", "x attitude", 0,
     R"toml([[frame]]
name = "axes"
parent = "world"
translate = ["x", "0", "0"]
rotation = "attitude"
[[body]]
name = "stone"
frame = "axes"
mass = "m"
com = ["l", "0", "0"]
inertia = ["A", "A", "C"]
)toml",
     R"toml([[frame]]
name = "axes"
parent = "world"
translate = ["x", "0", "0"]
rotation = "attitude"
[[body]]
name = "stone"
frame = "axes"
inertia = ["A", "A", "C"]
[[point]]
name = "centre"
frame = "axes"
at = ["l", "0", "0"]
mass = "m"
)toml",
     R"(["l", "0", "0"])", R"(["0", "l", "0"])"},
};

constexpr const char* chain_of_points = R"toml([[point]]
name = "p[0]"
at = ["0", "0"]
[[point]]
for = "i in 1..n"
name = "p[i]"
at = ["x(p[i-1]) + l*sin(q[i])", "y(p[i-1]) - l*cos(q[i])"]
mass = "m"
[gravity]
vector = ["0", "-g"]
)toml";

constexpr const char* chain_of_sums = R"toml([[point]]
for = "i in 1..n"
name = "p[i]"
at = ["l*sum(k, 1, i, sin(q[k]))", "-l*sum(k, 1, i, 1 - 2*sin(q[k]/2)^2)"]
mass = "m"
[gravity]
vector = ["0", "-g"]
)toml";

constexpr const char* chain_of_frames = R"toml([[frame]]
name = "f[1]"
parent = "world"
rotate = [["z", "q[1]"]]
[[frame]]
for = "i in 2..n"
name = "f[i]"
parent = "f[i-1]"
translate = ["0", "-l"]
rotate = [["z", "q[i] - q[i-1]"]]
[[point]]
for = "i in 1..n"
name = "p[i]"
frame = "f[i]"
at = ["0", "-l"]
mass = "m"
[gravity]
vector = ["0", "-g"]
)toml";

constexpr const char* springs = R"toml([energy]
T = "1/2*m*sum(i, 1, n, dot(q[i])^2)"
V = "1/2*k*sum(i, 2, n, (q[i] - q[i-1])^2)"
)toml";

constexpr const char* products = R"toml([energy]
T = "m*sum(i, 1, n, dot(q[i])^2/2)"
V = "1/2*k*(q[1]^2 + q[n]^2) + k*sum(i, 2, n - 1, q[i]^2) - k*sum(i, 2, n, q[i]*q[i-1])"
)toml";

const Rewriting chains[]{
    {"a chain of three, and of sums", "", 3, chain_of_points, chain_of_sums, "1 - 2*sin",
     "1 - 2.000000000002*sin"},
    {"a chain of four, and of frames", "", 4, chain_of_points, chain_of_frames, "q[i] - q[i-1]",
     "q[i]"},
    {"a chain of five, and of sums", "", 5, chain_of_points, chain_of_sums, "i, sin(q[k])",
     "i, sin(1.000000000001*q[k])"},
    {"six masses between springs, and their products", "", 6, springs, products, "- k*sum",
     "- 1.000000000001*k*sum"},
    {"seven masses between springs, and their products", "", 7, springs, products, "2, n - 1",
     "3, n - 1"},
    {"a chain of seven, and of frames", "", 7, chain_of_points, chain_of_frames,
     "translate = [\"0\", \"-l\"]", "translate = [\"0\", \"-1.000000000001*l\"]"},
};

const Rewriting definitions[]{
    {"an angle, and twice its half", "q", 0, "[energy]\nT = \"1/2*A*dot(q)^2\"\nV = \"c*cos(q)\"\n",
     "[define]\nhalf = \"q/2\"\n[energy]\nT = \"2*A*dot(half)^2\"\n"
     "V = \"c*(1 - 2*sin(half)^2)\"\n",
     "2*A", "A"},
    {"an angle, and the tangent of its half", "q", 0,
     "[energy]\nT = \"1/2*A*dot(q)^2\"\nV = \"c*sin(q)\"\n",
     "[define]\nu = \"tan(q/2)\"\n[energy]\nT = \"1/2*A*dot(q)^2\"\nV = \"2*c*u/(1 + u^2)\"\n",
     "1 + u^2", "1 - u^2"},
    {"a sum of angles, and its defined parts", "q1 q2", 0,
     "[energy]\nT = \"A*(dot(q1)^2 + dot(q2)^2)\"\nV = \"c*sin(q1 + q2) + c*cos(q1 - q2)\"\n",
     "[define]\ns = \"sin(q1)*cos(q2)\"\nr = \"cos(q1)*sin(q2)\"\n"
     "[energy]\nT = \"A*(dot(q1)^2 + dot(q2)^2)\"\n"
     "V = \"c*(s + r) + c*(cos(q1)*cos(q2) + sin(q1)*sin(q2))\"\n",
     "c*(s + r)", "c*(s - r)"},
    {"absolute angles, and relative ones", "q1 q2", 0,
     "[energy]\nT = \"A*(dot(q1)^2 + (dot(q1) + dot(q2))^2)\"\nV = \"c*cos(q1 + q2)\"\n",
     "[define]\nabsolute = \"q1 + q2\"\n"
     "[energy]\nT = \"A*(dot(q1)^2 + dot(absolute)^2)\"\nV = \"c*cos(absolute)\"\n",
     "absolute = \"q1 + q2\"", "absolute = \"q1 + 1.000000000001*q2\""},
    {"a length of an arc", "q", 0, "[energy]\nT = \"1/2*m*l^2*dot(q)^2\"\n",
     "[define]\ns = \"l*q\"\n[energy]\nT = \"1/2*m*dot(s)^2\"\n", "1/2*m", "0.5000000000005*m"},
    {"a point on a sphere, and its speeds", "theta phi", 0,
     "[[point]]\nname = \"bob\"\n"
     "at = [\"l*sin(theta)*cos(phi)\", \"l*sin(theta)*sin(phi)\", \"-l*cos(theta)\"]\n"
     "mass = \"m\"\n[gravity]\nvector = [\"0\", \"0\", \"-g\"]\n",
     "[energy]\nT = \"1/2*m*l^2*(dot(theta)^2 + (1 - cos(theta)^2)*dot(phi)^2)\"\n"
     "V = \"-m*g*l*cos(theta)\"\n",
     "1 - cos", "1 + cos"},
    {"a spring of a length, and its square", "x y", 0,
     "[energy]\nT = \"1/2*m*(dot(x)^2 + dot(y)^2)\"\nV = \"1/2*k*(sqrt(x^2 + y^2) - l)^2\"\n",
     "[define]\nr2 = \"x^2 + y^2\"\nr = \"sqrt(r2)\"\n"
     "[energy]\nT = \"1/2*m*(dot(x)^2 + dot(y)^2)\"\nV = \"1/2*k*(r2 - 2*l*r + l^2)\"\n",
     "2*l*r", "2*r"},
    {"hyperbolic functions", "x", 0, "[energy]\nT = \"1/2*m*cosh(x)^2*dot(x)^2\"\n",
     "[energy]\nT = \"1/2*m*(1 + sinh(x)^2)*dot(x)^2\"\n", "1 + sinh", "1 - sinh"},
    {"exponentials", "x", 0, "[energy]\nT = \"1/2*m*dot(x)^2\"\nV = \"k*cosh(x)\"\n",
     "[energy]\nT = \"1/2*m*dot(x)^2\"\nV = \"k*(exp(x) + 1/exp(x))/2\"\n", "+ 1/exp", "- 1/exp"},
    {"a hyperbolic function by exponentials in a denominator", "x", 0,
     "[energy]\nT = \"1/2*m*dot(x)^2\"\nV = \"k*tanh(x)\"\n",
     "[energy]\nT = \"1/2*m*dot(x)^2\"\nV = \"k*(exp(2*x) - 1)/(1 + 1/exp(-2*x))\"\n", "exp(-2*x)",
     "exp(-3*x)"},
    {"a rod that turns with time, and a point", "x", 0,
     "[[point]]\nname = \"bead\"\nat = [\"x*cos(c*t)\", \"x*sin(c*t)\"]\nmass = \"m\"\n"
     "[gravity]\nvector = [\"0\", \"-g\"]\n",
     "[energy]\nT = \"1/2*m*(dot(x)^2 + c^2*x^2)\"\nV = \"2*m*g*x*sin(c*t/2)*cos(c*t/2)\"\n",
     "+ c^2", "- c^2"},
    {"a damper between two, and its square", "q1 q2", 0,
     "[energy]\nT = \"A*(dot(q1)^2 + dot(q2)^2)\"\nD = \"1/2*C*(dot(q1) - dot(q2))^2\"\n",
     "[energy]\nT = \"A*(dot(q1)^2 + dot(q2)^2)\"\n"
     "D = \"C*(dot(q1)^2/2 + dot(q2)^2/2 - dot(q1)*dot(q2))\"\n",
     "C*(dot", "1.000000000001*C*(dot"},
    {"a length that is never 0", "x", 0,
     "[energy]\nT = \"1/2*m*dot(x)^2\"\nV = \"k*c^2*sqrt(1 + x^2/c^2)\"\n",
     "[energy]\nT = \"1/2*m*dot(x)^2\"\nV = \"k*c*sqrt(c^2 + x^2)\"\n", "k*c*", "k*c^2*"},
    {"a force with an input", "q", 0,
     "[energy]\nT = \"1/2*A*dot(q)^2\"\n[[input]]\nname = \"u\"\n"
     "[[force]]\non = \"q\"\nvalue = \"u*cos(q)^2 - k*dot(q)\"\n",
     "[energy]\nT = \"1/2*A*dot(q)^2\"\n[[input]]\nname = \"u\"\n"
     "[[force]]\non = \"q\"\nvalue = \"-k*dot(q) + u*(1 + cos(2*q))/2\"\n",
     "cos(2*q)", "cos(q)"},
};

}  // namespace

TEST_CASE("bodies on frames equal bodies in the world, but not with one error") {
  for (const Rewriting& pair : bodies) check_pairs(pair);
}

TEST_CASE("chains of three to seven links are equal in two forms, but not with one error") {
  for (const Rewriting& pair : chains) check_pairs(pair);
}

TEST_CASE("coordinates of a chain of three, five and seven links may be reordered") {
  for (const int n : {3, 5, 7}) {
    INFO(n);
    const std::string before = text_of({"", "", n, "", "", "", ""}, chain_of_points);
    const std::string after = replaced(before, "name = \"q[i]\"", "name = \"q[n + 1 - i]\"");
    const SystemChange found = compared(before, after);
    CHECK(breaks_silently(found));
    CHECK(count_of(found, EntryVerdict::different) == 0);
    if (n == 7) continue;  // would take seconds
    const std::string wrong = replaced(after, "+ l*sin", "+ 1.000000000001*l*sin");
    CHECK(count_of(compared(before, wrong), EntryVerdict::different) > 0);
  }
}

TEST_CASE("other definitions are equal, but not with one error") {
  for (const Rewriting& pair : definitions) check_pairs(pair);
}
