// Applies the rules of src/layers.txt to this project and to small trees that break them.
#include "layering/layering.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <set>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

using Sentences = std::vector<std::string>;

const SourceTree& project() {
  static const SourceTree tree = read_tree(ELGEN_SOURCE_DIR);
  return tree;
}

/// Two folders. GiNaC is allowed in one file of `second`. No rule is broken.
SourceTree small_tree() {
  return {
      {"src/layers.txt", "# order\nfirst  : apple\nsecond : pear   ginac algebra.cpp\n"},
      {"include/elgen/apple.hpp", "#include <string>\n"},
      {"include/elgen/pear.hpp", "#include \"elgen/apple.hpp\"\n"},
      {"src/first/apple.cpp", "#include \"elgen/apple.hpp\"\n#include \"first/core.hpp\"\n"},
      {"src/first/core.hpp", "#pragma once\n"},
      {"src/second/algebra.cpp", "#include <ginac/ginac.h>\n#include \"elgen/pear.hpp\"\n"},
      {"tests/first/apple_test.cpp", ""},
      {"tests/second/algebra_test.cpp", ""},
  };
}

}  // namespace

TEST_CASE("layers.txt is read line by line") {
  const std::vector<Layer> layers = parse_layers(
      "# words: not a layer\nbase : span text\nderive : motion  ginac *\n"
      "lower : p  publishes b.hpp  ginac a.cpp\ncli :\n");
  REQUIRE(layers.size() == 4);
  CHECK(layers[0].folder == "base");
  CHECK(layers[0].nouns == Sentences{"span", "text"});
  CHECK_FALSE(layers[0].all_ginac);
  CHECK(layers[1].nouns == Sentences{"motion"});
  CHECK(layers[1].all_ginac);
  CHECK(layers[2].nouns == Sentences{"p"});
  CHECK(layers[2].published == std::set<std::string>{"b.hpp"});
  CHECK(layers[2].ginac_files == std::set<std::string>{"a.cpp"});
  CHECK(layers[3].nouns.empty());
}

TEST_CASE("a tree that follows the rules has no findings") {
  const SourceTree tree = small_tree();
  CHECK(later_includes(tree).empty());
  CHECK(include_cycles(tree).empty());
  CHECK(misplaced_ginac(tree).empty());
  CHECK(long_files(tree, 3).empty());
}

TEST_CASE("an include of a later folder is found, direct and through a header") {
  SourceTree direct = small_tree();
  direct["src/first/apple.cpp"] += "#include \"elgen/pear.hpp\"\n";
  CHECK(later_includes(direct) ==
        Sentences{"src/first/apple.cpp: reaches the later include/elgen/pear.hpp"});

  SourceTree through = small_tree();
  through["src/first/core.hpp"] = "#include \"../second/tools.hpp\"\n";
  through["src/second/tools.hpp"] = "";
  CHECK(later_includes(through) ==
        Sentences{"src/first/apple.cpp: reaches the later src/second/tools.hpp",
                  "src/first/core.hpp: reaches the later src/second/tools.hpp"});
}

TEST_CASE("a noun or a folder missing from layers.txt is found") {
  SourceTree tree = small_tree();
  tree["include/elgen/plum.hpp"] = "";
  tree["src/third/plum.hpp"] = "";
  CHECK(later_includes(tree) ==
        Sentences{"include/elgen/plum.hpp: its folder or noun is not in src/layers.txt",
                  "src/third/plum.hpp: its folder or noun is not in src/layers.txt"});
}

TEST_CASE("an include cycle is found at each of its files") {
  SourceTree tree = small_tree();
  tree["src/first/core.hpp"] = "#include \"seed.hpp\"\n";
  tree["src/first/seed.hpp"] = "  #  include \"core.hpp\"\n";
  CHECK(include_cycles(tree) ==
        Sentences{"src/first/core.hpp: is included again by src/first/seed.hpp",
                  "src/first/seed.hpp: is included again by src/first/core.hpp"});
}

TEST_CASE("GiNaC outside its files is found, direct and through a header") {
  SourceTree tree = small_tree();
  tree["src/second/print.cpp"] = "#include <ginac/ex.h>\n";
  tree["include/elgen/pear.hpp"] += "#include <ginac/ginac.h>\n";
  tree["src/second/show.cpp"] = "#include \"elgen/pear.hpp\"\n";
  CHECK(misplaced_ginac(tree) ==
        Sentences{"include/elgen/pear.hpp: reaches GiNaC by include/elgen/pear.hpp",
                  "src/second/print.cpp: reaches GiNaC by src/second/print.cpp",
                  "src/second/show.cpp: reaches GiNaC by include/elgen/pear.hpp"});
}

TEST_CASE("a type name defined twice is found, even if both types are local") {
  SourceTree tree = small_tree();
  tree["src/first/a.hpp"] = "namespace elgen {\nstruct Pip {\n};\n}  // namespace elgen\n";
  tree["src/second/b.cpp"] = "namespace {\nenum class Pip : char { one };\n}  // namespace\n";
  CHECK(types_of_two_meanings(tree) ==
        Sentences{"src/second/b.cpp: Pip is also in src/first/a.hpp"});
}

TEST_CASE("an include that is not a path from src is found") {
  SourceTree tree = small_tree();
  tree["src/first/seed.cpp"] = "#include \"core.hpp\"\n#include \"first/core.hpp\"\n";
  CHECK(includes_beside(tree) ==
        Sentences{"src/first/seed.cpp: includes \"core.hpp\", which is not a path from src"});
}

TEST_CASE("a namespace of its own is found, except in urdf, oracle and cli") {
  SourceTree tree = small_tree();
  tree["src/first/core.hpp"] = "namespace elgen::first {\nnamespace {\n";
  tree["src/urdf/robot.hpp"] = "namespace elgen::urdf {\n";
  CHECK(unusual_namespaces(tree) == Sentences{"src/first/core.hpp: opens namespace elgen::first"});
}

TEST_CASE("rooms are ordered, and nouns come before the rooms of their folder") {
  SourceTree tree = small_tree();
  tree["src/layers.txt"] = "first/names :\nfirst/rules :\nfirst : apple\nsecond : pear ginac *\n";
  tree["src/first/names/core.hpp"] = "#include \"elgen/apple.hpp\"\n";
  tree["src/first/rules/rule.hpp"] = "#include \"first/names/core.hpp\"\n";
  CHECK(later_includes(tree).empty());
  tree["src/first/names/core.hpp"] += "#include \"first/core.hpp\"\n";
  tree["src/first/cellar/jar.hpp"] = "";
  CHECK(later_includes(tree) ==
        Sentences{"src/first/cellar/jar.hpp: its folder or noun is not in src/layers.txt",
                  "src/first/names/core.hpp: reaches the later src/first/core.hpp",
                  "src/first/rules/rule.hpp: reaches the later src/first/core.hpp"});
}

TEST_CASE("fmt::join without its header is found") {
  SourceTree tree = small_tree();
  const std::string use = "std::string text() { return f(fmt::joi" + std::string("n(x, y)); }\n");
  tree["src/first/core.hpp"] += "#include <fmt/ranges.h>\n" + use;
  CHECK(joins_without_ranges(tree).empty());
  tree["src/first/apple.cpp"] += "#include <fmt/format.h>\n" + use;
  CHECK(joins_without_ranges(tree) ==
        Sentences{"src/first/apple.cpp: writes fmt::join without <fmt/ranges.h>"});
}

TEST_CASE("a file longer than the limit is found, a file of exactly the limit is not") {
  SourceTree tree = small_tree();
  tree["tests/first/apple_test.cpp"] = "\n\n\n\n";
  CHECK(long_files(tree, 4).empty());
  CHECK(long_files(tree, 3) == Sentences{"tests/first/apple_test.cpp: has 4 lines"});
}

TEST_CASE("this project follows the order of its folders") {
  CHECK(later_includes(project()) == Sentences{});
}

TEST_CASE("this project has no include cycle") { CHECK(include_cycles(project()) == Sentences{}); }

TEST_CASE("this project uses GiNaC only in its permitted files") {
  CHECK(misplaced_ginac(project()) == Sentences{});
}

TEST_CASE("this project gives every type name one meaning") {
  CHECK(types_of_two_meanings(project()) == Sentences{});
}

TEST_CASE("this project writes includes as paths from src") {
  CHECK(includes_beside(project()) == Sentences{});
}

TEST_CASE("this project has one namespace, and three more for urdf, oracle and cli") {
  CHECK(unusual_namespaces(project()) == Sentences{});
}

TEST_CASE("this project includes <fmt/ranges.h> with fmt::join") {
  CHECK(joins_without_ranges(project()) == Sentences{});
}

TEST_CASE("this project has no file over 400 lines") {
  CHECK(long_files(project(), 400) == Sentences{});
}

TEST_CASE("REUSE.toml states the licence of all sources, and no source repeats it") {
  const std::string licences = read_text(std::filesystem::path(ELGEN_SOURCE_DIR) / "REUSE.toml");
  const std::string all_files =
      "version = 1\n\n[[annotations]]\npath = \"**\"\n"
      "SPDX-FileCopyrightText = \"2026 the elgen authors\"\n"
      "SPDX-License-Identifier = \"GPL-3.0-or-later\"\n";
  CHECK(starts_with(licences, all_files));
  // Later annotations take precedence, so none may name sources.
  const std::string others = licences.substr(std::min(licences.size(), all_files.size()));
  CHECK(count(others, "\"**") + count(others, "\"src/") + count(others, "\"include/") == 0);
  CHECK(count(others, "\"tests/") == 2);  // the golden files, and a robot that a model is based on
  for (const auto& [path, text] : project()) {
    if (starts_with(path, "tests/emit/golden/")) continue;
    INFO(path);
    CHECK_FALSE(starts_with(text, "// SPDX"));
  }
}

TEST_CASE("files that leave this project state their licence") {
  static const std::set<std::string> without_line{".md", ".json", ""};
  const std::filesystem::path root = ELGEN_SOURCE_DIR;
  for (const std::string folder :
       {"templates", "examples", "recipes", "generated", "tests/emit/golden"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      if (!entry.is_regular_file()) continue;
      if (without_line.count(entry.path().extension()) > 0) continue;
      INFO(entry.path().string());
      CHECK(mentions(read_text(entry.path()), " SPDX-License-Identifier: 0BSD"));
    }
  }
}

}  // namespace elgen::test
