// elgen verify --foreign: code that elgen did not write, correct or with typical errors.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/foreign_testing.hpp"

namespace elgen::test {
namespace {

const std::string another = "under another convention: ";

}  // namespace

TEST_CASE("correct foreign code agrees to the last digits") {
  const Foreign folder;
  const Outcome in_c = folder.compare_c(cart);
  INFO(in_c.output << in_c.errors);
  CHECK(in_c.status == 0);
  CHECK(mentions(in_c.output, "holds    my_fd as forward_dynamics  agrees at 60 states to "));
  CHECK(mentions(in_c.output, "tolerance  1e-09 of the largest entry\n"));
  CHECK(in_c.errors.empty());
  const Outcome in_python = folder.compare_command(
      script, "--function forward_dynamics --function mass_matrix --samples 20");
  INFO(in_python.output << in_python.errors);
  CHECK(in_python.status == 0);
  CHECK(mentions(in_python.output, "mass_matrix       agrees at 20 states to "));
  CHECK(mentions(in_python.output, "2 checks hold, 0 fail, 0 skipped\n"));
}

TEST_CASE("a wrong sign is located by the situation in which it matters") {
  const Foreign folder;
  const Outcome outcome = folder.compare_changed("+ m * l * w", "- m * l * w");
  INFO(outcome.output << outcome.errors);
  CHECK(outcome.status == 1);
  CHECK(mentions(outcome.output, "FAILS    my_fd as forward_dynamics  forward_dynamics."));
  CHECK(mentions(outcome.output, ", the oracle says "));
  CHECK(mentions(outcome.output, "found      wrong only when moving; agrees at rest\n"));
  CHECK(mentions(outcome.output, "worst at   q = ("));
  CHECK_FALSE(mentions(outcome.output, another));
  CHECK(outcome.errors.empty());
  const Outcome quiet = folder.compare_changed("+ m * l * w", "- m * l * w", "-q");
  CHECK(quiet.output == "cart_pole: 0 checks hold, 1 fails, 0 skipped\n");
  CHECK(mentions(quiet.errors, "error[E717]: `my_fd as forward_dynamics`: "));
  CHECK(mentions(quiet.errors, "wrong only when moving; agrees at rest"));
}

TEST_CASE("half a turn and a reversed direction of an angle are recognised") {
  const Foreign folder;
  const Outcome half_turn =
      folder.compare_changed("theta = q[1]", "theta = q[1] + 3.14159265358979324");
  INFO(half_turn.output);
  CHECK(half_turn.status == 1);
  CHECK(mentions(half_turn.output, "found      wrong even at rest\n"));
  CHECK(mentions(half_turn.output, another + "its `theta` is `theta + pi`\n"));
  // The angle is reversed: theta and theta'' change sign; theta' occurs only squared.
  const Outcome mirrored = folder.compare_c(replaced(
      replaced(cart, "theta = q[1]", "theta = -q[1]"), "(g * s - c * a)", "-(g * s - c * a)"));
  INFO(mirrored.output);
  CHECK(mentions(mirrored.output, another + "its `theta` is `-theta`\n"));
  const Outcome both = folder.compare_c(
      replaced(replaced(replaced(cart, "theta = q[1]", "theta = 3.14159265358979324 - q[1]"),
                        "(g * s - c * a)", "-(g * s - c * a)"),
               "result[0] = a", "result[0] = -a"));
  INFO(both.output);
  CHECK(both.status == 1);
  CHECK(mentions(both.output, another));
}

TEST_CASE("a reversed input matters only with inputs") {
  const Foreign folder;
  const Outcome outcome = folder.compare_changed("force = u[0]", "force = -u[0]");
  INFO(outcome.output);
  CHECK(outcome.status == 1);
  CHECK(mentions(outcome.output, "found      wrong only with inputs; agrees without them\n"));
  CHECK(mentions(outcome.output, another + "its `u` is `-u`\n"));
}

TEST_CASE("relative angles and another order of coordinates are recognised") {
  const Foreign folder;
  folder.write("links.toml", R"toml(format = 1
[model]
name = "links"
[[coordinate]]
name = "a"
unit = "rad"
[[coordinate]]
name = "b"
unit = "rad"
[parameters]
m = { value = 2, unit = "kg" }
l = { value = 0.5, unit = "m" }
[energy]
T = "1/2*m*l^2*(2*dot(a)^2 + 2*cos(a - b)*dot(a)*dot(b) + dot(b)^2)"
)toml");
  const std::string head =
      "import json, math, sys\nfor line in sys.stdin:\n  call = json.loads(line)\n"
      "  q, i = call['q'], call['p']['m'] * call['p']['l'] ** 2\n";
  const auto compared = [&](const std::string& matrix) {
    return folder.compare_command(head + matrix, "--function mass_matrix", "links.toml").output;
  };
  CHECK(mentions(compared("  c = i * math.cos(q[1])\n"
                          "  print([[3 * i + 2 * c, i + c], [i + c, i]])\n"),
                 another + "each of its angles is relative to the previous angle\n"));
  CHECK(mentions(compared("  c = i * math.cos(q[0] - q[1])\n  print([[i, c], [c, 2 * i]])\n"),
                 another + "its order of coordinates is `b`, `a`\n"));
  const std::string wrong =
      compared("  c = i * math.cos(q[0] - q[1])\n  print([i, c, 2 * c, i])\n");
  CHECK(mentions(wrong, "mass_matrix[a, a] is "));
  CHECK_FALSE(mentions(wrong, another));
}

TEST_CASE("a point mass instead of a rod is reported as a factor") {
  const Foreign folder;
  folder.write("rod.toml", R"toml(format = 1
[model]
name = "rod"
[[coordinate]]
name = "theta"
unit = "rad"
[parameters]
m = { value = 2, unit = "kg" }
l = { value = 0.5, unit = "m" }
g = { value = 9.81, unit = "m/s^2" }
[energy]
T = "1/6*m*l^2*dot(theta)^2"
V = "-1/2*m*g*l*cos(theta)"
)toml");
  const Outcome outcome = folder.compare_command(
      "import json, math, sys\nfor line in sys.stdin:\n  call = json.loads(line)\n"
      "  p = call['p']\n  print([-p['g'] / p['l'] * math.sin(call['q'][0])])\n",
      "--function forward_dynamics", "rod.toml");
  INFO(outcome.output << outcome.errors);
  CHECK(outcome.status == 1);
  CHECK(
      mentions(outcome.output, "found      is 0.666667 times the oracle's value at all states\n"));
}

TEST_CASE("a parameter replaced by a number is named") {
  const Foreign folder;
  const Outcome outcome = folder.compare_changed("g = p[3]", "g = 9.81");
  INFO(outcome.output);
  CHECK(outcome.status == 1);
  CHECK(mentions(
      outcome.output,
      "found      wrong only if parameters are varied; agrees at the parameters of the file\n"));
  CHECK(mentions(outcome.output, "found      ignores `g`\n"));
}

TEST_CASE("single precision agrees to the digits of float, and passes with a tolerance") {
  const Foreign folder;
  const Outcome outcome = folder.compare_changed("typedef double real", "typedef float real");
  INFO(outcome.output);
  CHECK(outcome.status == 1);
  CHECK(mentions(outcome.output, ", the precision of float\n"));
  CHECK(folder
            .run("elgen verify -q --tolerance 1e-4 --foreign ./mine.so --function "
                 "forward_dynamics=my_fd " +
                 models + "/cart_pole.toml")
            .status == 0);
}

TEST_CASE("code that cannot be called exits with 4") {
  const Foreign folder;
  folder.write("text.so", "no library\n");
  folder.write("mine.c", cart);
  folder.prepare("cc -fPIC -shared mine.c -o mine.so -lm");
  const auto compared = [&](const std::string& code) {
    const Outcome outcome = folder.run("elgen verify --function gravity=my_g --foreign " + code +
                                       " " + models + "/cart_pole.toml");
    CHECK(outcome.status == 4);
    return outcome.errors;
  };
  CHECK(compared("./mine.so") == "elgen: error[E716]: `./mine.so` has no function `my_g`\n");
  CHECK(mentions(compared("text.so"), "error[E716]: `text.so` cannot be loaded: "));
  folder.write("mine.py", script);
  const std::string of_script = compared("mine.py");
  CHECK(mentions(of_script, "error[E716]: `mine.py` cannot be loaded: "));
  CHECK(mentions(of_script, "\n      `--foreign \"python3 mine.py\"` runs a script\n"));
  CHECK(mentions(compared("./none.so"),
                 "`./none.so` is neither a file nor a command that could be run"));
}

TEST_CASE("incomplete options for foreign code are refused") {
  const Foreign folder;
  folder.write("mine.py", script);
  const std::string cart_pole = " " + models + "/cart_pole.toml";
  const auto refused = [&](const std::string& options) {
    const Outcome outcome = folder.run("elgen verify " + options + cart_pole);
    INFO(options);
    CHECK(outcome.status == 2);
    return outcome.errors;
  };
  const std::string code = "--foreign 'python3 mine.py' ";
  CHECK(mentions(refused("--foreign 'python3 mine.py'"), "--function"));
  CHECK(mentions(refused("--function gravity"), "--foreign"));
  CHECK(mentions(refused("--tolerance 1e-6"), "--foreign"));
  (void)refused(code + "--function gravity --tolerance 0");
  CHECK(mentions(refused(code + "--function gravity --tolerance nan"), "`nan` is no number"));
  (void)refused(code + "--function gravity --quick");
  CHECK(mentions(refused(code + "--function gravty"), "error[E601]: unknown output `gravty`"));
  CHECK(mentions(refused(code + "--function constraint_jacobian"), "error[E603]"));
  CHECK(mentions(refused(code + "--function gravity --function dynamics"),
                 "error[E603]: `dynamics` repeats other outputs"));
}

TEST_CASE("certificates of foreign code are JSON, and annotations name the model") {
  const Foreign folder;
  const Outcome outcome =
      folder.compare_changed("force = u[0]", "force = -u[0]", "--format json -o c.json");
  const auto json = nlohmann::json::parse(outcome.output);
  CHECK(json.at("fails") == 1);
  const auto& row = json.at("checks").at(0);
  CHECK(row.at("check") == "foreign code vs oracle");
  CHECK(row.at("findings").at(0) == "wrong only with inputs; agrees without them");
  CHECK(nlohmann::json::parse(outcome.errors).at("code") == "E717");
  CHECK(folder.read("c.json") == outcome.output);
  const Outcome annotated =
      folder.compare_changed("force = u[0]", "force = -u[0]", "-q --format github");
  CHECK(mentions(annotated.errors, "::error file="));
  CHECK(mentions(annotated.errors, "cart_pole.toml,line="));
}

// CartPole and Pendulum of OpenAI Gym (MIT licence, https://github.com/openai/gym,
// gym/envs/classic_control), rewritten from their equations: Barto, Sutton, Anderson, Neuronlike
// adaptive elements (1983), with the corrections of Florian, Correct equations for the dynamics of
// the cart-pole system (2007), without friction. `l` of the cart is half the length of its pole, a
// uniform rod.
TEST_CASE("the formulas of Gym's CartPole and Pendulum describe rods") {
  const Foreign folder;
  const std::string head = "format = 1\n[model]\nname = \"rod\"\n";
  const std::string angle = "[[coordinate]]\nname = \"theta\"\nunit = \"rad\"\n";
  const std::string values =
      "[parameters]\nm = { value = 0.1, unit = \"kg\" }\nl = { value = 0.5, unit = \"m\" }\n"
      "g = { value = 9.8, unit = \"m/s^2\" }\n";
  folder.write("cart.toml",
               head + "[[coordinate]]\nname = \"x\"\nunit = \"m\"\n" + angle + values +
                   "M = { value = 1, unit = \"kg\" }\n[[input]]\nname = \"u\"\nunit = \"N\"\non = "
                   "\"x\"\n[energy]\nT = \"1/2*(M + m)*dot(x)^2 + m*l*cos(theta)*dot(x)*dot(theta) "
                   "+ 2/3*m*l^2*dot(theta)^2\"\nV = \"m*g*l*cos(theta)\"\n");
  const std::string input = "[[input]]\nname = \"u\"\nunit = \"N*m\"\non = \"theta\"\n";
  const std::string energy = "[energy]\nT = \"1/6*m*l^2*dot(theta)^2\"\nV = \"";
  folder.write("upright.toml", head + angle + values + input + energy + "m*g*l/2*cos(theta)\"\n");
  folder.write("hanging.toml", head + angle + values + input + energy + "-m*g*l/2*cos(theta)\"\n");
  const std::string gym = R"py(import json, math, sys

def cart_pole(p, q, v, u):
    total_mass = p["M"] + p["m"]
    polemass_length = p["m"] * p["l"]
    costheta, sintheta = math.cos(q[1]), math.sin(q[1])
    temp = (u[0] + polemass_length * v[1] ** 2 * sintheta) / total_mass
    thetaacc = (p["g"] * sintheta - costheta * temp) / (
        p["l"] * (4.0 / 3.0 - p["m"] * costheta**2 / total_mass))
    return [temp - polemass_length * thetaacc * costheta / total_mass, thetaacc]

def pendulum(p, q, v, u):
    g, m, l = p["g"], p["m"], p["l"]
    return [3 * g / (2 * l) * math.sin(q[0]) + 3.0 / (m * l**2) * u[0]]

for line in sys.stdin:
    call = json.loads(line)
    print(json.dumps(globals()[call.pop("function")](**call)))
)py";
  const std::string cart_pole = "--function forward_dynamics=cart_pole";
  const std::string pendulum = "--function forward_dynamics=pendulum";
  CHECK(mentions(folder.compare_command(gym, cart_pole, "cart.toml").output,
                 "1 check holds, 0 fail"));
  const Outcome point_mass = folder.compare_command(gym, cart_pole);
  CHECK(point_mass.status == 1);
  CHECK(mentions(point_mass.output, "found      wrong even at rest\n"));
  CHECK_FALSE(mentions(point_mass.output, another));
  CHECK(mentions(folder.compare_command(gym, pendulum, "upright.toml").output,
                 "1 check holds, 0 fail"));
  CHECK(mentions(folder.compare_command(gym, pendulum, "hanging.toml").output,
                 another + "its `theta` is `theta + pi`\n"));
}

}  // namespace elgen::test
