// Counts the operations of every pipeline stage for chains of n links and bounds their growth.
//
// The program for the inverse dynamics of a chain is linear in n, and so is the product of every
// earlier stage. Blocks may grow as n^1.1 from one size to the next. This bound permits the
// logarithm of searching and sorting, but no n^2 part that takes a twentieth of a stage's work at n
// = 300. Bytes may grow as n^1.2, because tables that double their capacity round up. The n x n
// outputs (M, C) are not requested. Pages of closed forms have n^2 terms and more; their operations
// stay polynomials of low degree.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "elgen/analysis_pages.hpp"
#include "elgen/oracle.hpp"
#include "elgen/pipeline.hpp"
#include "growth/operations.hpp"
#include "support/links.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// 1 for stages of closed forms if `links` <= 30, because closed forms have n^2 terms; otherwise 0.
/// Above 30 links the closed forms exceed their budget.
double extra_exponent(const std::string& stage, int links) {
  const bool is_closed = stage == "present" || stage == "choose" || stage == "typeset";
  return is_closed && links <= 30 ? 1 : 0;
}

using Counts = std::map<std::string, Operations>;

/// Operations of each stage: the count at its end minus the count at its start.
class Count {
 public:
  void begin(const std::string& stage) {
    end();
    stage_ = stage;
    start_ = operations();
  }

  Counts end() {
    const Operations now = operations();
    if (!stage_.empty()) {
      counts_[stage_] = {now.bytes - start_.bytes, now.blocks - start_.blocks};
    }
    stage_.clear();
    return counts_;
  }

 private:
  std::string stage_ = {};
  Operations start_ = {};
  Counts counts_ = {};
};

SourcePointer option(const std::string& text) { return make_source("option", text); }

PipelineSources chain() { return {make_source("chain.toml", model_file("chain")), nullptr}; }

PipelineOptions chain_options(int links, const std::string& output) {
  PipelineOptions options;
  options.scene.sizes = {option("n=" + std::to_string(links))};
  options.scene.outputs = {option(output)};
  return options;
}

Counts counts_of_chain(int links) {
  PipelineOptions options = chain_options(links, "inverse_dynamics");
  options.goals = {Goal::emit};
  // Goal::emit does not run the self-check, so the test calls self_check. The number of checked
  // states falls with the length of the program, but is at least 4.
  Count count;
  options.on_stage = [&](const std::string& stage) { count.begin(stage); };
  const Products products = run_pipeline(chain(), options);
  REQUIRE(products.files);
  const auto& [model, scene] = *products.checked;
  count.begin("self-check");
  const SelfCheck check = self_check(model, scene, *products.program);
  CHECK(check.failure.empty());
  CHECK(check.states > 0);
  count.begin("magnitude of the energy");
  CHECK(oracle_energy_magnitude(model, nominal_state(model, scene)));
  return count.end();
}

/// Operations of the stage `typeset`.
Operations count_of_pages(const PipelineSources& inputs, PipelineOptions options) {
  Count count;
  options.goals = {Goal::typeset};
  options.on_stage = [&](const std::string& stage) { count.begin(stage); };
  const Products products = run_pipeline(inputs, options);
  REQUIRE(products.page_programs);
  return count.end().at("typeset");
}

/// Operations of `typeset` for V = a1*x + a1*a2*x + ... + a1*a2*...*an*x, n = `terms`.
Operations count_of_nested_parameters(int terms) {
  std::string parameters;
  std::string product = "x";
  std::string energy;
  for (int i = 1; i <= terms; ++i) {
    const std::string name = "a" + std::to_string(i);
    parameters += name + " = 2\n";
    product = name + "*" + product;
    energy += (i > 1 ? " + " : "") + product;
  }
  const std::string text =
      "format = 1\n[model]\nname = \"nested\"\n[[coordinate]]\nname = \"x\"\n[parameters]\n" +
      parameters + "[energy]\nT = \"1/2*dot(x)^2\"\nV = \"" + energy + "\"\n";
  return count_of_pages({make_source("nested.toml", text), nullptr}, {});
}

void check_growth(std::uint64_t few, std::uint64_t many, double factor) {
  CHECK(static_cast<double>(many) <= static_cast<double>(few) * factor);
}

}  // namespace

TEST_CASE("operations of a stage grow no faster than the chain") {
  counts_of_chain(10);  // fills the caches that all later runs share
  std::map<int, Counts> counts;
  for (const int links : {10, 30, 100, 300, 1000}) counts[links] = counts_of_chain(links);
  for (auto many = std::next(counts.begin()); many != counts.end(); ++many) {
    const auto few = std::prev(many);
    const double growth = static_cast<double>(many->first) / few->first;
    // Every goal except steps, claims and the analyses is a stage here; the energy's magnitude is
    // an additional stage.
    REQUIRE(many->second.size() == stage_names.size() - analysis_table.size() - 1);
    for (const auto& [stage, count] : many->second) {
      const Operations& before = few->second.at(stage);
      INFO(stage << ", " << few->first << " and " << many->first << " links: " << before.bytes
                 << " and " << count.bytes << " bytes, " << before.blocks << " and " << count.blocks
                 << " blocks");
      const double excess = extra_exponent(stage, many->first);
      check_growth(before.bytes, count.bytes, std::pow(growth, 1.2 + excess));
      check_growth(before.blocks, count.blocks, std::pow(growth, 1.1 + excess));
    }
  }
}

TEST_CASE("the self-check of forward dynamics grows slower than M") {
  // One state of M has n^2 entries; all other work is linear in n.
  const auto count_of = [](int links) {
    PipelineOptions options;
    options.scene.outputs = {option("forward_dynamics")};
    Count count;
    options.on_stage = [&](const std::string& stage) { count.begin(stage); };
    const Products products =
        run_pipeline({make_source("links.toml", links_text(links)), nullptr}, options);
    REQUIRE(products.self_check);
    CHECK(products.self_check->failure.empty());
    return count.end().at("self-check");
  };
  count_of(10);
  const Operations few = count_of(40);
  const Operations many = count_of(100);
  INFO(few.bytes << " and " << many.bytes << " bytes, " << few.blocks << " and " << many.blocks
                 << " blocks");
  check_growth(few.bytes, many.bytes, std::pow(100.0 / 40, 1.5));
  check_growth(few.blocks, many.blocks, std::pow(100.0 / 40, 1.5));
}

TEST_CASE("pages of nested sums do not double with every sum") {
  // n^5: n sums, n terms in a sum, n factors in a term, n candidates, n comparisons of a candidate.
  const double most = std::pow(2, 5);
  const auto check = [most](const Operations& few, const Operations& many) {
    INFO(few.bytes << " and " << many.bytes << " bytes, " << few.blocks << " and " << many.blocks
                   << " blocks");
    check_growth(few.bytes, many.bytes, most);
    check_growth(few.blocks, many.blocks, most);
  };
  const auto of_links = [](int links) {
    return count_of_pages(chain(), chain_options(links, "forward_dynamics"));
  };
  check(of_links(10), of_links(20));
  check(of_links(25), of_links(50));
  check(count_of_nested_parameters(8), count_of_nested_parameters(16));
}

namespace {

/// Bytes that the pipeline allocates up to the last of `goals`, with n = `size` coordinates.
std::uint64_t bytes_of(const std::string& text, const std::vector<Goal>& goals,
                       const std::vector<std::string>& outputs, int size) {
  const PipelineSources inputs{make_source("small.toml", text), nullptr};
  PipelineOptions options;
  options.scene.sizes = {option("n=" + std::to_string(size))};
  for (const std::string& output : outputs) options.scene.outputs.push_back(option(output));
  options.goals = goals;
  const Operations start = operations();
  const Products products = run_pipeline(inputs, options);
  REQUIRE_FALSE(has_errors(products.diagnostics));
  return operations().bytes - start.bytes;
}

std::string small_model(const std::string& energy) {
  return "format = 1\n[model]\nname = \"small\"\n[sizes]\nn = 4\n[[coordinate]]\nname = \"q[i]\"\n"
         "for = \"i in 1..n\"\nrange = [-3, 3]\n[energy]\n" +
         energy;
}

}  // namespace

TEST_CASE("a column of C is differentiated by its own rate only") {
  const std::string dense = small_model(
      "T = \"sum(i, 1, n, sum(j, 1, n, dot(q[i])*dot(q[j])*cos(q[i] - q[j])))/2 + "
      "sum(i, 1, n, dot(q[i])^2*n)\"\nV = \"0\"\n");
  const auto bytes = [&](int size) {
    return bytes_of(dense, {Goal::derive}, {"coriolis_matrix"}, size);
  };
  bytes(4);
  // C has n^2 entries with n terms each. Derivatives of each column by all rates would cost n^3.6.
  check_growth(bytes(8), bytes(24), std::pow(3, 3.2));
}

TEST_CASE("a page of modes reads only the non-zero entries") {
  const std::string springs = small_model(
      "T = \"sum(i, 1, n, dot(q[i])^2)/2\"\n"
      "V = \"sum(i, 1, n, q[i]^2) + sum(i, 2, n, (q[i] - q[i-1])^2)\"\n");
  const auto bytes = [&](int size) {
    const Products products = run_pipeline(
        {make_source("small.toml", springs), nullptr},
        {.scene = {.sizes = {option("n=" + std::to_string(size))}}, .goals = {Goal::modes}});
    REQUIRE(products.modes);
    const Operations start = operations();
    CHECK_FALSE(text_of(modes_page(*products.checked, *products.modes)).empty());
    return operations().bytes - start.bytes;
  };
  bytes(4);
  // n^2 entries of length n.
  check_growth(bytes(10), bytes(40), std::pow(4, 3.1));
}

TEST_CASE("the search of boxes stops at its limit of operations") {
  const std::string waves = small_model(
      "T = \"sum(i, 1, n, dot(q[i])^2)/2\"\n"
      "V = \"sum(i, 1, n, cos(q[i])) + 0.3*sum(i, 2, n, cos(q[i] - q[i-1]))\"\n");
  for (const int size : {6, 12}) {
    const PipelineSources inputs{make_source("small.toml", waves), nullptr};
    PipelineOptions options;
    options.scene.sizes = {option("n=" + std::to_string(size))};
    options.goals = {Goal::equilibria};
    options.limits.enclosures = 1'000'000;
    const Products products = run_pipeline(inputs, options);
    REQUIRE(products.equilibria);
    CHECK(products.equilibria->limit == "enclosures=1000000");
    CHECK(products.equilibria->completeness == Completeness::searched);
    const auto n = static_cast<std::uint64_t>(size);
    CHECK(products.equilibria->boxes * 2 * n * n * n < options.limits.enclosures);
  }
}

TEST_CASE("allocations are always counted, blocks only if compiled with coverage") {
  const Operations before = operations();
  const std::vector<int> made(1000, 1);
  const Operations between = operations();
  int sum = 0;
  for (const int element : made) sum += element;
  const Operations after = operations();
  CHECK(sum == 1000);
  CHECK(between.bytes - before.bytes == made.size() * sizeof(int));
  CHECK(after.bytes == between.bytes);
  CHECK((after.blocks - between.blocks >= made.size()) == counts_blocks);
}
