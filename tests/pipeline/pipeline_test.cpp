// The stages run in order, stop at an error, and pass on their products.
#include "elgen/pipeline.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "pipeline/pipeline_testing.hpp"

namespace elgen::test {

namespace {

PipelineSources model(const std::string& name) { return inputs_of(model_file(name)); }

std::vector<std::string> stages(const Products& products) {
  std::vector<std::string> names;
  for (const StageTime& time : products.times) names.push_back(time.stage);
  return names;
}

}  // namespace

TEST_CASE("all stages run in order and give a checked program and its files") {
  const Products products = products_with(&Products::self_check, model("cart_pole"));
  CHECK(products.self_check->failure.empty());
  CHECK(products.self_check->states >= 1);  // an idle machine checks more states
  CHECK(products.files->files.size() == 3);
  CHECK(find_invariant_violation(*products.program).empty());
  std::vector<std::string> expected;
  for (const std::string_view name : stage_names) {
    const bool is_asked_for =
        name != "steps" && name != "claims" && find_analysis(*find_stage(name)) == nullptr;
    if (is_asked_for) expected.emplace_back(name);
  }
  CHECK(stages(products) == expected);
}

TEST_CASE("a page's program knows t if only its conserved quantities name t") {
  for (const char* const name : {"atwood", "free_body", "relativistic_particle",
                                 "triatomic_molecule", "two_body", "two_particles"}) {
    INFO(name);
    PipelineOptions options;
    options.goals = {Goal::choose};
    CHECK_FALSE(derived(model(name), options).program->leaves.uses_time);
    options.scene.purpose = purpose::show_motion;
    const Products page = derived(model(name), options);
    CHECK_FALSE(page.checked->model.uses_time);
    CHECK(page.program->leaves.uses_time);
    CHECK(find_invariant_violation(*page.program) == "");
  }
}

TEST_CASE("a fault of a stage keeps the findings of earlier stages") {
  const std::string text =
      "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"x\"\n[parameters]\nm = 1\n"
      "unused = 2\n[energy]\nT = \"m*dot(x)^2\"\n";
  PipelineOptions options;
  options.on_stage = [](const std::string& stage) {
    if (stage == "lower") throw std::logic_error("broken");
  };
  const Products products = run_pipeline({make_source("model.toml", text), nullptr}, options);
  std::vector<std::string> found;
  for (const Diagnostic& diagnostic : products.diagnostics) found.push_back(diagnostic.message);
  CHECK(found == std::vector<std::string>{
                     "`x`, `m`, `unused`: no unit, so expressions with it are not checked",
                     "parameter `unused` is used nowhere", "internal error in `lower`: broken"});
  CHECK(exit_code(products.diagnostics) == ExitCode::internal);
  CHECK_FALSE(products.program.has_value());
}

TEST_CASE("a goal runs the stages it needs, each once and in order, and no others") {
  const auto& all = stage_names;
  for (const std::string_view goal : all) {
    const Products products =
        run_pipeline(model("simple_pendulum"), {.goals = {*find_stage(goal)}});
    INFO(goal);
    CHECK_FALSE(has_errors(products.diagnostics));
    const std::vector<std::string> run = stages(products);
    CHECK(run.back() == goal);
    const auto* next = all.begin();
    for (const std::string& stage : run) {
      next = std::find(next, all.end(), stage);
      REQUIRE(next != all.end());
      ++next;
    }
    CHECK(products.steps.has_value() == (goal == "steps"));
    CHECK(products.self_check.has_value() == (goal == "self-check"));
    CHECK(products.files.has_value() == (goal == "emit" || goal == "self-check"));
  }
}

TEST_CASE("inspect checks the needs of each goal, whatever the other goals are") {
  const auto codes = [](const std::string& text, const std::vector<Goal>& goals) {
    PipelineOptions options;
    options.goals = goals;
    std::vector<Code> found;
    for (const Diagnostic& each : run_pipeline(inputs_of(text), options).diagnostics) {
      if (each.code != Code::E520) found.push_back(each.code);  // E520: no units
    }
    return found;
  };
  using Codes = std::vector<Code>;
  const std::string head = "format = 1\n[model]\nname = \"row\"\n[[coordinate]]\nname = \"x\"\n";
  // A kink prevents derivatives. E619 lists the omitted derivatives only if a goal needs outputs.
  const std::string kinked =
      head + "[energy]\nT = \"dot(x)^2\"\n[[force]]\non = \"x\"\nvalue = \"-sign(dot(x))\"\n";
  CHECK(codes(kinked, {Goal::steps}) == Codes{});
  CHECK(codes(kinked, {Goal::steps, Goal::steps}) == Codes{});
  CHECK(codes(kinked, {Goal::steps, Goal::lower}) == Codes{Code::E619});
  CHECK(codes(kinked, {Goal::lower, Goal::steps}) == Codes{Code::E619});
  // Elimination of M = (0, 1; 1, 0) fails, so outputs that divide by M have no value.
  const std::string crossed =
      head + "[[coordinate]]\nname = \"y\"\n[energy]\nT = \"dot(x)*dot(y)\"\n";
  CHECK(codes(crossed, {Goal::symmetries}) == Codes{});
  CHECK(codes(crossed, {Goal::symmetries, Goal::symmetries}) == Codes{});
  CHECK(codes(crossed, {Goal::base_parameters}) == Codes{Code::E603});  // the model has no bodies
  CHECK(codes(crossed, {Goal::symmetries, Goal::base_parameters}) == Codes{Code::E603});
  CHECK(codes(crossed, {Goal::symmetries, Goal::steps}) == Codes{Code::E501});
  CHECK(codes(crossed, {Goal::lower, Goal::symmetries}) == Codes{Code::E501});
}

TEST_CASE("each analysis that does not support constraints refuses them") {
  const std::string slope =
      "format = 1\n[model]\nname = \"slope\"\n[[coordinate]]\nname = \"x\"\n[[coordinate]]\n"
      "name = \"y\"\n[energy]\nT = \"dot(x)^2 + dot(y)^2\"\n[[constraint]]\nname = \"guide\"\n"
      "equation = \"y = x\"\n";
  PipelineOptions options;
  options.goals.clear();
  std::vector<std::string> refused;
  for (const AnalysisRow& row : analysis_table) {
    options.goals.push_back(row.stage);
    if (row.constraint_hint.empty()) continue;
    refused.push_back("`" + std::string(name_of(row.stage)) + "` does not support constraints");
  }
  std::vector<std::string> found;
  for (const Diagnostic& each : run_pipeline(inputs_of(slope), options).diagnostics) {
    if (each.code == Code::E539) found.push_back(each.message);
  }
  CHECK(found == refused);
  CHECK(refused.size() == 3);
}

TEST_CASE("a stage needed by two goals runs once") {
  const Products products =
      run_pipeline(model("cart_pole"), {.goals = {Goal::emit, Goal::choose, Goal::steps}});
  CHECK(products.files.has_value());
  CHECK(products.steps.has_value());
  std::vector<std::string> run = stages(products);
  std::sort(run.begin(), run.end());
  CHECK(std::adjacent_find(run.begin(), run.end()) == run.end());
}

TEST_CASE("a single output is derived from the checked model") {
  const Products products = run_pipeline(model("cart_pole"), {});
  std::vector<std::string> run;
  for (const StageTime& time : output_stage_times(*products.checked, 1, {}))
    run.push_back(time.stage);
  CHECK(run == std::vector<std::string>{"formulate", "specialise", "derive", "lower", "cancel",
                                        "present", "choose"});
}

TEST_CASE("each stage is announced before it runs, and equations and programs are dumped") {
  for (const std::string_view name : stage_names) {
    PipelineOptions options;
    options.dump = find_stage(name);
    options.goals = {*options.dump};
    std::string last;
    options.on_stage = [&](const std::string& stage) { last = stage; };
    const Products products = run_pipeline(model("cart_pole"), options);
    INFO(name);
    CHECK(last == name);
    const bool has_text = name == "derive" || name == "lower" || name == "cancel";
    CHECK(products.dump.empty() != has_text);
  }
}

TEST_CASE("an error ends the run at its stage") {
  const PipelineSources faulty{make_source("faulty.toml", "format = 2\n"), nullptr};
  const Products products = run_pipeline(faulty, {});
  CHECK(has_errors(products.diagnostics));
  CHECK(stages(products) == std::vector<std::string>{"parse"});
  CHECK_FALSE(products.checked.has_value());
}

TEST_CASE("a limit on derived nodes reaches the stages that derive") {
  PipelineOptions options;
  options.limits.derived_nodes = 3;
  const Products products = run_pipeline(model("cart_pole"), options);
  REQUIRE(products.diagnostics.size() == 1);
  CHECK(products.diagnostics.front().code == Code::E908);
  CHECK_FALSE(products.files.has_value());
}

}  // namespace elgen::test
