// Draws states and compares shown equations.
#include "random/trial.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "random/draw.hpp"
#include "support/shell.hpp"

namespace elgen::test::random {

namespace {

/// Shown equations are exact. Half of the 80 digits are reserved for cancellation.
const Number shown_tolerance("1e-40");

State drawn_state(const System& system, const Layout& layout, Draw& draw) {
  State state;
  for (const Layout::Place& place : layout.places) {
    Vector q;
    Number norm = 0;
    for (std::size_t i = 0; i < (place.is_rotation ? 4U : 1U); ++i) {
      const Number x = draw.dyadic(1);
      q.emplace_back(x);
      norm += x * x;
    }
    for (Jet& entry : q) {
      state.q.push_back(place.is_rotation ? Jet(entry.value() / sqrt(norm)) : entry);
    }
    for (std::size_t i = 0; i < (place.is_rotation ? 3U : 1U); ++i) {
      state.v.emplace_back(draw.dyadic(2));
      state.a.emplace_back(draw.dyadic(2));
    }
  }
  for (std::size_t k = 0; k < system.model.inputs.size(); ++k) state.u.emplace_back(draw.dyadic(3));
  state.t = draw.dyadic(2);
  return state;
}

/// Values between 3/10 and 2 for parameters that are not fixed; models only need positive values.
ParameterValues drawn_parameters(const System& system, Draw& draw) {
  ParameterValues values = given_parameters(system);
  if (system.scene.fixes_all) return values;
  for (auto& [key, value] : values) {
    bool fixed = false;
    for (const Named& named : system.scene.fixed) fixed = fixed || named.name == key.first;
    if (!fixed) value = Number(3) / 10 + abs(draw.dyadic(1)) * 17 / 10;
  }
  return values;
}

std::string first_lines(const std::string& text, int count) {
  std::istringstream lines(text);
  std::string result;
  std::string line;
  for (int i = 0; i < count && std::getline(lines, line); ++i) result += line + "\n";
  return result;
}

/// The exit code and error codes. Two failures with the same codes count as the same failure.
std::string codes_of(const test::Outcome& outcome) {
  std::string codes = "exit " + std::to_string(outcome.status);
  for (std::size_t at = outcome.errors.find("error[E"); at != std::string::npos;
       at = outcome.errors.find("error[E", at + 1)) {
    const std::string code = outcome.errors.substr(at + 6, 4);
    if (!mentions(codes, code)) codes += " " + code;
  }
  return codes;
}

std::string disagreement(const std::string& output, std::size_t entry, const Number& shown,
                         const Number& truth) {
  return output + " entry " + std::to_string(entry) + ": shown " + shown.str(30) + ", true " +
         truth.str(30) + "\n";
}

void compare_output(const std::string& output, const std::vector<ScaledValue>& shown,
                    const std::vector<Number>& truth, std::vector<Finding>& findings) {
  if (shown.size() != truth.size()) {
    findings.push_back({"shown " + output, "has " + std::to_string(shown.size()) +
                                               " entries, not " + std::to_string(truth.size()) +
                                               "\n"});
    return;
  }
  std::string text;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Number scale = 1 + shown[i].size + abs(truth[i]);
    if (!(abs(shown[i].value - truth[i]) <= shown_tolerance * scale)) {
      text += disagreement(output, i, shown[i].value, truth[i]);
    }
  }
  if (!text.empty()) findings.push_back({"shown " + output, text});
}

}  // namespace

std::string input_file(const System& system) {
  return system.model.name + (system.scene.is_present ? ".scene.toml" : ".toml");
}

void write_files(const System& system, const std::filesystem::path& folder,
                 const std::vector<Claim>& claims) {
  test::write_text(folder / (system.model.name + ".toml"), text_of(system.model, claims));
  if (system.scene.is_present) {
    test::write_text(folder / input_file(system), text_of(system.scene, system.model));
  }
}

Trial make_trial(const System& system, std::uint64_t seed) {
  Trial trial{.system = system,
              .seed = seed,
              .layout = {},
              .state = {},
              .given = {},
              .drawn = {},
              .names = {}};
  Draw draw(seed + 1000003, false);
  const Layout layout = layout_of(system.model, system.scene.locks);
  trial.layout = layout;
  trial.state = drawn_state(system, layout, draw);
  const std::vector<std::size_t> acting = acting_inputs(system);
  for (std::size_t k = 0; k < trial.state.u.size(); ++k) {
    if (std::ranges::count(acting, k) == 0) trial.state.u[k] = 0;
  }
  const ParameterValues parameters = drawn_parameters(system, draw);
  trial.drawn = Truth(trial.system, parameters, trial.state).outputs();
  trial.given = Truth(trial.system, given_parameters(system), trial.state).outputs();
  trial.names = names_of(system, layout, trial.state, parameters);
  return trial;
}

std::vector<Finding> compare_shown(Trial& trial, const std::filesystem::path& folder) {
  write_files(trial.system, folder);
  const std::string command =
      "timeout 120 elgen generate -q --force -o out " + input_file(trial.system);
  const test::Outcome outcome = test::shell(command, folder);
  if (outcome.status != 0) {
    return {{"generate " + codes_of(outcome), first_lines(outcome.errors, 25)}};
  }
  std::vector<Finding> findings;
  const std::string base = base_name(trial.system);
  const auto json = test::read_text(folder / "out" / base / (base + ".equations.json"));
  try {
    const Shown shown = read_equations(json, trial.names);
    for (const auto& [output, of_output] : shown) {
      const auto truth = trial.drawn.find(output);
      if (truth == trial.drawn.end()) continue;
      compare_output(output, of_output.entries, truth->second, findings);
    }
    const Names given =
        names_of(trial.system, trial.layout, trial.state, given_parameters(trial.system));
    trial.shown = read_equations(json, given);
  } catch (const std::exception& error) {
    findings.push_back({"shown cannot be read", std::string(error.what()) + "\n"});
  }
  return findings;
}

}  // namespace elgen::test::random
