// Ratchets of this project and of small trees.
#include "layering/ratchets.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

/// Rows for a tree of two lines: `name` has `number`, all other rules 0.
std::string rows_with(const std::string& name, int number) {
  std::string rows = "# comment\nsum 2\n";
  for (const std::string rule :
       {"reach-ins", "defaults", "languages", "outputs", "leaves", "extents", "needs", "goals",
        "randoms", "latex", "thread-locals", "bare-constants", "large-classes", "function-objects",
        "noun-clauses"}) {
    rows += rule + (rule == name ? " " + std::to_string(number) : " 0") + "\n";
  }
  return rows;
}

/// The places reported for the figure `name` of a file src/first/a.cpp if its row is 0.
std::vector<std::string> places_of(const std::string& name, const std::string& text,
                                   SourceTree tree = {}) {
  tree["src/layers.txt"] = "first :\nsecond : publishes open.hpp\nthird : publishes *\n";
  tree["src/first/a.cpp"] = text;
  std::vector<std::string> places;
  bool is_inside = false;
  for (const std::string& line : broken_ratchets(tree, rows_with(name, 0))) {
    if (!starts_with(line, "src/first/a.cpp:")) {
      is_inside = starts_with(line, name + ": ");
    } else if (is_inside) {
      places.push_back(line);
    }
  }
  return places;
}

}  // namespace

TEST_CASE("an include of another folder's header counts unless that folder publishes it") {
  const SourceTree headers{{"src/first/deep/a.hpp", ""},
                           {"src/second/open.hpp", ""},
                           {"src/second/own.hpp", ""},
                           {"src/third/any.hpp", ""}};
  const std::string text =
      "#include \"first/deep/a.hpp\"\n#include \"second/open.hpp\"\n"
      "#include \"second/own.hpp\"\n#include \"third/any.hpp\"\n";
  CHECK(places_of("reach-ins", text, headers) ==
        std::vector<std::string>{"src/first/a.cpp: includes src/second/own.hpp"});
}

TEST_CASE(
    "a default counts in switches over an enumeration of a .def, under its name or an alias") {
  const SourceTree enums{
      {"src/second/pip.hpp", "enum class Pip : char {\n#include \"pip.def\"\n};\n"},
      {"src/second/core.hpp", "enum class Core { one, two };\n#include \"core.def\"\n"}};
  const std::string text =
      "using K = Pip;\nint f(Pip p) {\n  switch (p) {\n    case K::one:\n      return 1;\n"
      "    default:\n      return 0;\n  }\n  switch (p) {\n    case Pip::one:\n      return 1;\n  "
      "}\n"
      "  switch (c) {\n    case Core::one:\n    default:\n      return 0;\n  }\n}\n";
  CHECK(places_of("defaults", text, enums) ==
        std::vector<std::string>{"src/first/a.cpp:3: switch (p) {"});
}

TEST_CASE("comparisons with enumerators of tables and their case labels count, mere uses do not") {
  CHECK(places_of("outputs",
                  "using K = OutputKind;\nask(OutputKind::bias);\ncase K::bias:\n"
                  "if (kind == elgen::OutputKind::bias || K::drift != kind) return;\n") ==
        std::vector<std::string>{
            "src/first/a.cpp:3: case K::bias:",
            "src/first/a.cpp:4: if (kind == elgen::OutputKind::bias || K::drift != kind) return;",
            "src/first/a.cpp:4: if (kind == elgen::OutputKind::bias || K::drift != kind) return;"});
  CHECK(places_of("extents", "case Extent::one:\n// case Extent::one:\n") ==
        std::vector<std::string>{"src/first/a.cpp:1: case Extent::one:"});
  CHECK(places_of("needs", "needs.has(Need::inputs);\nif (need == Need::inputs) return;\n") ==
        std::vector<std::string>{"src/first/a.cpp:2: if (need == Need::inputs) return;"});
  const SourceTree leaves{{"include/elgen/leaves.def",
                           "ELGEN_LEAF(time, t, system)\nELGEN_LEAVES(input, u, inputs)\n"}};
  CHECK(places_of("leaves", "case Opcode::input:\ncase Opcode::inputs:\ncase Opcode::sin:\n",
                  leaves) == std::vector<std::string>{"src/first/a.cpp:1: case Opcode::input:"});
}

TEST_CASE("comparisons with lists of goals and declarations of thread_local count") {
  CHECK(
      places_of("goals", "if (goals == std::vector{Goal::steps}) return;\nask({Goal::steps});\n") ==
      std::vector<std::string>{
          "src/first/a.cpp:1: if (goals == std::vector{Goal::steps}) return;"});
  CHECK(places_of("thread-locals", "  static thread_local int n;\nlist{\"thread_local\"};\n") ==
        std::vector<std::string>{"src/first/a.cpp:1: static thread_local int n;"});
}

TEST_CASE("the reason of a numeric constant is on its line, or above its group of constants") {
  CHECK(places_of("bare-constants",
                  "constexpr int a = 3;\n\n// As in the book.\nconstexpr double b = 1e-3;\n"
                  "constexpr double c = -2;\n\nconstexpr int d = 4;  ///< of a year\n") ==
        std::vector<std::string>{"src/first/a.cpp:1: constexpr int a = 3;"});
}

TEST_CASE("comparisons with a language, generators and LaTeX are counted by line") {
  CHECK(places_of("languages", "row(LanguageId::cpp);\nif (id != LanguageId::cpp) return;\n") ==
        std::vector<std::string>{"src/first/a.cpp:2: if (id != LanguageId::cpp) return;"});
  CHECK(places_of("randoms", "// Random points(3)\nvoid f(Random& r);\nRandom r(seed);\n") ==
        std::vector<std::string>{"src/first/a.cpp:3: Random r(seed);"});
  CHECK(places_of("latex", "// \\frac{1}{2}\nread(\"\\\\dot{q}\");\nread(\"q\\n\");\n") ==
        std::vector<std::string>{"src/first/a.cpp:2: read(\"\\\\dot{q}\");"});
}

TEST_CASE("noun clauses are counted at the start of a comment, and phrases anywhere in it") {
  CHECK(
      places_of("noun-clauses", "// Whatever it is.\n/// What is left.\nint n;  ///< Of one.\n") ==
      std::vector<std::string>{"src/first/a.cpp:2: /// What is left.",
                               "src/first/a.cpp:3: int n;  ///< Of one."});
  CHECK(places_of("noun-clauses",
                  "f(\"likewise\");\n// It stops; but forces act, likewise.\n"
                  "// A pole (but for one).\n// A pole, but forced.\n") ==
        std::vector<std::string>{"src/first/a.cpp:2: // It stops; but forces act, likewise.",
                                 "src/first/a.cpp:3: // A pole (but for one)."});
}

TEST_CASE("noun clauses of tests are counted") {
  const SourceTree tree{{"src/layers.txt", "first :\n"},
                        {"src/first/a.cpp", "int n;\nint m;\n"},
                        {"tests/first/b.cpp", "int n;\n// Those of a.\n"}};
  CHECK(broken_ratchets(tree, rows_with("noun-clauses", 1)).empty());
}

TEST_CASE("a class of 13 members or 21 methods is large, a struct of data is not") {
  const auto members = [](int count) {
    std::string lines;
    for (int i = 0; i < count; ++i) lines += "  int n" + std::to_string(i) + "_ = f(1);\n";
    return lines;
  };
  const auto methods = [](int count) {
    std::string lines = "  explicit A(int n);\n  A(const A&) = delete;\n";
    for (int i = 0; i < count; ++i) lines += "  [[nodiscard]] int f(int n) const;\n";
    return lines;
  };
  CHECK(places_of("large-classes", "class A {\n" + members(12) + methods(20) + "};\n").empty());
  CHECK(places_of("large-classes", "class A {\n" + members(13) + methods(2) + "};\n") ==
        std::vector<std::string>{"src/first/a.cpp:1: A: 13 members, 2 methods"});
  CHECK(places_of("large-classes", "class A : B {\n" + methods(21) + "};\n") ==
        std::vector<std::string>{"src/first/a.cpp:1: A: 0 members, 21 methods"});
  CHECK(places_of("large-classes", "struct A {\n" + members(30) + "};\nclass A;\n").empty());
}

TEST_CASE("a class of five data members with an operator() counts, methods and types do not") {
  const std::string members =
      "  int a_ = 1;\n  std::function<int(int)> b_;\n  double c_{};\n  const A& d_;  ///< own\n"
      "  using E = int;\n  int f(int x = 2) { return x; }\n  // int g_;\n";
  const std::string call = "  int operator()() const;\n";
  const std::string text = "class B {\n" + call + members + "};\nclass C {\n" + members +
                           "  int h_;\n};\nclass D {\n" + call + members + "  int h_;\n};\n";
  CHECK(places_of("function-objects", text) ==
        std::vector<std::string>{"src/first/a.cpp:21: 5 members"});
}

TEST_CASE("a figure must equal its row, and lines may differ by 1 in 400") {
  SourceTree tree{{"src/layers.txt", ""}, {"src/first/a.cpp", "\n"}, {"src/second/b.cpp", "\n"}};
  CHECK(broken_ratchets(tree, rows_with("", 0)).empty());
  CHECK(broken_ratchets(tree, rows_with("randoms", 2)) ==
        std::vector<std::string>{
            "randoms: 0, less than 2; lower its row in tests/layering/ratchets.txt"});
  CHECK(broken_ratchets(tree, rows_with("", 0) + "src/third 1\n") ==
        std::vector<std::string>{"src/third: a row of no rule"});
  const std::string rows = std::regex_replace(rows_with("", 0), std::regex("sum 2"), "sum 400");
  tree["src/third/c.cpp"] = std::string(399, '\n');
  CHECK(broken_ratchets(tree, rows).empty());
  tree["src/third/c.cpp"] += "\n";
  CHECK(broken_ratchets(tree, rows) ==
        std::vector<std::string>{"sum: 402, more than 400; take lines out, or raise the row and "
                                 "say why in the commit"});
}

TEST_CASE("places under a row's excluded paths do not count") {
  const SourceTree tree{{"src/layers.txt", ""},
                        {"src/first/a.cpp", "Random a;\n"},
                        {"src/second/b.cpp", "Random b;\n"}};
  const std::string rows = std::regex_replace(rows_with("", 0), std::regex("randoms 0"),
                                              "randoms 1 besides src/second/");
  CHECK(broken_ratchets(tree, rows).empty());
}

TEST_CASE("this project does not exceed its ratchets") {
  const SourceTree tree = read_tree(ELGEN_SOURCE_DIR);
  const std::filesystem::path rows =
      std::filesystem::path(ELGEN_SOURCE_DIR) / "tests/layering/ratchets.txt";
  CHECK(broken_ratchets(tree, read_text(rows)) == std::vector<std::string>{});
}

}  // namespace elgen::test
