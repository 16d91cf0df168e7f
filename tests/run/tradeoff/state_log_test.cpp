// Logs of runs, whose rows are the states of a trade-off.
#include <catch2/catch.hpp>
#include <set>

#include "run/tradeoff/derived.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// The inverse dynamics of a pendulum with an angle q, which take q, dot(q), dot(dot(q)) and t.
Products pendulum() { return derived(read_model("pushed_pendulum"), "inverse_dynamics"); }

Result<StateLog> log_of(const std::string& text) {
  return read_state_log(*make_permanent_source("run.csv", text), pendulum().checked->model);
}

/// The errors as "line:column message | hint", one per line.
std::string errors_of(const std::string& text) {
  std::string lines;
  for (const Diagnostic& error : log_of(text).diagnostics) {
    CHECK(error.code == Code::E650);
    const LineColumn at = line_column(*error.span.source, error.span.begin);
    lines += std::to_string(at.line) + ":" + std::to_string(at.column) + " " + error.message;
    lines += error.hint.empty() ? "\n" : " | " + error.hint + "\n";
  }
  return lines;
}

/// A log in which q is 0, 1, 2, ….
StateLog counted_log(std::size_t rows) {
  StateLog log{{{Opcode::coordinate, 0}, {Opcode::velocity, 0}}};
  for (std::size_t i = 0; i < rows; ++i) log.rows.push_back({static_cast<double>(i), 0});
  return log;
}

std::vector<double> angles(const StateLog& log, std::uint64_t seed, std::size_t count) {
  const Products products = pendulum();
  const auto states =
      sample_tradeoff_states(*products.checked, *products.program,
                             {.count = count, .seed = seed, .log = log, .samples = 3});
  REQUIRE(states);
  std::vector<double> found;
  for (const Arguments<double>& state : states->states) found.push_back(state.q[0]);
  return found;
}

}  // namespace

TEST_CASE("a log has a column for each leaf, in any order, and a row for each line") {
  const Result<StateLog> read = log_of("t,dot(q), q,E\r\n0,-1e-3, 0.5 ,-1\r\n\n1,2,3,4");
  REQUIRE(read);
  CHECK(read->leaves == std::vector<std::pair<Opcode, std::uint32_t>>{{Opcode::time, 0},
                                                                      {Opcode::velocity, 0},
                                                                      {Opcode::coordinate, 0},
                                                                      {Opcode::energy, 0}});
  CHECK(read->rows == std::vector<std::vector<double>>{{0, -1e-3, 0.5, -1}, {1, 2, 3, 4}});
}

TEST_CASE("E650: wrong names in the first line of a log") {
  CHECK(errors_of("q,dot(p)\n1,2\n") == "1:3 unknown column `dot(p)` | did you mean `dot(q)`?\n");
  CHECK(errors_of("q,m,dot(q)\n1,2,3\n").starts_with("1:3 unknown column `m`"));
  CHECK(errors_of("q,dot(q),q\n1,2,1\n") == "1:10 repeated column `q`\n");
  CHECK(errors_of("t,q\n0,1\n") == "1:1 missing column `dot(q)`\n");
  CHECK(errors_of("t\n0\n") == "1:1 missing column `q`\n1:1 missing column `dot(q)`\n");
}

TEST_CASE("E650: wrong rows of a log") {
  CHECK(errors_of("") == "1:1 the log has no row of numbers\n");
  CHECK(errors_of("q,dot(q)\n\n") == "1:1 the log has no row of numbers\n");
  CHECK(errors_of("q,dot(q)\n1\n") == "2:1 1 number, but 2 columns\n");
  CHECK(errors_of("q,dot(q)\n1,2\n1,2,3\n") == "3:1 3 numbers, but 2 columns\n");
  CHECK(errors_of("q,dot(q)\n1, fast\n") == "2:4 `fast` is no finite number\n");
  CHECK(errors_of("q,dot(q)\n1,\n") == "2:3 `` is no finite number\n");
  for (const std::string word : {"nan", "inf", "1e999", "1 2", "0,5"}) {
    INFO(word);
    CHECK(errors_of("q,dot(q)\n1," + word + "\n").starts_with("2:"));
  }
}

TEST_CASE("the samples together have all rows of a short log, and every tenth of a long log") {
  std::multiset<double> all;
  for (const std::uint64_t seed : {1, 2, 3}) {
    for (const double q : angles(counted_log(4), seed, 4)) all.insert(q);
  }
  CHECK(all == std::multiset<double>{0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3});
  const std::vector<double> second = angles(counted_log(120), 2, 4);
  CHECK(second == std::vector<double>{10, 40, 70, 100});
}

TEST_CASE("values that the log lacks are drawn, and only these values are searched") {
  const Products products = pendulum();
  const auto states = sample_tradeoff_states(*products.checked, *products.program,
                                             {.count = 50, .log = counted_log(1)});
  REQUIRE(states);
  std::set<double> accelerations;
  for (const Arguments<double>& state : states->states) {
    CHECK(state.q[0] == 0);
    CHECK(state.v[0] == 0);
    accelerations.insert(state.a[0]);
  }
  CHECK(accelerations.size() == 50);
  CHECK(states->low.q == states->high.q);
  CHECK(states->low.a[0] < states->high.a[0]);
}

TEST_CASE("quaternions of a log are scaled to length 1") {
  const Products products = derived(read_model("tumbler"), "momentum");
  const std::vector<Rotation>& rotations = products.checked->model.rotations;
  REQUIRE(rotations.size() == 1);
  const std::uint32_t first = rotations.front().first_coordinate;
  StateLog log;
  for (std::uint32_t i = 0; i < 4; ++i) log.leaves.emplace_back(Opcode::coordinate, first + i);
  log.rows = {{0, 2, 0, 0}};
  const auto states =
      sample_tradeoff_states(*products.checked, *products.program, {.count = 1, .log = log});
  REQUIRE(states);
  const std::vector<double>& q = states->states.front().q;
  CHECK(std::vector<double>(q.begin() + first, q.begin() + first + 4) ==
        std::vector<double>{0, 1, 0, 0});
}
