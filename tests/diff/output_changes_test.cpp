// The change of every entry, and a state that demonstrates the change.
#include <catch2/catch.hpp>

#include "diff/versions.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::vector<OutputChange> entry_changes(const std::string& before, const std::string& after) {
  const LoweredVersion old = lowered(before);
  const LoweredVersion now = lowered(after);
  return output_changes(old.version(), now.version());
}

const OutputChange& output(const std::vector<OutputChange>& all, const std::string& name) {
  return *std::ranges::find(all, name, &OutputChange::name);
}

EntryChange only_change(const std::string& before, const std::string& after) {
  const SystemChange system = compared(before, after);
  const auto entries = entries_of(system, "potential_energy");
  REQUIRE(entries.size() == 1);
  REQUIRE(entries[0].witness);
  return entries[0];
}

}  // namespace

TEST_CASE("entries with identical code are not listed") {
  for (const OutputChange& change : entry_changes(spring(), spring()))
    CHECK(change.entries.empty());
}

TEST_CASE("entries in another form are proved equal") {
  const auto all = entry_changes(spring("k*(1 - cos(x))"), spring("2*k*sin(x/2)^2"));
  const OutputChange& potential = output(all, "potential_energy");
  REQUIRE(potential.entries.size() == 1);
  CHECK(potential.entries[0].verdict == EntryVerdict::equal);
  CHECK(potential.entries[0].is_proved);
  CHECK(output(all, "mass_matrix").entries.empty());
}

TEST_CASE("different entries are printed with their difference") {
  const auto all = entry_changes(spring(), spring("1/2*k*x^2 + m*x"));
  const OutputChange& gravity = output(all, "gravity");
  REQUIRE(gravity.entries.size() == 1);
  CHECK(gravity.entries[0].verdict == EntryVerdict::different);
  CHECK(gravity.entries[0].before == "k*x");
  CHECK(gravity.entries[0].after == "m + k*x");
  CHECK(gravity.entries[0].difference == "m");
}

TEST_CASE("outputs of only one version are listed") {
  const std::string with_output = spring() + "[[output]]\nname = \"place\"\nvalue = \"x\"\n";
  CHECK(output(entry_changes(spring(), with_output), "place").entries.at(0).verdict ==
        EntryVerdict::added);
  CHECK(output(entry_changes(with_output, spring()), "place").entries.at(0).verdict ==
        EntryVerdict::removed);
}

TEST_CASE("setting a new parameter to a value restores the old entries") {
  const LoweredVersion old = lowered(spring());
  const LoweredVersion now = lowered(replaced(spring("1/2*k*x^2 + c*x"), "k = 3", "k = 3\nc = 0"));
  const auto count = [&](const ParameterValues& values) {
    std::size_t different = 0;
    for (const auto& change : output_changes(old.version(), now.version(), {}, values)) {
      different += static_cast<std::size_t>(
          std::ranges::count(change.entries, EntryVerdict::different, &EntryChange::verdict));
    }
    return different;
  };
  CHECK(count({}) > 0);
  CHECK(count({{"c", rational_constant(0)}}) == 0);
  CHECK(count({{"c", rational_constant(1)}}) > 0);
}

TEST_CASE("an implicit step, whose error bounds grow at every iteration, is still different") {
  const std::string scene = "[outputs]\nstep = { method = \"midpoint\" }\n";
  const std::string arm = model_file("double_pendulum");
  const LoweredVersion old = lowered(arm, scene, Goal::choose);
  const LoweredVersion now = lowered(replaced(arm, "\"-g\"", "\"g\""), scene, Goal::choose);
  const auto all = output_changes(old.version(), now.version());
  REQUIRE(all.size() == 1);
  CHECK(all[0].entries.size() == all[0].entry_count);
  for (const EntryChange& entry : all[0].entries) {
    CHECK(entry.verdict == EntryVerdict::different);
  }
}

TEST_CASE("an entry too long for a line is not printed") {
  std::string sum = "cos(x)";
  for (int i = 2; i <= 20; ++i) sum += " + cos(" + std::to_string(i) + "*x)";
  const auto all = entry_changes(spring(), spring("k*(" + sum + ")"));
  const EntryChange& entry = output(all, "potential_energy").entries.at(0);
  CHECK_FALSE(entry.before.empty());
  CHECK(entry.after.empty());
}

TEST_CASE("the witness lists the variables of the entry, rounded as printed") {
  const EntryChange change = only_change(spring("1/2*k*x^2"), spring("k*x^2"));
  CHECK(change.relative_change == Approx(0.5));
  const std::string& at = change.witness->state_text;
  REQUIRE(starts_with(at, "x = "));
  const double x = std::stod(at.substr(4));
  CHECK(change.witness->before == Approx(1.5 * x * x).epsilon(1e-12));
  CHECK(change.witness->after == Approx(3 * x * x).epsilon(1e-12));
}

TEST_CASE("parameters with value 0 get random values, so that their terms are compared") {
  const std::string before = replaced(spring(), "k = 3", "k = 3\nc = 0");
  const EntryChange change =
      only_change(before, replaced(before, "1/2*k*x^2", "1/2*k*x^2 + c*x^4"));
  CHECK(mentions(change.witness->state_text, "c = "));
  CHECK(change.relative_change > 0);
}
