// Random pairs of models known to be equal or different: systems of one to seven coordinates in two
// forms, or with one coefficient changed by 1e-12 or 1. Hand-written pairs are in rewritings_test
// and verdicts_test.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "diff/versions.hpp"
#include "numbers/random.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

constexpr std::uint64_t kinds = 5;

/// c f(q_i, q_j), with one of five functions f and an exact c.
struct Term {
  std::uint64_t kind = 0;
  std::size_t i = 0;
  std::size_t j = 0;
  std::string coefficient = "1";
};

/// The factor f(q_i, q_j) of a term of V, in its first or its rewritten form.
std::string potential(const Term& term, bool is_rewritten) {
  const std::string x = fmt::format("q{}", term.i);
  const std::string y = fmt::format("q{}", term.j);
  const char* const forms[kinds][2]{
      {"cos({0} - {1})", "(cos({0})*cos({1}) + sin({1})*sin({0}))"},
      {"sin({0})*sin({1})", "1/2*(cos({0} - {1}) - cos({0} + {1}))"},
      {"({0} + {1})^2", "({0}*({0} + 2*{1}) + {1}^2)"},
      {"(1 - cos({0}))", "2*sin({0}/2)^2"},
      {"sqrt(1 + {0}^2)*{1}", "{1}*({0}^2 + 1)/sqrt({0}*{0} + 1)"},
  };
  return fmt::format(fmt::runtime(forms[term.kind][is_rewritten ? 1 : 0]), x, y);
}

struct RandomSystem {
  std::size_t size = 1;
  std::vector<Term> terms = {};

  explicit RandomSystem(std::uint64_t seed) {
    Random random(seed);
    size = 1 + random.next() % 7;
    for (std::size_t k = 0; k < size + 2; ++k) {
      terms.push_back({random.next() % kinds, random.next() % size, random.next() % size,
                       std::to_string(1 + random.next() % 9)});
    }
  }

  /// The model; if `is_rewritten`, every term has its second form, and the terms are in reverse
  /// order.
  [[nodiscard]] std::string text(bool is_rewritten) const {
    std::string coordinates;
    std::string T;
    for (std::size_t i = 0; i < size; ++i) {
      coordinates += fmt::format("[[coordinate]]\nname = \"q{}\"\n", i);
      const std::size_t j = (i + 1) % size;
      T += fmt::format(
          fmt::runtime(is_rewritten ? "{0}m*dot(q{1})*dot(q{1})/2 + 1/4*m*{2}*dot(q{1})*dot(q{3})"
                                    : "{0}1/2*m*dot(q{1})^2 + 1/4*m*dot(q{1})*dot(q{3})*{2}"),
          i == 0 ? "" : " + ", i, potential({0, i, j, ""}, is_rewritten), j);
    }
    std::vector<Term> all = terms;
    if (is_rewritten) std::ranges::reverse(all);
    std::string V;
    for (const Term& term : all) {
      V += fmt::format("{}{}*k*{}", V.empty() ? "" : " + ", term.coefficient,
                       potential(term, is_rewritten));
    }
    return model_text("pair", coordinates +
                                  "[parameters]\nm = { value = 2, assume = \"positive\" }\n"
                                  "k = 3\n[energy]\nT = \"" +
                                  T + "\"\nV = \"" + V + "\"\n");
  }
};

/// The model `text` with all outputs or, above four coordinates, with four quickly derived outputs.
LoweredVersion lowered_system(const RandomSystem& system, const std::string& text) {
  return lowered(text, system.size <= 4 ? "" : R"toml([outputs]
mass_matrix = true
bias = true
potential_energy = true
inverse_dynamics = true
)toml");
}

/// The number of equal pairs. There are as many different pairs.
constexpr std::uint64_t pair_count = 20;

}  // namespace

TEST_CASE(
    "twenty random systems are equal in another form, and different with one coefficient changed") {
  std::size_t rewritten = 0;
  for (std::uint64_t seed = 1; seed <= pair_count; ++seed) {
    RandomSystem system(seed);
    INFO("seed " << seed << ", n = " << system.size);
    const LoweredVersion before = lowered_system(system, system.text(false));
    const LoweredVersion equal = lowered_system(system, system.text(true));
    const SystemChange none = compare(before.version(), equal.version());
    CHECK(none.impact == Impact::equal);
    rewritten += entries_of(none, "potential_energy").size();

    Term& term = system.terms[seed % system.terms.size()];
    term.coefficient = fmt::format("({} + {})", term.coefficient, seed % 2 == 0 ? "1e-12" : "1");
    const LoweredVersion changed = lowered_system(system, system.text(seed % 3 == 0));
    const SystemChange one = compare(before.version(), changed.version());
    CHECK(one.impact == Impact::different);
    const auto entries = entries_of(one, "potential_energy");
    REQUIRE(entries.size() == 1);
    CHECK(entries[0].verdict == EntryVerdict::different);
  }
  CHECK(rewritten > pair_count / 2);
}

namespace {

/// An edit of a committed model, and its impact.
struct Edit {
  const char* model;
  const char* part;
  const char* other;
  Impact impact;
};

}  // namespace

TEST_CASE("edits of known models have the expected impact") {
  const Edit edits[]{
      {"simple_pendulum", "g = {", "# gravity\ng = {", Impact::equal},
      {"cart_pole", "\"x + l*sin(theta)\"", "\"l*sin(theta) + x\"", Impact::equal},
      {"cart_pole", "\"x + l*sin(theta)\"", "\"x - l*sin(-theta)\"", Impact::equal},
      {"cart_pole", "\"x + l*sin(theta)\"", "\"x + 2*l*sin(theta/2)*cos(theta/2)\"", Impact::equal},
      {"cart_pole", "\"x + l*sin(theta)\"", "\"x - l*sin(theta)\"", Impact::different},
      {"cart_pole", "\"x + l*sin(theta)\"", "\"x + 1.000000000001*l*sin(theta)\"",
       Impact::different},
      {"cart_pole", "mass = \"M\"", "mass = \"(M^2 - m^2)/(M - m) - m\"", Impact::equal},
      {"cart_pole", "mass = \"M\"", "mass = \"sqrt(M^2)\"", Impact::equal},
      {"cart_pole", "name   = \"u\"", "name   = \"F\"", Impact::breaks},
      {"cart_pole", "\"-g\"", "\"0\"", Impact::breaks},
      {"cart_pole", "doc        = \"cart position\"", "doc        = \"position\"", Impact::values},
      {"cart_pole", "value = 9.81", "value = 9.80665", Impact::values},
      {"cart_pole", "unit       = \"rad\"", "unit       = \"1\"", Impact::values},
      {"double_pendulum", "value = 9.81", "value = 9.8", Impact::values},
      {"chain", "n = 5", "n = 4", Impact::breaks},
      {"chain", "l[i]*sin(q[i])", "l[i]*cos(q[i] - pi/2)", Impact::equal},
      {"chain", "l[i]*sin(q[i])", "l[i]*sin(q[i] + 2*pi)", Impact::equal},
      {"heavy_top", "name        = \"heavy_top\"", "name = \"top\"", Impact::breaks},
  };
  for (const auto& [model, part, other, impact] : edits) {
    INFO(model << ": " << part << " -> " << other);
    const std::string before = model_file(model);
    CHECK(impact_row(compared(before, replaced(before, part, other)).impact).word ==
          impact_row(impact).word);
  }
}

TEST_CASE("reordered coordinates of a chain of three to seven break callers silently") {
  for (const int n : {3, 7}) {
    const RandomSystem system(static_cast<std::uint64_t>(n));
    if (system.size < 2) continue;
    const std::string before = system.text(false);
    const std::string first = "[[coordinate]]\nname = \"q0\"\n";
    const std::string after =
        replaced(replaced(before, first, ""), "[parameters]", first + "[parameters]");
    const SystemChange found = compared(before, after);
    CHECK(breaks_silently(found));
    for (const OutputChange& output : found.outputs) {
      for (const EntryChange& entry : output.entries) {
        INFO(entry.place);
        CHECK(entry.verdict == EntryVerdict::equal);
      }
    }
  }
}
