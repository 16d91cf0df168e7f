// The labels, the drawing and the menus of animated pages.
#include <catch2/catch.hpp>
#include <string>

#include "cli/page_testing.hpp"

namespace elgen::test {
namespace {

/// A bar of two points that falls freely from the origin, in the plane of x and the axis `up`, and
/// a post at rest. The bar turns about the axis `turn` of the world.
std::string falling_bar(const std::string& up, const std::string& turn,
                        const std::string& gravity) {
  std::string text = R"toml(format = 1
[model]
name = "bar"
[[coordinate]]
name = "x"
unit = "m"
[[coordinate]]
name = "UP"
unit = "m"
[[coordinate]]
name = "phi"
unit = "rad"
[[frame]]
name = "hull"
parent = "world"
translate = PLACE
rotate = [["TURN", "phi"]]
[[point]]
name = "left"
frame = "hull"
at = ["-0.2", "0", "0"]
mass = "1"
[[point]]
name = "right"
frame = "hull"
at = ["0.2", "OFFSET", "0"]
mass = "1"
[[point]]
name = "post"
at = ["1", "0", "0"]
[gravity]
vector = GRAVITY
)toml";
  text = replaced(text, "UP", up);
  text = replaced(text, "PLACE", up == "y" ? R"(["x", "y", "0"])" : R"(["x", "0", "z"])");
  text = replaced(text, "TURN", turn);
  text = replaced(text, "OFFSET", turn == "x" ? "0.2" : "0");
  return replaced(text, "GRAVITY", gravity);
}

}  // namespace

TEST_CASE("player: labels are symbols, links and tooltips keep the names") {
  const Pages folder;
  const std::string text = folder.page(shipped("furuta_pendulum"));
  CHECK(mentions(text, " title=\"theta1\"><span>θ₁</span>"));
  CHECK(mentions(text, " title=\"dot(theta1)\"><span>θ\u0307₁</span>"));
  CHECK(mentions(text, "data-unit=\"kg m²\""));
  CHECK(mentions(text, R"({"name":"theta1","symbol":"\u03b8\u2081","unit":"rad",)"));
  CHECK(mentions(text,
                 R"json({"name":"dot(theta1)","symbol":"\u03b8\u0307\u2081","unit":"rad/s",)json"));
  if (!has_node()) return;
  CHECK(folder.value(R"js(by("phase").options.map((each) => each.textContent).join())js") ==
        "θ₁,θ₂");
  CHECK(folder.value("[short(2.5e-6), short(1e-4), short(1234567), short(-0)].join()") ==
        "2.5e-6,0.0001,1234570,0");
}

TEST_CASE("player: a plane motion has its plane, gravity points down, fixed places are known") {
  const Pages folder;
  const auto page = [&](const std::string& up, const std::string& normal,
                        const std::string& gravity) {
    folder.write("bar.toml", falling_bar(up, normal, gravity));
    return folder.page("bar.toml");
  };
  const std::string upright = page("y", "z", R"(["0", "-9.81", "0"])");
  CHECK(mentions(upright, R"("is_planar":true,"axes":[[0,1],[1,1],[2,1]])"));
  CHECK(count(upright, R"("is_fixed":true)") == 1);
  CHECK(mentions(page("z", "y", R"(["0", "0", "-9.81"])"),
                 R"("is_planar":true,"axes":[[0,1],[2,1],[1,1]])"));
  CHECK(mentions(page("y", "z", R"(["0", "9.81", "0"])"),
                 R"("is_planar":true,"axes":[[0,1],[1,-1],[2,-1]])"));
  CHECK(mentions(page("y", "z", R"(["9.81", "0", "0"])"),
                 R"("is_planar":true,"axes":[[1,1],[0,-1],[2,-1]])"));
  CHECK(mentions(page("y", "z", R"(["0", "0", "-9.81"])"),
                 R"("is_planar":true,"axes":[[0,1],[1,1],[2,1]])"));
  CHECK(mentions(page("y", "x", R"(["0", "-9.81", "0"])"),
                 R"("is_planar":false,"axes":[[2,1],[1,1],[0,1]])"));
}

TEST_CASE("player: the menu has states of rest in symbols, stable ones first") {
  const Pages folder;
  const std::string text = folder.page(shipped("double_pendulum"));
  const std::string hanging = R"(\u03b8\u2081 = 0, \u03b8\u2082 = 0 (stable))";
  CHECK(mentions(text, R"("starts":[{"name":")" + hanging + R"(","q":[0)"));
  CHECK(mentions(text, R"({"name":"\u03b8\u2081 = 0, \u03b8\u2082 = \u03c0","q":[0)"));
  if (!has_node()) return;
  CHECK(folder.value(R"js(
    model.starts = [...model.starts, ...model.starts, ...model.starts];
    fill_starts(12);
    start_at("1");
    const lengths = [by("start").options.length];
    start_at("more");
    lengths.push(by("start").options.length, start.q[0], start.q[1].toFixed(2));
    lengths.join();)js") == "14,19,0,3.14");
}

TEST_CASE("player: a derivation has at most 60 kB and names what it omits") {
  const Pages folder;
  const std::string text = folder.page(shipped("chain"));
  const std::size_t begin = text.find("<details><summary>Derivation</summary>");
  CHECK(text.find("<script>", begin) - begin <= 61'000);
  CHECK(count(text, "<h2>Equations of motion</h2>") == 1);
  CHECK(mentions(text, "<h2>Energies</h2>"));
  CHECK(mentions(text, "<p>Too long for this page: Equation of q₂, Equation of q₃, "));
  CHECK(mentions(text, ". <code>elgen show --what steps MODEL</code> prints them.</p>"));
  CHECK_FALSE(mentions(folder.page(shipped("cart_pole")), "Too long for this page"));
}

TEST_CASE("player: the view follows a system that falls 34 m, and the phase plane shows the fall") {
  if (!has_node()) return;
  const Pages folder;
  const std::string post = "[[point]]\nname = \"post\"\nat = [\"1\", \"0\", \"0\"]\n";
  folder.write("bar.toml", replaced(falling_bar("y", "z", R"(["0", "-9.81", "0"])"), post, ""));
  (void)folder.page("bar.toml");
  CHECK(folder.value(R"js(
    run_until(2.63);
    draw();
    const radius = window_radius();
    const is_inside = radius - seen.size > distance(seen.middle, seen.centre);
    const phase = by("phase");
    const height = Math.round(seen.middle[1]);
    [1 > radius, is_inside, height, phase.value, phase.options[0].disabled].join();)js") ==
        "true,true,-34,1,true");
}

TEST_CASE("player: a curve does not magnify rounding errors") {
  if (!has_node()) return;
  const Pages folder;
  (void)folder.page(shipped("cart_pole"));
  CHECK(folder.value(R"js(
    run_until(3);
    curves().map(([, of, scale]) => {
      const all = rows.map(of);
      const [least, most] = [Math.min(...all), Math.max(...all)];
      const [low, high] = shown_interval([least, most], scale);
      return ((most - least) / (high - low)).toFixed(3);
    }).join();)js") == "1.000,1.000,0.000,0.000,0.000");
}

TEST_CASE("player: pages fit a screen of 390 pixels") {
  if (!is_installed("chromium", "chromium --version")) return;
  const Pages folder;
  const std::string outer =
      "<!DOCTYPE html><html><body><iframe src=\"inner.html\" style=\"width: 390px\"></iframe>"
      "<output id=\"state\"></output></body></html>";
  for (const std::string name : {"double_pendulum", "five_bar", "panda7"}) {
    folder.write("inner.html", folder.page(shipped(name)));
    const std::string shown = state_in_browser(folder, outer, R"js(
      window.addEventListener("load", () => {
        const inner = document.querySelector("iframe").contentDocument.documentElement;
        document.getElementById("state").textContent = 390 >= inner.scrollWidth;
      });)js");
    INFO(name << " " << shown);
    CHECK(mentions(shown, ">true"));
  }
}

}  // namespace elgen::test
