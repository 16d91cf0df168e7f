// simulate -o NAME.html: an animated page in one file.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "cli/page_testing.hpp"
#include "support/installed.hpp"

namespace elgen::test {
namespace {

/// The largest difference, relative to the largest number.
double difference(const std::vector<double>& shown, const std::vector<double>& wanted) {
  REQUIRE(shown.size() == wanted.size());
  double apart = 0;
  double size = 0;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    apart = std::max(apart, std::abs(shown[i] - wanted[i]));
    size = std::max(size, std::abs(wanted[i]));
  }
  return apart / size;
}

/// Relative. A page and a run make the same steps up to rounding errors of the sines. If such an
/// error decided whether a step is accepted, the state would change by the tolerance of a step,
/// 1e-9, and the motions below amplify a change by less than 1000.
constexpr double page_tolerance = 1e-6;

/// A model with one coordinate x, which starts at `start`.
std::string one_coordinate(const std::string& start, const std::string& rest) {
  return "format = 1\n[model]\nname = \"one\"\n[[coordinate]]\nname = \"x\"\nstart = " + start +
         "\n[energy]\nT = \"1/2*dot(x)^2\"\n" + rest;
}

const std::string orbit = R"toml(format = 1
[model]
name = "orbit"
[[coordinate]]
name = "x"
start = { value = 1, rate = 0 }
[[coordinate]]
name = "y"
start = { value = 0, rate = 0.01 }
[energy]
T = "1/2*(dot(x)^2 + dot(y)^2)"
V = "-1/sqrt(x^2 + y^2)"
)toml";

/// A top that slides on a table, spun at 150 rad/s. It turns over within seconds.
const std::string tippe_top = R"toml(format = 1
[model]
name = "tippe_top"
[[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[[coordinate]]
name = "phi"
[[coordinate]]
name = "theta"
start = { value = 0.1 }
[[coordinate]]
name = "psi"
start = { value = 0, rate = 150 }
[parameters]
m = 0.02
R = 0.02
a = 0.003
A = 3e-6
C = 2.5e-6
g = 9.81
mu = 0.05
[[frame]]
name = "top"
parent = "world"
translate = ["x", "y", "R - a*cos(theta)"]
rotate = [["z", "phi"], ["x", "theta"], ["z", "psi"]]
[[body]]
name = "top"
frame = "top"
mass = "m"
inertia = ["A", "A", "C"]
[gravity]
vector = ["0", "0", "-g"]
[[point]]
name = "centre"
frame = "top"
at = ["0", "0", "a"]
[define]
sx = "dot(x(centre)) - R*wy(top)"
sy = "dot(y(centre)) + R*wx(top)"
[[force]]
at = "centre"
value = ["-mu*sx", "-mu*sy", "0"]
[[force]]
frame = "top"
in = "world"
value = ["-R*mu*sy", "R*mu*sx", "0"]
)toml";

}  // namespace

TEST_CASE("player: pages of ten models have at most 130 KB and load nothing from elsewhere") {
  const Pages folder;
  for (const std::string name :
       {"cart_pole", "double_pendulum", "heavy_top", "free_body", "quadrotor", "kepler_polar",
        "two_link_arm", "slider_crank", "rolling_disc", "triple_pendulum"}) {
    const std::string text = folder.page(shipped(name));
    INFO(name << " " << text.size());
    CHECK(text.size() <= 130'000);  // up to 60 KB are the derivation
    CHECK_FALSE(mentions(text, "http:"));
    CHECK_FALSE(mentions(text, "https:"));
    CHECK_FALSE(mentions(text, "import "));
    CHECK(count(text, "</script>") == 1);
    CHECK(text.find("Content-Security-Policy") < text.find("<title>"));
  }
}

TEST_CASE("player: the same bytes every time and from another folder") {
  const Pages folder;
  const std::string first = folder.page(shipped("cart_pole"), "--input 'u=-3*theta'");
  folder.write("elsewhere/cart_pole.toml", read_text(shipped("cart_pole")));
  CHECK(folder.page("elsewhere/cart_pole.toml", "--input 'u=-3*theta'") == first);
}

TEST_CASE("player: texts of a model are escaped") {
  const Pages folder;
  folder.write("odd.toml",
               "format = 1\n[model]\nname = \"odd\"\n"
               "title = \"</script><script>alert(1)</script> <!-- \\\"&\"\n"
               "[[coordinate]]\nname = \"q\"\nunit = \"rad\"\ndoc = \"</script>\"\n"
               "start = { value = 1, rate = 0 }\n"
               "[parameters]\nm = { value = 1, doc = \"</title><script>\" }\n"
               "[energy]\nT = \"1/2*m*dot(q)^2\"\nV = \"m*q^2\"\n"
               "[[expect]]\nconserved = [\"1/2*m*dot(q)^2 + m*q^2\"]\n");
  const std::string text = folder.page("odd.toml");
  CHECK(count(text, "</script>") == 1);
  CHECK(count(text, "<script>") == 1);
  CHECK(mentions(text, "<title>&lt;/script&gt;&lt;script&gt;"));
  if (!is_installed("html5lib", "/usr/bin/python3 -c 'import html5lib'")) return;
  folder.write("parse.py",
               "import html5lib\n"
               "html5lib.HTMLParser(strict=True).parse(open('page.html', encoding='utf-8'))\n");
  CHECK(failure_of(folder.run("/usr/bin/python3 parse.py")) == "");
}

TEST_CASE("player: the browser computes the state of simulate") {
  if (!is_installed("chromium", "chromium --version")) return;
  const Pages folder;
  const Outcome said = folder.run("/usr/bin/python3 " ELGEN_SOURCE_DIR
                                  "/tests/player/pages.py \"$(command -v elgen)\" " +
                                  shipped("cart_pole") + " " + shipped("four_bar"));
  INFO(said.output + said.errors);
  CHECK(said.status == 0);
  CHECK(count(said.output, "holds") == 2);
}

TEST_CASE("player: the line of the state shows the energy error of the steps") {
  if (!is_installed("chromium", "chromium --version")) return;
  const Pages folder;
  folder.write("orbit.toml", orbit);
  const auto state_after = [&](const std::string& seconds, const std::string& options) {
    folder.write("moved.html",
                 replaced(folder.page("orbit.toml", options), "</body>",
                          "<script>pause(); run_until(" + seconds + "); pause();</script></body>"));
    const Outcome shown = folder.run(
        "chromium --headless=new --no-sandbox --disable-gpu --disable-dev-shm-usage "
        "--force-prefers-reduced-motion --virtual-time-budget=5000 --dump-dom moved.html");
    const std::size_t begin = shown.output.find("<output id=\"state\"");
    REQUIRE(begin != std::string::npos);
    return shown.output.substr(begin, shown.output.find("</output>", begin) - begin);
  };
  for (const std::string method : {"rk4", "verlet"}) {
    const std::string options = "--method " + method + " --step 0.01";
    CHECK(mentions(state_after("5", options), " % of its scale: use a shorter step"));
    const std::string kept = state_after("0.5", options);
    CHECK(mentions(kept, ">t = 0.5, x = "));
    CHECK_FALSE(mentions(kept, "E - E0"));
  }
}

TEST_CASE("player: verlet and midpoint step by the emitted step") {
  const Pages folder;
  const std::string text = folder.page(shipped("simple_pendulum"), "--method verlet --step 0.01");
  CHECK(mentions(text, "function step("));
  CHECK(mentions(text, "\"step\":0.01"));
  CHECK(folder.run("elgen simulate --time 1 --method verlet -o a.html " + shipped("cart_pole"))
            .status == 2);
}

TEST_CASE("player: a page adapts its steps unless the options or the scene have a step") {
  const Pages folder;
  const std::string adapted = folder.page(shipped("cart_pole"));
  CHECK(mentions(adapted, "\"run\":{\"method\":\"dopri5\","));
  CHECK_FALSE(mentions(adapted, "\"step\":"));
  if (has_node()) {
    const std::string tolerances =
        R"js(by("tolerance").options.map((each) => each.textContent).join() + " " + tolerance)js";
    CHECK(folder.value(tolerances) == "1e-3,1e-6,1e-9,1e-12 1e-9");
    (void)folder.page(shipped("cart_pole"), "--tolerance 1e-5");
    CHECK(folder.value(tolerances) == "1e-3,1e-5,1e-6,1e-9,1e-12 0.00001");
  }
  const std::string scenes = models + "/scenes/";
  struct PageSteps {
    std::string input;
    std::string options;
    std::string step;
    bool is_emitted;
    bool is_dopri5;
  };
  for (const auto& [input, options, step, is_emitted, is_dopri5] :
       {PageSteps{shipped("cart_pole"), "--step 0.25", "0.25", false, true},
        PageSteps{shipped("cart_pole"), "--method dopri5 --step 0.25", "0.25", false, true},
        PageSteps{shipped("cart_pole"), "--method rk4", "0.002", false, false},
        PageSteps{scenes + "cart_pole_prediction.scene.toml", "", "0.002", false, false},
        PageSteps{scenes + "two_body_plane_orbit.scene.toml", "", "0.002", true, false},
        PageSteps{scenes + "two_body_plane_orbit.scene.toml", "--step 0.25", "0.25", false,
                  true}}) {
    INFO(input << " " << options);
    const std::string text = folder.page(input, options);
    CHECK(mentions(text, "\"step\":" + step));
    CHECK(mentions(text, "function step(") == is_emitted);
    CHECK(mentions(text, "\"method\":\"dopri5\"") == is_dopri5);
    if (has_node()) CHECK(folder.value(R"js(by("tolerances").hidden)js") == "true");
  }
}

TEST_CASE("player: the coefficients of a page are those of its methods") {
  if (!has_node()) return;
  const Pages folder;
  (void)folder.page(shipped("simple_pendulum"));
  CHECK(folder.value(R"js(
    [...methods.dopri5, dopri5_errors, methods.rk4[3]]
      .map((row) => row.reduce((sum, each) => sum + each, 0).toFixed(9)).join();)js") ==
        "0.200000000,0.300000000,0.800000000,0.888888889,1.000000000,1.000000000,0.000000000,"
        "1.000000000");
}

TEST_CASE("player: fixed steps have the same bits anywhere") {
  if (!has_node()) return;
  const Pages folder;
  folder.write("orbit.toml", orbit);
  const auto state = [&](const std::string& options) {
    (void)folder.page("orbit.toml", options + " --step 0.01");
    return folder.value("run_until(0.5); [...x.q, ...x.v].join()");
  };
  // The functions of this model are sums, products, quotients and roots, which round alike
  // anywhere.
  CHECK(state("--method rk4") ==
        "0.8692496532211642,0.004767715354402172,-0.5484780608200798,0.00849584776997526");
  CHECK(state("--method verlet") ==
        "0.8692524635219117,0.004767813962479627,-0.5484909006008792,0.008495687657761758");
}

TEST_CASE("player: the page of a tippe top agrees with simulate for 10 s") {
  if (!has_node()) return;
  const Pages folder;
  folder.write("top.toml", tippe_top);
  (void)folder.page("top.toml");
  const std::vector<double> shown = Pages::numbers_of(folder.value(
      "run_until(10); [...x.q, ...x.v, rows[rows.length - 1].off - rows[0].off].join()"));
  // Each of 17 000 steps may change the spin by 1e-9 of 150 rad/s, so E by 6e-11 J.
  CHECK(std::abs(shown.back()) < 1e-6);
  CHECK(difference({shown.begin(), shown.end() - 1}, folder.end_of_run("10", "top.toml")) <
        page_tolerance);
  // A slider changes the motion, so the steps begin again.
  CHECK(
      folder.value("run_until(1); start.v[4] = 300; begin(); run_until(1); x.v.every(isFinite)") ==
      "true");
}

TEST_CASE("player: dry friction holds rates on a page") {
  if (!has_node()) return;
  const Pages folder;
  folder.write("block.toml", one_coordinate("{ value = 0, rate = 1 }",
                                            "[[force]]\non = \"x\"\nvalue = \"-1/2*sign(dot(x))\"\n"
                                            "[[input]]\nname = \"u\"\non = \"x\"\n"));
  (void)folder.page("block.toml");
  // At rest after 2 s at 1 m. u = 0.4 is less than the friction, u = 1.5 leaves 1 m/s^2.
  const std::vector<double> rest = Pages::numbers_of(
      folder.value("run_until(3); held[0] = 0.4; run_until(4); [x.q[0], x.v[0]].join()"));
  CHECK(rest[0] == Approx(1).margin(1e-8));
  CHECK(rest[1] == 0);
  CHECK(std::stod(folder.value("run_until(3); held[0] = 1.5; run_until(4); x.v[0]")) ==
        Approx(1).margin(1e-8));
  const std::string law = "--input 'u=1.5*sin(t)' ";
  (void)folder.page("block.toml", law);
  CHECK(difference(
            Pages::numbers_of(folder.value("run_until(9); [x.q[0], x.v[0], at(x).u[0]].join()")),
            folder.end_of_run("9", law + "block.toml")) < page_tolerance);
  (void)folder.page("block.toml", "--method rk4 --step 0.01");
  CHECK(std::stod(folder.value("run_until(3); x.v[0]")) != 0);
}

TEST_CASE("player: a page stops with the words of simulate") {
  if (!has_node()) return;
  const Pages folder;
  const auto check_words = [&](const std::string& model, const std::string& words) {
    folder.write("one.toml", model);
    (void)folder.page("one.toml");
    const std::string stop = folder.value("run_until(2); by(\"obstacle\").textContent");
    CHECK(mentions(stop, "Stopped at t = "));
    CHECK(mentions(stop, " s: " + words + "."));
    CHECK(mentions(folder.run("elgen simulate -q --time 2 one.toml").errors,
                   "error[E624]: " + words + " after t = "));
    CHECK(folder.value("run_until(2); by(\"through\").hidden") == "true");
  };
  check_words(one_coordinate("{ value = 1, rate = 0 }", "V = \"-1/x^2\"\n"),
              "the tolerance requires a step that is too short");
  check_words(one_coordinate("{ value = 1, rate = 0 }",
                             "[[force]]\non = \"x\"\nvalue = \"-3*sign(x + dot(x))\"\n"),
              "the motion slides along the kink of `sign(x + dot(x))`");
}

TEST_CASE("player: a frame takes at most 2000 evaluations, and the state follows the motion") {
  if (!has_node()) return;
  const Pages folder;
  folder.write("stiff.toml", one_coordinate("{ value = 1, rate = 0 }", "V = \"1/2*1e10*x^2\"\n"));
  (void)folder.page("stiff.toml");
  const std::string state =
      R"js(by("state").getAttribute("aria-live") + by("state").textContent)js";
  const std::string before = folder.value(state);
  CHECK(before.starts_with("politet = 0, x = 1, "));
  CHECK(mentions(before, ", E = 5000000000"));
  CHECK(std::stoi(folder.value("play(); frames(30, 16)")) <= 2000);
  const std::string during = folder.value("play(); frames(30, 16); " + state);
  CHECK(during.starts_with("offt = 0.0"));
  CHECK(mentions(during, " (slower than the clock)"));
  const std::string after = folder.value("play(); frames(30, 16); pause(); " + state);
  CHECK(after.starts_with("politet = 0.0"));
  CHECK_FALSE(mentions(after, "slower"));
  CHECK(std::stod(folder.value("play(); frames(30, 16); x.t")) < 0.1);
  folder.write("soft.toml", one_coordinate("{ value = 1, rate = 0 }", "V = \"1/2*x^2\"\n"));
  (void)folder.page("soft.toml");
  CHECK_FALSE(mentions(folder.value("play(); frames(30, 16); " + state), "slower"));
  CHECK(std::stod(folder.value("play(); frames(100, 16); x.t")) == Approx(1.6).margin(0.05));
}

}  // namespace elgen::test
