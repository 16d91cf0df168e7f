// Labels of rows and columns: one per entry and no duplicates, for every output of every model.
#include <catch2/catch.hpp>
#include <filesystem>
#include <set>

#include "model/requests.hpp"
#include "run/values/records.hpp"
#include "support/inputs.hpp"
#include "support/models.hpp"
#include "support/shell.hpp"

namespace elgen::test {

namespace {

/// Checks that extent_size(), extent_lines() and line_at() agree, and that the lines' texts differ.
void check_lines(const Model& model, Extent extent, std::uint32_t user) {
  const std::vector<FieldLine> lines = extent_lines(model, extent, user);
  CHECK(lines.size() == extent_size(model, extent, user));
  CHECK_FALSE(line_at(model, extent, lines.size(), user));
  std::set<std::string> texts;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::optional<FieldLine> line = line_at(model, extent, i, user);
    REQUIRE(line);
    CHECK(line->text() == lines[i].text());
    CHECK(line->unit == lines[i].unit);
    CHECK(texts.insert(lines[i].text()).second);
  }
}

/// Checks labels and values of every output: as many values as labels, no duplicate labels.
void check_labels(const CheckedModel& checked) {
  const ValueTable table = make_value_table(checked, 17);
  const State start = start_state(checked.model, checked.scene);
  for (const ValueFunction& function : table.functions) {
    INFO(function.output.name);
    for (const FieldRow& row : output_row(function.output.kind).fields) {
      check_lines(checked.model, row.rows, function.output.user);
      check_lines(checked.model, row.columns, function.output.user);
    }
    std::size_t size = 0;
    for (const ValueField& field : function.fields) {
      INFO(field.name);
      size += field.rows.size() * field.columns.size();
      for (const std::vector<std::string>& labels : {field.rows, field.columns}) {
        const std::set<std::string> distinct(labels.begin(), labels.end());
        CHECK(distinct.size() == labels.size());
        CHECK((labels.size() == 1 || distinct.count("") == 0));
      }
    }
    const auto values = oracle_values(checked.model, function.output, start);
    if (values) CHECK(values->size() == size);
  }
}

/// The model with all its outputs, including outputs that must be named.
CheckedModel with_all_outputs(const std::string& text, const FileSyntax* scene) {
  SceneOptions options;
  options.purpose = purpose::rest;
  const CheckedModel checked = checked_model(text, scene, options);
  std::string names;
  for (const OutputRow& row : output_table()) {
    for (std::uint32_t user = 0; user < (row.is_user_output ? checked.model.outputs.size() : 1);
         ++user) {
      const OutputRequest request = make_request(checked.model, row.kind, user);
      if (row.is_summary || row.is_step || !is_available(checked.model, request)) continue;
      names += (names.empty() ? "" : ",") + request.name;
    }
  }
  options.outputs = {make_source("command line", names)};
  return checked_model(text, scene, options);
}

std::string text_at_start(const std::string& model, const std::string& output) {
  SceneOptions options;
  options.outputs = {make_source("command line", output)};
  const CheckedModel checked = checked_model(model, options);
  return to_text(*state_values(checked, {}));
}

}  // namespace

TEST_CASE("rows and columns of all outputs of all models and scenes have distinct labels") {
  const std::filesystem::path models = std::string(ELGEN_SOURCE_DIR) + "/models";
  for (const auto& path : files_in(models, ".toml")) {
    INFO(path.filename());
    check_labels(with_all_outputs(read_text(path), nullptr));
  }
  for (const auto& path : files_in(models / "scenes", ".scene.toml")) {
    INFO(path.filename());
    const SourcePointer source = source_of(path);
    const Result<FileSyntax> scene = parse_scene(source, Limits{});
    const std::optional<Span> named = find_model_key(*source);
    REQUIRE((scene && named));
    const std::string quoted(covered_text(*named));
    const std::string model = quoted.substr(1, quoted.size() - 2);
    check_labels(with_all_outputs(read_text(models / "scenes" / model), &*scene));
  }
}

TEST_CASE("rows of an [[output]] have its name, rows of a frame its axes") {
  const std::string arm = model_text("arm", R"toml([[coordinate]]
name = "x"
unit = "m"
[parameters]
m = { value = 1, unit = "kg" }
[[frame]]
name = "hand"
parent = "world"
translate = ["x", 0, 0]
[[body]]
name = "block"
frame = "hand"
mass = "m"
[[output]]
name = "both"
value = ["x", "2*x"]
jacobian = true
[[output]]
name = "alone"
value = "3*x"
jacobian = true
[[output]]
name = "pose"
frame = "hand"
jacobian = true
)toml");
  const Model model = checked_model(arm).model;
  const auto rows_of = [&model](OutputKind kind, std::uint32_t user) {
    std::vector<std::string> names;
    for (const FieldLine& line : extent_lines(model, output_row(kind).fields.front().rows, user)) {
      names.push_back(line.text());
    }
    return names;
  };
  using Names = std::vector<std::string>;
  CHECK(rows_of(OutputKind::user_value, 0) == Names{"both[1]", "both[2]"});
  CHECK(rows_of(OutputKind::user_jacobian, 0) == Names{"both[1]", "both[2]"});
  CHECK(rows_of(OutputKind::user_value, 1) == Names{""});
  CHECK(rows_of(OutputKind::user_jacobian, 1) == Names{""});
  CHECK(rows_of(OutputKind::user_value, 2) == Names{"x", "y", "z"});
  CHECK(rows_of(OutputKind::user_bias, 2) == Names{"wx", "wy", "wz", "vx", "vy", "vz"});
  CHECK(text_at_start(arm, "both,alone") ==
        "arm at x = 0.0\nboth\n  both[1]  0.0\n  both[2]  0.0\nalone = 0.0\n");
  CHECK(mentions(text_at_start(arm, "pose"),
                 "pose\n"
                 "       x    y    z    p\n"
                 "  x  1.0  0.0  0.0  0.0\n"));
}

TEST_CASE("derivatives of motion outputs have no derivatives by acceleration") {
  const std::string sensor = R"toml(format = 1
[model]
name = "accel"
[[coordinate]]
name = "x"
unit = "m"
[parameters]
m = { value = 2, unit = "kg" }
k = { value = 6, unit = "N/m" }
[energy]
T = "1/2*m*dot(x)^2"
V = "1/2*k*x^2"
[[input]]
name = "u"
unit = "N"
on = "x"
[[output]]
name = "sensor"
value = "dot(dot(x))"
motion = true
jacobian = true
)toml";
  const auto text_at_rest = [](const std::string& model) {
    return text_at_start(model, "sensor_derivatives");
  };
  CHECK(text_at_rest(sensor) ==
        "accel at x = 0.0, dot(x) = 0.0, u = 0.0\n"
        "sensor_derivatives.by_position\n       x\n    -3.0\n"
        "sensor_derivatives.by_velocity\n      x\n    0.0\n"
        "sensor_derivatives.by_input\n      u\n    0.5\n");
  // Without `motion = true` the acceleration is an argument.
  const std::string motion = "motion = true\n";
  std::string given = sensor;
  given.erase(given.find(motion), motion.size());
  CHECK(mentions(text_at_rest(given), "sensor_derivatives.by_acceleration\n      x\n    1.0\n"));
}

TEST_CASE("the torque beyond the inputs is a value too") {
  const std::string crank = model_file("slider_crank");
  CHECK(mentions(text_at_start(crank, "constrained_inverse_dynamics"),
                 "constrained_inverse_dynamics.unbalanced\n  a  0.0 N*m\n"));
}

TEST_CASE("the rows of `reaction` are the locked coordinates") {
  const std::string plane = R"toml(format = 1
[model]
name = "plane"
[[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[energy]
T = "dot(x)^2 + dot(y)^2"
V = "x + y"
)toml";
  const CheckedModel held = checked_scene(
      plane, "[outputs]\nreaction = true\n[lock]\ny = { value = 0, reaction = true }\n");
  const ValueTable table = make_value_table(held, 17);
  REQUIRE(table.functions.size() == 1);
  CHECK(table.functions[0].fields[0].rows == std::vector<std::string>{"y"});
}

}  // namespace elgen::test
