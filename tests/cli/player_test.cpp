// simulate -o NAME.html: an animated page in one file.
#include <catch2/catch.hpp>
#include <string>

#include "cli/cli_testing.hpp"
#include "support/installed.hpp"

namespace elgen::test {
namespace {

class Pages : public Workspace {
 public:
  [[nodiscard]] std::string page(const std::string& model, const std::string& options = "") const {
    prepare("elgen simulate -q --time 20 -o page.html --force " + options + " " + model);
    return read("page.html");
  }
};

std::string shipped(const std::string& name) { return models + "/" + name + ".toml"; }

}  // namespace

TEST_CASE("player: pages of ten models have at most 100 KB and load nothing from elsewhere") {
  const Pages folder;
  for (const std::string name :
       {"cart_pole", "double_pendulum", "heavy_top", "free_body", "quadrotor", "kepler_polar",
        "two_link_arm", "slider_crank", "rolling_disc", "triple_pendulum"}) {
    const std::string text = folder.page(shipped(name));
    INFO(name << " " << text.size());
    CHECK(text.size() <= 100'000);
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
  folder.write("orbit.toml", R"toml(format = 1
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
)toml");
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

}  // namespace elgen::test
