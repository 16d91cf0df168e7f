// Named parts: each name follows from the content of the part. In place of equations that are too
// long to read, pages describe the motion of the frames.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "choose/chosen.hpp"
#include "elgen/page.hpp"
#include "print/small_page.hpp"
#include "support/systems.hpp"

namespace elgen::test {

namespace {

/// Two links that rotate about crossed axes; no two quantities share a parameter.
const ChosenForms& two_links() {
  static const ChosenForms all = chosen(model_text("two_links", R"toml(
[[coordinate]]
name = "q1"
armature = "J"
[[coordinate]]
name = "q2"
[parameters]
J = "1/9"
l = "7/10"
m1 = 2
m2 = "3/2"
c1 = "1/3"
c2 = "1/4"
d2 = "1/5"
A = "3/10"
B = "2/5"
C = "1/2"
D = "1/20"
g = 9.81
[gravity]
vector = ["0", "0", "-g"]
[[frame]]
name = "upper"
parent = "world"
rotate = [["z", "q1"], ["x", "-pi/2"]]
[[frame]]
name = "lower"
parent = "upper"
translate = ["l", "0", "0"]
rotate = [["z", "q2"]]
[[body]]
name = "arm"
frame = "upper"
mass = "m1"
com = ["c1", "0", "0"]
[[body]]
name = "hand"
frame = "lower"
mass = "m2"
com = ["c2", "d2", "0"]
inertia = ["A", "B", "C", "D", "0", "0"]
inertia_about = "origin"
)toml"));
  return all;
}

/// The text page of the recursive forms of two_links(), which are composed of named parts.
std::string recursive_page() {
  const ChosenForms& c = two_links();
  return text_page(c.checked.model, c.checked.scene, c.recursive);
}

/// Name of a part -> names of the leaves on which the part depends; "dot" stands for the rates.
std::map<std::string, std::set<std::string>> leaves_of_parts(const std::string& page) {
  static const std::regex word("[A-Za-z_]\\w*");
  std::map<std::string, std::set<std::string>> parts;
  std::istringstream lines(page.substr(page.find("\nnamed parts\n") + 13));
  for (std::string line; std::getline(lines, line) && line.starts_with("  ");) {
    const std::size_t equal = line.find(" = ");
    const std::string value = line.substr(equal + 3);
    std::set<std::string> leaves;
    for (std::sregex_iterator it(value.begin(), value.end(), word), end; it != end; ++it) {
      const auto known = parts.find(it->str());
      if (known == parts.end()) {
        leaves.insert(it->str());
      } else {
        leaves.insert(known->second.begin(), known->second.end());
      }
    }
    parts[line.substr(2, equal - 2)] = leaves;
  }
  return parts;
}

bool has_any(const std::set<std::string>& leaves, const std::vector<std::string>& names) {
  return std::ranges::any_of(names, [&](const auto& name) { return leaves.count(name) > 0; });
}

const PageSection& section(const Page& page, const std::string& doc) {
  return *std::ranges::find_if(page.sections,
                               [&](const PageSection& each) { return mentions(each.doc, doc); });
}

Page page_of_parts() {
  const ChosenForms& c = two_links();
  return model_page(c.checked.model, c.checked.scene, c.recursive);
}

}  // namespace

TEST_CASE("a part is named after its frame and its kind, as in code") {
  const auto parts = leaves_of_parts(recursive_page());
  std::size_t named_texts = 0;
  std::size_t counted = 0;
  for (const auto& [name, leaves] : parts) {
    INFO(name);
    CHECK_FALSE(name.starts_with("~"));
    if (std::regex_match(name, std::regex("part(_[0-9]*)?"))) ++counted;
    if (!mentions(name, "_lower_")) continue;
    ++named_texts;
    // A motion depends on no inertia. Parts with other names contain accelerations due to forces.
    const bool moves = std::regex_match(name, std::regex("(minus_)?motion_lower_[xyz]"));
    if (moves) CHECK_FALSE(has_any(leaves, {"m1", "m2", "c1", "c2", "d2", "A", "B", "C", "D"}));
  }
  CHECK(named_texts > 0);
  CHECK(10 * counted <= parts.size());
}

TEST_CASE("a part that several functions need is printed once, before them") {
  const std::string page = recursive_page();
  CHECK(page.find("\nnamed parts\n") < page.find("\nmass_matrix\n"));
  const std::string sine = "  sin_q2 = sin(q2)\n";
  const std::size_t first = page.find(sine);
  REQUIRE(first != std::string::npos);
  CHECK(page.find(sine, first + 1) == std::string::npos);
}

TEST_CASE("an output without a readable form is printed by its definition, after the frames") {
  const Page page = page_of_parts();
  CHECK(text_of(page.sections.front().title) == "Named parts");
  for (const PageSection& each : page.sections) {
    if (each.kind != OutputKind::mass_matrix) continue;
    CHECK(each.equations.empty());
    CHECK(latex_of(each.definition) ==
          "M = \\frac{\\partial^{2} L}{\\partial \\dot{\\mathbf{q}}^{2}}");
  }
  const std::vector<std::string> frames = latex_of(section(page, "pose H").table.cells);
  REQUIRE(frames.size() == 8);
  CHECK(frames[3].starts_with("\\mathrm{Rot}_{z}(q_{1}) \\mathrm{Rot}_{x}("));
  CHECK(frames[6] == "1");
  CHECK(frames[7] == "\\mathrm{Trans}(l, 0, 0) \\mathrm{Rot}_{z}(q_{2})");
  CHECK(latex_of(section(page, "Body b").table.cells) ==
        std::vector<std::string>{"1", "m_{1}", "(c_{1}, 0, 0)", "0", "2", "m_{2}",
                                 "(c_{2}, d_{2}, 0)", "(A, B, C)", "", "", "",
                                 "(D, 0, 0) + m_{b} [c_{b}]_{\\times}^{2}"});
  CHECK(latex_of(section(page, "Motion of").equations.back().entries.front()) == "-(0, 0, -g)");
  Formulas last;
  for (const PageEquation& each : section(page, "velocity k").equations) {
    last.push_back(each.left);
  }
  CHECK(latex_of(last.back()) == "V_{0}");
  CHECK(std::ranges::count(latex_of(last), "A_{1, 1}") == 1);
}

TEST_CASE("closed forms have no named parts") {
  const ChosenForms& c = two_links();
  const Page page = model_page(c.checked.model, c.checked.scene, c.choice.program);
  CHECK(text_of(page.sections.front().title) == "Mass matrix");
}

TEST_CASE("a terminal page and its overview show definitions") {
  const Page page = page_of_parts();
  CHECK(mentions(screen_page(page, {80, Alphabet::unicode}), "× "));
  CHECK(mentions(overview(page, {80, Alphabet::ascii}), "  M = "));
}

}  // namespace elgen::test
