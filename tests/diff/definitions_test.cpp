// Systems by other definitions: each is equal to its other writing, and not equal with one thing
// wrong.
#include <catch2/catch.hpp>

#include "diff/rewriting.hpp"

using namespace elgen::test;

namespace {

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

TEST_CASE("other definitions are equal, but not with one thing wrong") {
  for (const Rewriting& pair : definitions) check_pairs(pair);
}
