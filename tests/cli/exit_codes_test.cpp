// The exit codes of every command: a command line for each code, or the reason why there is none.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <set>
#include <utility>

#include "cli/cli_testing.hpp"

namespace elgen::test {
namespace {

struct ExitRow {
  std::string command;
  int code;
  std::string line;          ///< the command line; empty: the command never ends with this code
  std::string why_not = {};  ///< the reason if `line` is empty
};

/// Commands in a folder with a pendulum `good` and a copy `other` with another parameter value.
/// Other models have an error, a wrong expectation, or a force that grows without bound.
const std::vector<ExitRow> exit_rows{
    {"generate", 0, "elgen generate good.toml"},
    {"generate", 1, "elgen generate --check -o none good.toml"},
    {"generate", 2, "elgen generate bad.toml"},
    {"generate", 3, "elgen generate --limit derived_nodes=3 good.toml"},
    {"generate", 4, "elgen generate -o /dev/null/out good.toml"},
    {"show", 0, "elgen show good.toml"},
    {"show", 1, "", "it judges nothing"},
    {"show", 2, "elgen show bad.toml"},
    {"show", 3, "elgen show --limit derived_nodes=3 good.toml"},
    {"show", 4, "elgen show good.toml > /dev/full"},
    {"verify", 0, "elgen verify --quick good.toml"},
    {"verify", 1, "elgen verify --quick wrong.toml"},
    {"verify", 2, "elgen verify bad.toml"},
    {"verify", 3, "elgen verify --limit derived_nodes=3 good.toml"},
    {"verify", 4, "CXX=/nowhere elgen verify --samples 2 good.toml"},
    {"diff", 0, "elgen diff good.toml good.toml"},
    {"diff", 1, "elgen diff good.toml other.toml"},
    {"diff", 2, "elgen diff good.toml bad.toml"},
    {"diff", 3, "elgen diff --limit derived_nodes=3 good.toml other.toml"},
    {"diff", 4, "elgen diff --against nothing good.toml"},
    {"evaluate", 0, "elgen evaluate good.toml"},
    {"evaluate", 1, "", "it judges nothing"},
    {"evaluate", 2, "elgen evaluate bad.toml"},
    {"evaluate", 3, "", "it derives nothing"},
    {"evaluate", 4, "elgen evaluate good.toml > /dev/full"},
    {"vectors", 0, "elgen vectors --samples 1 good.toml"},
    {"vectors", 1, "", "it judges nothing"},
    {"vectors", 2, "elgen vectors bad.toml"},
    {"vectors", 3, "elgen vectors --limit derived_nodes=3 good.toml"},
    {"vectors", 4, "elgen vectors --samples 1 good.toml > /dev/full"},
    {"simulate", 0, "elgen simulate --time 0.1 good.toml"},
    {"simulate", 1, "elgen simulate --time 10 falls.toml"},
    {"simulate", 2, "elgen simulate --time 0.1 bad.toml"},
    {"simulate", 3, "elgen simulate --time 0.1 --limit derived_nodes=3 good.toml"},
    {"simulate", 4, "elgen simulate --time 0.1 good.toml > /dev/full"},
    {"tradeoff", 0, "elgen tradeoff --trajectory 0.1 good.toml"},
    {"tradeoff", 1, "elgen tradeoff --trajectory 0.1 --max-error 1e-99 good.toml"},
    {"tradeoff", 2, "elgen tradeoff bad.toml"},
    {"tradeoff", 3, "elgen tradeoff --limit derived_nodes=3 good.toml"},
    {"tradeoff", 4, "CXX=/nowhere elgen tradeoff good.toml"},
    {"import", 0, "elgen import " + robot},
    {"import", 1, "", "it judges nothing"},
    {"import", 2, "elgen import bad.toml"},
    {"import", 3, "", "it derives nothing"},
    {"import", 4, "elgen import " + robot + " > /dev/full"},
    {"explain", 0, "elgen explain E201"},
    {"explain", 1, "", "it judges nothing"},
    {"explain", 2, "elgen explain E999"},
    {"explain", 3, "", "it derives nothing"},
    {"explain", 4, "elgen explain E201 > /dev/full"},
    {"schema", 0, "elgen schema model"},
    {"schema", 1, "", "it judges nothing"},
    {"schema", 2, "elgen schema modle"},
    {"schema", 3, "", "it derives nothing"},
    {"schema", 4, "elgen schema model > /dev/full"},
    {"completions", 0, "elgen completions bash"},
    {"completions", 1, "", "it judges nothing"},
    {"completions", 2, "elgen completions tcsh"},
    {"completions", 3, "", "it derives nothing"},
    {"completions", 4, "elgen completions bash > /dev/full"},
    {"man", 0, "elgen man"},
    {"man", 1, "", "it judges nothing"},
    {"man", 2, "elgen man page"},
    {"man", 3, "", "it derives nothing"},
    {"man", 4, "elgen man > /dev/full"},
};

class Models : public Workspace {
 public:
  Models() {
    const std::string good = model_file("simple_pendulum");
    write("good.toml", good);
    write("other.toml", replaced(good, "value = 9.81", "value = 9.8"));
    write("bad.toml", replaced(good, "mass = \"m\"", "mass = \"mq\""));
    write("wrong.toml",
          good.substr(0, good.find("[[expect]]")) + "[[expect]]\ngravity = [\"0\"]\n");
    write("falls.toml",
          "format = 1\n[model]\nname = \"falls\"\n[[coordinate]]\nname = \"q\"\n"
          "start = { value = 1, rate = 0 }\n"
          "[energy]\nT = \"1/2*dot(q)^2\"\nV = \"-q^4\"\n");
  }
};

}  // namespace

TEST_CASE("every command has a row for each exit code from 0 to 4") {
  std::set<std::pair<std::string, int>> said;
  for (const ExitRow& row : exit_rows) CHECK(said.emplace(row.command, row.code).second);
  for (const std::string name : {
#define ELGEN_COMMAND(name) #name,
#include "cli/commands.def"
#undef ELGEN_COMMAND
       }) {
    for (int code = 0; code <= 4; ++code) {
      INFO(name << " " << code);
      CHECK(said.count({name, code}) == 1);
    }
  }
}

TEST_CASE("every command line ends with its exit code") {
  const Models workspace;
  for (const ExitRow& row : exit_rows) {
    if (row.line.empty()) continue;
    const Outcome outcome = workspace.run(row.line);
    INFO(row.line << "\n" << outcome.errors);
    CHECK(outcome.status == row.code);
  }
}

/// Chains of definitions, each composed of 64th powers of the definition before. A chain has
/// constants, bounded functions or unbounded functions.
TEST_CASE("absurd powers end with a limit or are emitted, without internal errors") {
  const Workspace workspace;
  const auto status = [&](const std::string& leaf, const std::string& step, int steps) {
    std::string text =
        "format = 1\n[model]\nname = \"m\"\n[[coordinate]]\nname = \"q\"\nunit = \"1\"\n"
        "range = [\"1\", \"2\"]\n[parameters]\nJ = { value = 2 }\n[define]\n";
    std::string last = leaf;
    for (int i = 0; i < steps; ++i) {
      text += fmt::format("d{} = \"{}\"\n", i, fmt::format(fmt::runtime(step), last));
      last = fmt::format("d{}", i);
    }
    test::write_text(workspace.path() / "m.toml",
                     text + "[energy]\nT = \"1/2*J*dot(q)^2\"\nV = \"J*q*" + last + "\"\n");
    return workspace.run("elgen generate m.toml").status;
  };
  CHECK(status("pi", "atan(3*{0})^64*atan(3*{0})^64*atan(3*{0})^64", 31) == 0);
  CHECK(status("3*q", "cos({0}+1/3)^64-1", 8) == 0);
  CHECK(status("q", "tan({0})^64", 8) == 0);
}

#ifdef ELGEN_HARDENED
TEST_CASE("the program stops at memory errors") {
  const Workspace workspace;
  const auto printed = [&](const std::string& options) {
    const Outcome outcome = workspace.run("readelf -W " + options + " \"$ELGEN\"");
    REQUIRE(outcome.status == 0);
    return outcome.output;
  };
  // Full RELRO: all symbols are bound at start, and the loader's data is read-only afterwards.
  CHECK(mentions(printed("--program-headers"), "GNU_RELRO"));
  CHECK(mentions(printed("--dynamic"), "BIND_NOW"));
  const std::string symbols = printed("--dyn-syms");
  CHECK(mentions(symbols, "__stack_chk_fail"));       // -fstack-protector-strong
  CHECK(mentions(symbols, "_chk@GLIBC"));             // -D_FORTIFY_SOURCE=2
  CHECK(mentions(symbols, "__glibcxx_assert_fail"));  // -D_GLIBCXX_ASSERTIONS
}
#endif

#ifdef ELGEN_LINKS_JEMALLOC
TEST_CASE("the program allocates with jemalloc, and programs that link its libraries do not") {
  const Outcome linked = Workspace().run("readelf -W --dynamic \"$ELGEN\" | grep NEEDED");
  REQUIRE(linked.status == 0);
  // The loader takes `malloc` and `operator new` from the first library that defines them.
  const std::size_t place = linked.output.find("libjemalloc");
  REQUIRE(place != std::string::npos);
  CHECK(place < linked.output.find("libstdc++"));
  CHECK(place < linked.output.find("libc.so"));
  CHECK_FALSE(mentions(read_text("/proc/self/maps"), "jemalloc"));
}
#endif

}  // namespace elgen::test
