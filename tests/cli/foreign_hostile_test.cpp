// elgen verify --foreign: code that crashes, hangs, writes out of bounds, or returns invalid
// answers.
#include <catch2/catch.hpp>

#include "cli/foreign_testing.hpp"

namespace elgen::test {

TEST_CASE("a crash or a hang ends only the foreign code") {
  const Foreign folder;
  const std::string end = "  result[0] = a;\n";
  const Outcome crash = folder.compare_changed(
      end, end + "  static int calls;\n  if (++calls == 4) raise(SIGSEGV);\n");
  INFO(crash.output << crash.errors);
  CHECK(crash.status == 1);
  CHECK(mentions(crash.output, "was ended by signal 11 (Segmentation fault), after 3 answers\n"));
  CHECK(crash.errors.empty());
  const Outcome hang =
      folder.compare_changed(end, end + "  for (;;) sleep(1);\n", "--limit seconds=3");
  INFO(hang.output << hang.errors);
  CHECK(hang.status == 1);
  CHECK(mentions(hang.output, "has not ended within 3 s, after 0 answers\n"));
  folder.write("hang.py", "import time\nprint([1, 2], flush=True)\ntime.sleep(60)\n");
  const Outcome command = folder.run(
      "elgen verify --limit seconds=3 --foreign 'python3 hang.py' --function forward_dynamics " +
      models + "/cart_pole.toml");
  INFO(command.output << command.errors);
  CHECK(command.status == 1);
  CHECK(mentions(command.output, "has not ended within 3 s, after 1 answer\n"));
}

TEST_CASE("a library that stops itself or ignores its alarm is ended within the limit") {
  const Foreign folder;
  const std::string end = "  result[0] = a;\n";
  for (const char* const hang :
       {"alarm(0); for (;;) sleep(1000);", "raise(SIGSTOP);",
        "signal(SIGALRM, SIG_IGN); for (;;) sleep(1000);", "for (;;) write(1, q, 8);"}) {
    INFO(hang);
    const Outcome outcome =
        folder.compare_changed(end, end + "  " + hang + "\n", "--limit seconds=2");
    INFO(outcome.output << outcome.errors);
    CHECK(outcome.status == 1);
    CHECK(mentions(outcome.output, "has not ended within 2 s, after 0 answers\n"));
  }
}

TEST_CASE("a library that writes outside its result is reported") {
  const Foreign folder;
  const std::string end = "  result[0] = a;\n";
  const std::string before = "writes before its result, after 0 answers";
  const auto compared = [&](const std::string& text) {
    const Outcome outcome = folder.compare_changed(end, end + text);
    INFO(text << outcome.output);
    CHECK(outcome.status == 1);
    return outcome.output;
  };
  CHECK(mentions(compared("  result[-1] = 7;\n"), before));
  CHECK(mentions(compared("  for (int i = 1; i < 2000; ++i) result[-i] = 7;\n"), before));
  CHECK(mentions(compared("  for (long i = 1; i < 100000000; ++i) result[-i] = 7;\n"), before));
  CHECK(mentions(compared("  static int calls;\n  if (++calls == 3) result[-1] = 7;\n"),
                 "writes before its result, after 2 answers"));
}

TEST_CASE("output of a library is indented, and shown only if the library fails") {
  const Foreign folder;
  const std::string end = "  result[0] = a;\n";
  const std::string words = R"(write(1, "[1, 2]\n::error::x\n", 18);)";
  const Outcome right = folder.compare_changed(end, end + words);
  INFO(right.output << right.errors);
  CHECK(right.status == 0);
  CHECK(right.errors.empty());
  CHECK_FALSE(mentions(right.output, "error"));
  const Outcome wrong = folder.compare_changed(end, end + words + " raise(SIGSEGV);");
  INFO(wrong.output << wrong.errors);
  CHECK(wrong.status == 1);
  const std::string indented = "its words:\n    [1, 2]\n    ::error::x\n";
  CHECK(mentions(wrong.output, "signal 11 (Segmentation fault), after 0 answers\n"));
  CHECK(mentions(wrong.output, indented));
}

TEST_CASE("a command that fails or writes after its last answer is reported") {
  const Foreign folder;
  const std::string as = "--function forward_dynamics --samples 10";
  const Outcome exits = folder.compare_command(script + "sys.exit(3)\n", as);
  INFO(exits.output << exits.errors);
  CHECK(exits.status == 1);
  CHECK(mentions(exits.output, "forward_dynamics  exits 3, after 14 answers\n"));
  const Outcome writes = folder.compare_command(script + "print([1, 2])\nprint('done')\n", as);
  CHECK(writes.status == 1);
  CHECK(mentions(writes.output, "writes `[1, 2]` beyond its last answer, after 14 answers"));
  CHECK(folder.compare_command(script + "print()\n", as).status == 0);
}

TEST_CASE("numbers too large for double are infinite, not 0") {
  const Foreign folder;
  folder.write("masses.toml", R"toml(format = 1
[model]
name = "masses"
[[coordinate]]
name = "x"
unit = "m"
[[coordinate]]
name = "y"
unit = "m"
[parameters]
m = { value = 2, unit = "kg" }
[energy]
T = "1/2*m*(dot(x)^2 + dot(y)^2)"
)toml");
  const auto compared = [&](const std::string& matrix) {
    return folder.compare_command(
        "import json, sys\nfor line in sys.stdin:\n"
        "  m = json.loads(line)['p']['m']\n  print('" +
            matrix + "' % (m, m))\n",
        "--function mass_matrix", "masses.toml");
  };
  const Outcome large = compared("[%r, 1e310, -1e310, %r]");
  INFO(large.output << large.errors);
  CHECK(large.status == 1);
  CHECK(mentions(large.output, "mass_matrix[x, y] is inf, the oracle says 0"));
  CHECK(compared("[%r, 1e-400, -1e-400, %r]").status == 0);
}

TEST_CASE("a wrong count of numbers, NaN and invalid numbers are reported") {
  const Foreign folder;
  const std::string end = "  result[0] = a;\n";
  CHECK(mentions(folder.compare_changed(end, end + "  result[2] = a;\n").output,
                 "gives 3 numbers for 2 x 1 entries\n"));
  CHECK(mentions(folder.compare_changed("  result[1] =", "  const real lost =").output,
                 "gives 1 number for 2 x 1 entries\n"));
  const std::string as = "--function forward_dynamics";
  CHECK(mentions(folder.compare_command("print([1, 2, 3])\n", as).output,
                 "gives 3 numbers for 2 x 1 entries\n"));
  const Outcome in_c = folder.compare_changed("(g * s - c * a) / l", "NAN");
  INFO(in_c.output);
  CHECK(in_c.status == 1);
  CHECK(mentions(in_c.output, "forward_dynamics.acceleration[theta] is nan, the oracle says "));
  CHECK(mentions(in_c.output, "found      wrong even at rest\n"));
  CHECK(mentions(
      folder.compare_command(replaced(script, "return [a, ", "return [math.nan, "), as).output,
      "forward_dynamics.acceleration[x] is nan, the oracle says "));
  CHECK(mentions(folder.compare_command("print('ready')\n", as).output,
                 "answers `ready`, which is no list of numbers, after 0 answers\n"));
  CHECK(mentions(folder.compare_command("print([1, 2])\n", as).output,
                 "ends early, after 1 answer\n"));
}

TEST_CASE("the output of a failing command is shown") {
  const Foreign folder;
  const Outcome outcome =
      folder.compare_command("raise ValueError('no such pole')\n", "-q --function bias");
  CHECK(outcome.status == 1);
  CHECK(mentions(outcome.errors,
                 "error[E717]: `bias` exits 1, after 0 answers; its words:\n"
                 "    Traceback"));
  CHECK(mentions(outcome.errors, "\n    ValueError: no such pole"));
}

}  // namespace elgen::test
