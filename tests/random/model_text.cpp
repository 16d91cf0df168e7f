// Writes a random model and its scene as files in elgen's language.
#include "random/model.hpp"

namespace elgen::test::random {

namespace {

std::string quoted(const std::string& text) { return "\"" + text + "\""; }
std::string quoted(const Expression& expression) { return quoted(printed(expression)); }

std::string list_of(const std::vector<Expression>& expressions) {
  std::string text = "[";
  for (std::size_t i = 0; i < expressions.size(); ++i) {
    text += (i > 0 ? ", " : "") + quoted(expressions[i]);
  }
  return text + "]";
}

/// A single expression, or a list of several.
std::string one_or_list(const std::vector<Expression>& expressions) {
  return expressions.size() == 1 ? quoted(expressions[0]) : list_of(expressions);
}

std::string line(const std::string& key, const std::string& value) {
  return key + " = " + value + "\n";
}

std::string optional_line(const std::string& key, const std::string& text) {
  return text.empty() ? "" : line(key, quoted(text));
}

std::string optional_line(const std::string& key, const Expression& value) {
  return value ? line(key, quoted(value)) : "";
}

std::string optional_line(const std::string& key, const std::vector<Expression>& values) {
  return values.empty() ? "" : line(key, list_of(values));
}

std::string entry_head(const std::string& table, const std::string& name, int repeat = 0) {
  std::string text = "\n[[" + table + "]]\n";
  if (repeat > 0) text += line("for", quoted("i in 1.." + std::to_string(repeat)));
  return text + line("name", quoted(repeat > 0 ? name + "[i]" : name));
}

std::string text_of(const Coordinate& coordinate) {
  std::string text = entry_head("coordinate", coordinate.name, coordinate.repeat);
  if (coordinate.is_rotation) text += line("kind", quoted("rotation"));
  return text + optional_line("armature", coordinate.armature);
}

std::string text_of(const Parameter& parameter) {
  if (!parameter.is_array) return line(parameter.name, quoted(parameter.values[0]));
  return line(parameter.name, "{ size = " + quoted(std::to_string(parameter.values.size())) +
                                  ", value = " + list_of(parameter.values) + " }");
}

std::string text_of(const AxisTurn& turn) {
  const std::string axis =
      turn.axis.empty() ? quoted(std::string(1, "xyz"[turn.letter])) : list_of(turn.axis);
  return "[" + axis + ", " + quoted(turn.angle) + "]";
}

std::string text_of_dh(const Frame& frame) {
  const char* const keys[] = {"a", "alpha", "d", "theta"};
  std::string text = "{ convention = ";
  text += quoted(std::string(frame.turn == Turn::dh_standard ? "standard" : "modified"));
  for (std::size_t i = 0; i < 4; ++i) {
    text += std::string(", ") + keys[i] + " = " + quoted(frame.numbers[i]);
  }
  return line("dh", text + " }");
}

std::string text_of_turn(const Frame& frame) {
  switch (frame.turn) {
    case Turn::none:
      return "";
    case Turn::rotate: {
      std::string turns;
      for (const AxisTurn& turn : frame.turns) turns += (turns.empty() ? "" : ", ") + text_of(turn);
      return line("rotate", "[" + turns + "]");
    }
    case Turn::rpy:
      return line("rpy", list_of(frame.numbers));
    case Turn::quaternion:
      return line("quaternion", list_of(frame.numbers));
    case Turn::rotation:
      return line("rotation", quoted(frame.rotation));
    default:
      return text_of_dh(frame);
  }
}

std::string text_of(const Frame& frame) {
  return entry_head("frame", frame.name) + line("parent", quoted(frame.parent)) +
         optional_line("translate", frame.translate) + text_of_turn(frame);
}

std::string text_of(const Point& point) {
  return entry_head("point", point.name, point.repeat) + optional_line("frame", point.frame) +
         line("at", list_of(point.at)) + optional_line("mass", point.mass);
}

std::string text_of(const Body& body) {
  std::string text = entry_head("body", body.name) + optional_line("frame", body.frame) +
                     optional_line("mass", body.mass) + optional_line("com", body.com);
  if (!body.inertia.empty()) text += line("inertia", one_or_list(body.inertia));
  if (!body.spin.empty()) text += line("spin", one_or_list(body.spin));
  if (body.is_about_origin) text += line("inertia_about", quoted("origin"));
  return text;
}

std::string text_of(const Input& input) {
  return entry_head("input", input.name) + optional_line("on", input.on);
}

std::string text_of(const Force& force) {
  std::string text = "\n[[force]]\n";
  if (force.repeat > 0) text += line("for", quoted("i in 1.." + std::to_string(force.repeat)));
  return text + optional_line("on", force.on) + optional_line("at", force.at) +
         optional_line("frame", force.frame) + optional_line("from", force.from) +
         optional_line("in", force.in) + line("value", one_or_list(force.value));
}

std::string text_of(const Output& output) {
  std::string text = entry_head("output", output.name);
  if (!output.value.empty()) text += line("value", one_or_list(output.value));
  text += optional_line("frame", output.frame);
  if (!output.frame.empty()) {
    text += line("axes", quoted(output.in_frame_axes ? output.frame : "world"));
  }
  return text + (output.has_jacobian ? line("jacobian", "true") : "");
}

std::string text_of(const Claim& claim) {
  if (claim.rows.size() == 1 && claim.rows[0].size() == 1 && claim.output.ends_with("energy")) {
    return line(claim.output, quoted(claim.rows[0][0]));
  }
  std::string text;
  for (const auto& row : claim.rows) {
    text += (text.empty() ? "" : ", ");
    text += claim.output == "mass_matrix" ? list_of(row) : quoted(row[0]);
  }
  return line(claim.output, "[" + text + "]");
}

std::string text_of(const std::vector<Named>& entries, const std::string& head) {
  std::string text = entries.empty() ? "" : head;
  for (const Named& entry : entries) text += line(entry.name, quoted(entry.value));
  return text;
}

std::string text_of_energies(const Model& model) {
  const std::string text = optional_line("T", model.T) + optional_line("V", model.V) +
                           optional_line("D", model.D) + optional_line("L", model.L);
  return text.empty() ? "" : "\n[energy]\n" + text;
}

std::string table_of(const std::vector<Named>& entries) {
  std::string text;
  for (const Named& entry : entries) {
    text += (text.empty() ? " " : ", ") + entry.name + " = " + quoted(entry.value);
  }
  return "{" + text + " }";
}

std::string text_of(const Lock& lock) {
  return line(quoted(lock.coordinate), "{ value = " + one_or_list(lock.value) +
                                           (lock.has_reaction ? ", reaction = true }" : " }"));
}

template <class Entries>
std::string text_of_all(const Entries& entries) {
  std::string text;
  for (const auto& entry : entries) text += text_of(entry);
  return text;
}

}  // namespace

std::string text_of(const Model& model, const std::vector<Claim>& claims) {
  std::string text = "format = 1\n\n[model]\n" + line("name", quoted(model.name));
  text += text_of_all(model.coordinates);
  if (!model.parameters.empty()) text += "\n[parameters]\n" + text_of_all(model.parameters);
  text += text_of(model.definitions, "\n[define]\n");
  for (const Named& function : model.prescribed) {
    text += entry_head("prescribed", function.name) + line("value", quoted(function.value));
  }
  text += text_of_all(model.frames) + text_of_all(model.points) + text_of_all(model.bodies);
  if (!model.gravity.empty()) text += "\n[gravity]\n" + line("vector", list_of(model.gravity));
  text += text_of_energies(model) + text_of_all(model.inputs) + text_of_all(model.forces) +
          text_of_all(model.outputs);
  if (!claims.empty()) text += "\n[[expect]]\n" + text_of_all(claims);
  return text;
}

std::string text_of(const Scene& scene, const Model& model) {
  std::string text = "format = 1\n" + line("model", quoted(model.name + ".toml")) +
                     line("name", quoted(std::string("scene")));
  if (scene.fixes_all || !scene.fixed.empty()) {
    text += "\n[parameters]\nfixed = ";
    text += (scene.fixes_all ? quoted(std::string("all")) : table_of(scene.fixed)) + "\n";
  }
  if (!scene.locks.empty()) text += "\n[lock]\n" + text_of_all(scene.locks);
  if (scene.order > 0) {
    text += "\n[approximate]\n" + line("order", std::to_string(scene.order)) +
            line("about", table_of(scene.about));
  }
  text += "\n[numeric]\n";
  text += line("scalar", scene.is_float ? "[\"float\"]" : "[\"double\"]");
  if (scene.has_lone_sines)
    text +=
        line("trigonometry", scene.is_float ? "{ max_error = 2.2e-7 }" : "{ max_error = 4e-16 }");
  text += optional_line("form", scene.form) + "\n[emit]\n";
  text += line("language", quoted(std::string(scene.is_c99 ? "c99" : "c++17")));
  if (scene.has_eigen) text += line("eigen", "true");
  if (scene.is_column_major) text += line("storage", quoted(std::string("column-major")));
  return text;
}

std::string base_name(const System& system) {
  return system.model.name + (system.scene.is_present ? "_scene" : "");
}

}  // namespace elgen::test::random
