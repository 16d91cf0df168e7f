// Entries of a model: coordinates, inputs, points, bodies, forces, outputs, and tables that cannot
// be repeated.
#include <catch2/catch.hpp>

#include "check_testing.hpp"

namespace elgen::test {

namespace {

std::string with_J(const std::string& entries) {
  return block(
             "[parameters.J]\nvalue = 1\nunit = \"kg*m^2\"\n[[coordinate]]\nname = \"q\"\n"
             "unit = \"rad\"\narmature = \"J\"\n") +
         entries;
}

const std::string with_points = block(R"toml([[input]]
name = "u"
unit = "N"
[[point]]
name = "p"
at = ["x", "0"]
[[point]]
name = "r"
at = ["0", "0"]
[parameters.b]
value = 1
unit = "N*s/m"
)toml");

std::string named(const std::string& name) {
  return "format = 1\n[model]\nname = \"" + name +
         "\"\n[[coordinate]]\nname = \"x\"\nunit = \"m\"\n"
         "[energy]\nT = \"0*dot(x)^2\"\n";
}

}  // namespace

TEST_CASE("a coordinate keeps all its keys") {
  const Model model = checked(R"toml(format = 1
[model]
name = "a"
[[coordinate]]
name = "q"
unit = "rad"
range = ["-pi", "pi"]
rate_range = [-5, 5]
start = { value = 0.1, rate = "1/3" }
armature = "J"
singular = "sin(q)"
latex = '\theta'
doc = "an angle"
[parameters]
J = { value = 1, unit = "kg*m^2" }
)toml")
                          .model;
  const Coordinate& q = model.coordinates.front();
  CHECK(q.unit == Unit{});
  CHECK(q.unit_text == "rad");
  CHECK(is_angle(q));
  Coordinate pure = q;
  pure.unit_text = "1";
  CHECK_FALSE(is_angle(pure));
  const Velocity& rate = model.velocities[q.velocity];
  CHECK(rate.name == "q");
  CHECK(rate.unit == power(*find_unit("s"), {-1, 1}));
  REQUIRE(rate.rate_range);
  CHECK(rate.rate_range->low == -5);
  CHECK(q.start_value == cln::cl_RA(1) / 10);
  CHECK(rate.start_rate == cln::cl_RA(1) / 3);
  CHECK(q.latex == "\\theta");
  CHECK(q.doc == "an angle");
  REQUIRE(q.armature);
  CHECK(to_string(model, *q.armature) == "J");
  REQUIRE(q.singular_condition);
  CHECK(to_string(model, *q.singular_condition) == "sin(q)");
}

TEST_CASE("refused keys of coordinates, inputs and prescribed functions") {
  const Rows rows{
      {"[[input]]\nname = \"u\"\nunit = \"N*m\"\non = \"x\"\n",
       "E403 14:9 `u` is in N*m, but a force on `x` is in N\n"},
      {"[[input]]\nname = \"u\"\nunit = \"N\"\non = \"xx\"\n",
       "E201 15:7 unknown coordinate `xx` | did you mean `x`? (coordinate, line 5)\n"},
      {"[[input]]\nname = \"u\"\nunit = \"N\"\nlimits = [1, 1]\n",
       "E112 15:10 `1` is not below `1`\n"},
      {"[[input]]\nname = \"u\"\nunit = \"N\"\nlimits = [\"m\", 1]\n",
       "E319 15:12 `m` is not a constant number\n"},
      {"[[prescribed]]\nname = \"h\"\nunit = \"m\"\nvalue = \"x\"\n",
       "E319 15:10 `x` is a coordinate, but a prescribed function takes none\n"},
      {"[[prescribed]]\nname = \"h\"\nunit = \"m\"\nvalue = \"t\"\n",
       "E403 15:10 `t` is in s, but a prescribed function is in m\n"},
      {"[[coordinate]]\nname = \"y\"\nunit = \"m\"\narmature = \"x*m\"\n",
       "E506 15:13 `x` is a coordinate, but an armature takes none | write a variable term in "
       "`[energy] T`\n"},
      {"[[coordinate]]\nname = \"y\"\nunit = \"m\"\narmature = \"m\"\nsingular = \"dot(y)\"\n",
       "E319 16:13 `dot(y)` is a rate, but a singular configuration takes none\n"},
  };
  check_rows(rows, [&](const std::string& entries) { return messages(block(entries)); });
}

TEST_CASE("a prescribed function of time may occur in a potential") {
  const std::string model = block(
      "V = \"1/2*k*(x - h)^2\"\n[[prescribed]]\nname = \"h\"\nvalue = \"A*sin(w*t)\"\n"
      "[parameters.A]\nvalue = 1\nunit = \"m\"\n[parameters.w]\nvalue = 1\nunit = \"rad/s\"\n");
  CHECK(messages(model).empty());
  CHECK(dump_lines(model, "prescribed") == "prescribed h = A*sin(w*t)\n");
  CHECK(dump_lines(model, "time") == "time yes\n");
}

TEST_CASE("an angle wraps, also if all units of the model are 1") {
  const auto turned = [](const std::string& unit, const std::string& parameter) {
    return "format = 1\n[model]\nname = \"turned\"\n[[coordinate]]\nname = \"q\"\nunit = \"" +
           unit + "\"\nwrap = true\n[parameters]\nJ = { value = 1" + parameter +
           " }\n[energy]\nT = \"1/2*J*dot(q)^2\"\n";
  };
  CHECK(checked(turned("rad", "")).model.coordinates.front().wraps);
  CHECK(checked(turned("rad", ", unit = \"kg*m^2\"")).model.coordinates.front().wraps);
  CHECK(messages(turned("m", ", unit = \"kg\"")).find("E528") == 0);
}

TEST_CASE("points are padded to three components") {
  const Model model =
      checked(with_J("[[point]]\nname = \"p\"\nat = [\"x\", \"0\"]\nmass = \"m\"\n")).model;
  CHECK(model.points[0].dimension == 2);
  CHECK(to_string(model, model.points[0].position[2]) == "0");
  REQUIRE(model.points[0].mass);
}

TEST_CASE("the inertia of a planar body is one number, of a spatial body three or six") {
  const Model planar = checked(with_J("[[body]]\nname = \"b\"\nmass = \"m\"\ncom = [\"x\", \"0\"]\n"
                                      "spin = \"dot(q)\"\ninertia = \"J\"\n"))
                           .model;
  CHECK(planar.bodies[0].dimension == 2);
  CHECK(planar.bodies[0].inertia.size() == 1);
  const Model spatial =
      checked(with_J("[[body]]\nname = \"b\"\nspin = [\"0\", \"dot(q)\", \"0\"]\n"
                     "inertia = [\"J\", \"J\", \"J\"]\ninertia_about = \"com\"\n"))
          .model;
  CHECK(spatial.bodies[0].dimension == 3);
  REQUIRE(spatial.bodies[0].inertia.size() == 6);
  CHECK(to_string(spatial, spatial.bodies[0].inertia[5]) == "0");
  CHECK_FALSE(spatial.bodies[0].mass);
}

TEST_CASE("refused masses and inertias") {
  const Rows rows{
      {"[[point]]\nname = \"p\"\nat = [\"x\"]\n",
       "E104 21:6 1 component, but a vector has 2 or 3\n"},
      {"[[point]]\nname = \"p\"\nat = [\"dot(x)\", \"0\"]\n",
       "E319 21:8 `dot(x)` is a rate, but a position takes none\n"},
      {"[[point]]\nname = \"p\"\nat = [\"x\", \"q\"]\n",
       "E403 21:13 `q` is in 1, but a position is in m\n"},
      {"[[point]]\nname = \"p\"\nat = [\"x\", \"0\"]\nmass = \"m*t\"\n",
       "E506 22:11 `t` is time, but a mass takes none | write a variable term in `[energy] T`\n"},
      {"[[point]]\nname = \"p\"\nat = [\"x\", \"0\"]\n[[point]]\nname = \"r\"\nat = [\"x\", \"0\", "
       "\"0\"]\n",
       "E516 24:6 3 components, but other vectors of this model have 2\n"},
      {"[[body]]\nname = \"b\"\nspin = \"dot(q)\"\ninertia = \"J\"\ninertia_about = \"origin\"\n",
       "E112 23:1 a body without `frame` has no origin, so its inertia cannot be about the origin "
       "| give the inertia about the centre of mass, or give the body a frame; if the body turns "
       "about a fixed point, omit its mass and add its weight to `[energy] V`\n"},
      {"[[body]]\nname = \"b\"\nmass = \"m\"\n", "E105 19:1 `b` has `mass` but no `com`\n"},
      {"[[body]]\nname = \"b\"\ninertia = \"J\"\n",
       "E105 19:1 `b` has `inertia` but no `spin` | give it a `frame`, or a `spin` such as "
       "`dot(theta)`\n"},
      {"[[body]]\nname = \"b\"\nspin = \"dot(q)\"\n",
       "E105 19:1 `b` has `spin` but no `inertia`\n"},
      {"[[body]]\nname = \"b\"\nspin = \"dot(q)\"\ninertia = [\"J\", \"J\", \"J\"]\n",
       "E516 22:11 3 moments of inertia for a planar body | a planar body has 1, a spatial body 3 "
       "or 6: xx yy zz xy xz yz\n"},
      {"[[body]]\nname = \"b\"\nspin = [\"dot(q)\", \"0\"]\ninertia = [\"J\", \"J\", \"J\"]\n",
       "E104 21:8 2 components, but a spin has 1 or 3\n"},
      {"[[body]]\nname = \"b\"\nmass = \"m\"\ncom = [\"x\", \"0\", \"0\"]\nspin = "
       "\"dot(q)\"\ninertia = \"J\"\n",
       "E516 23:9 a planar spin, but the centre of mass has 3 components\n"},
      {"[[body]]\nname = \"b\"\nspin = \"dot(x)\"\ninertia = \"J\"\n",
       "E403 21:9 `dot(x)` is in m/s, but a spin is in 1/s\n"},
      {"[[body]]\nname = \"b\"\nspin = \"dot(q)\"\ninertia = \"m\"\n",
       "E403 22:12 `m` is in kg, but an inertia is in kg*m^2\n"},
  };
  check_rows(rows, [&](const std::string& entries) { return messages(with_J(entries)); });
}

TEST_CASE("a point joins points, frames and the origin only") {
  const std::string point = "[[point]]\nname = \"p\"\nat = [\"x\", \"0\"]\n";
  const Rows rows{
      {"joined_to = [\"p\", \"arm\", \"origin\"]\n", ""},
      {"joined_to = \"r\"\n", "E201 22:14 unknown place `r`\n"},
      {"joined_to = \"orign\"\n", "E201 22:14 unknown place `orign` | did you mean `origin`?\n"},
      {"joined_to = \"world\"\n",
       "E201 22:14 unknown place `world` | the origin of the world is `origin`\n"},
      {"joined_to = [\"arm\", \"x\"]\n", "E201 22:22 unknown place `x`\n"},
      {"joined_to = \"link[3]\"\n",
       "E201 22:14 there is no `link[3]`: `link` has the elements 1 to 2\n"},
      {"joined_to = \"link\"\n",
       "E208 22:14 `link` needs an index: `link` has the elements 1 to 2\n"},
      {"joined_to = \"p[1]\"\n", "E208 22:14 `p` takes no index\n"},
      {"joined_to = 2\n", "E201 22:13 unknown place `2`\n"},
      {"as = \"spring\"\n", "E105 22:1 `p` has `as` but no `joined_to`\n"},
  };
  const std::string others =
      "[[frame]]\nname = \"arm\"\nparent = \"world\"\n[[point]]\nname = \"link[i]\"\n"
      "for = \"i in 1..2\"\nat = [\"i*x\", \"0\"]\n";
  check_rows(rows, [&](const std::string& key) { return messages(with_J(point + key + others)); });
}

TEST_CASE("forces act on a coordinate or at a point, with an optional reaction at another point") {
  CHECK(dump_lines(
            with_points + "[[force]]\nname = \"damper\"\non = \"x\"\nvalue = \"u - b*dot(x)\"\n"
                          "[[force]]\nat = \"p\"\nfrom = \"r\"\nvalue = [\"u\", \"0\"]\n",
            "force") == "force damper on x = [u - b*dot(x)]\nforce  at p from r = [u, 0, 0]\n");
}

TEST_CASE("outputs are a scalar or a list, optionally with Jacobians") {
  CHECK(dump_lines(with_points +
                       "[[output]]\nname = \"tip\"\nvalue = [\"x(p)\", \"y(p)\"]\njacobian = true\n"
                       "[[output]]\nname = \"length\"\nvalue = \"x\"\n",
                   "output") == "output tip = [x(p), y(p)], jacobian\noutput length = [x]\n");
}

TEST_CASE("an output of a point is its position") {
  CHECK(dump_lines(block("[[point]]\nname = \"bob\"\nat = [\"x\", \"2*x\"]\n"
                         "[[output]]\nname = \"tip\"\npoint = \"bob\"\njacobian = true\n"),
                   "output") == "output tip = [x(bob), y(bob)], jacobian\n");
  CHECK(messages(block("[[output]]\nname = \"tip\"\npoint = \"bob\"\n")) ==
        "E201 14:10 unknown point `bob`\n");
}

TEST_CASE("refused forces and outputs") {
  const Rows rows{
      {"[[force]]\nvalue = \"u\"\n", "E112 24:1 the force has none of `on`, `at` and `frame`\n"},
      {"[[force]]\nat = \"p\"\non = \"x\"\nvalue = \"u\"\n",
       "E112 26:1 a force has exactly one of `on`, `at` and `frame`\n"},
      {"[[force]]\non = \"p\"\nvalue = \"u\"\n",
       "E201 25:7 unknown coordinate `p` | `p` is a point: write `at` in the place of `on`\n"},
      {"[[force]]\non = \"x\"\nvalue = [\"u\", \"0\"]\n",
       "E104 26:9 a list, but a generalised force is one number\n"},
      {"[[force]]\nat = \"p\"\nvalue = \"u\"\n", "E516 26:10 1 component, but the point has 2\n"},
      {"[[force]]\nat = \"p\"\nfrom = \"s\"\nvalue = [\"u\", \"0\"]\n",
       "E201 26:9 unknown point `s`\n"},
      {"[[force]]\non = \"x\"\nvalue = \"u*u/u\"\n",
       "E509 26:10 `u*u/u` is not linear in the inputs\n"},
      {"[[force]]\non = \"x\"\nvalue = \"u*tanh(dot(x)*b/u)\"\n",
       "E509 26:10 `u*tanh(dot(x)*b/u)` is not linear in the inputs\n"},
      {"[[force]]\non = \"x\"\nvalue = \"b*dot(x)*u*x/(x*b*dot(x))\"\n",
       "E509 26:10 `b*dot(x)*u*x/(x*b*dot(x))` multiplies an input by a rate\n"},
      {"[[force]]\non = \"x\"\nvalue = \"m*x\"\n",
       "E403 26:10 `m*x` is in kg*m, but a force is in N\n"},
      {"[[force]]\non = \"x\"\nvalue = \"m*dot(dot(x))\"\n",
       "E502 26:12 `dot(dot(x))` is a second derivative, but a force takes none\n"},
      {"[[output]]\nname = \"o\"\nvalue = \"p(x)\"\n",
       "E319 26:10 `p(x)` is a momentum, but an output takes none | it is allowed in `[[expect]]`: "
       "in `conserved`, and in outputs that take momenta\n"},
      {"[[output]]\nname = \"bias\"\nvalue = \"x\"\n",
       "E609 25:9 another output is already called `bias`\n"},
      {"[[output]]\nname = \"o\"\nvalue = \"x\"\njacobian = true\n[[output]]\nname = "
       "\"o_jacobian\"\n"
       "value = \"x\"\n",
       "E609 29:9 another output is already called `o_jacobian`\n"},
      {"[[output]]\nname = \"u\"\nvalue = \"x\"\n",
       "E203 25:9 `u` is already an input | first at line 13\n"},
  };
  check_rows(rows, [&](const std::string& entries) { return messages(with_points + entries); });
}

TEST_CASE("functions with kinks are allowed in forces") {
  CHECK(messages(with_points + "[[force]]\non = \"x\"\nvalue = \"-min(abs(b*dot(x)), 1*b*dot(x)) + "
                               "sign(dot(x))*u\"\n")
            .substr(0, 10) == "E509 26:10");
  CHECK(messages(with_points + "[[force]]\non = \"x\"\nvalue = \"-b*abs(dot(x))\"\n").empty());
}

TEST_CASE("the name of a model is lower case and free in C++") {
  CHECK(messages(named("arm_2")).empty());
  CHECK(messages(named("Arm")) ==
        "E205 3:9 `Arm` is not lower-case letters, digits and underscores\n");
  CHECK(messages(named("class")) ==
        "E204 3:9 `class` is reserved: it is a keyword of C++ | `class_1` is free\n");
}

TEST_CASE("texts for the header are kept") {
  const Model model = checked(
                          "format = 1\n[model]\nname = \"a\"\ntitle = \"A\"\ndescription = \"B\"\n"
                          "reference = \"C\"\n[[coordinate]]\nname = \"x\"\nunit = \"m\"\n"
                          "[energy]\nT = \"0*dot(x)^2\"\n")
                          .model;
  CHECK(model.title == "A");
  CHECK(model.description == "B");
  CHECK(model.reference == "C");
}

TEST_CASE("definitions may be in any order") {
  const std::string model = block("V = \"a*x\"\n[define]\na = \"b/2\"\nb = \"k*x\"\n");
  CHECK(dump_lines(model, "definition") == "definition a = b/2\ndefinition b = k*x\n");
  CHECK(messages(model).empty());
}

TEST_CASE("gravity is an acceleration of two or three components") {
  const Rows rows{
      {"[gravity]\nvector = [\"0\", \"-m\"]\n",
       "E403 13:17 `-m` is in kg, but gravity is in m/s^2\n"},
      {"[gravity]\nvector = [\"0\"]\n", "E104 13:10 1 component, but a vector has 2 or 3\n"},
      {"[gravity]\nvector = [\"0\", \"x\"]\n",
       "E319 13:17 `x` is a coordinate, but gravity takes none\n"},
      {"[[point]]\nname = \"p\"\nat = [\"x\", \"0\", \"0\"]\n[gravity]\nvector = [\"0\", \"0\"]\n",
       "E516 16:10 2 components, but other vectors of this model have 3\n"},
  };
  check_rows(rows, [&](const std::string& entries) { return messages(block(entries)); });
}

TEST_CASE("energies are in joule, dissipation in watt, and neither depends on an input") {
  const Rows rows{
      {"V = \"m*x\"\n", "E403 12:6 `m*x` is in kg*m, but V is in J\n"},
      {"D = \"k*x^2\"\n", "E403 12:6 `k*x^2` is in J, but D is in W\n"},
      {"V = \"u*x\"\n[[input]]\nname = \"u\"\nunit = \"N\"\n",
       "E319 12:6 `u` is an input, but V takes none | an input acts by its key `on`, or in a "
       "`[[force]]`\n"},
      {"V = \"abs(k*x^2)\"\n",
       "E315 12:6 `abs(k*x^2)` is a function with a kink, but V takes none | a smooth "
       "approximation is tanh(x/width)\n"},
      {"V = \"e*x\"\n[define]\ne = \"u\"\n[[input]]\nname = \"u\"\nunit = \"N\"\n",
       "E319 12:6 `e` contains an input, but V takes none | an input acts by its key `on`, or in a "
       "`[[force]]`\n"},
  };
  check_rows(rows, [&](const std::string& entries) { return messages(block(entries)); });
}

}  // namespace elgen::test
