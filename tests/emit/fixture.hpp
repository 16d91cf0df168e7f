// A cart and pole built by hand: a Model, a Scene, and a Program that is read from text.
#pragma once

#include <cln/rational.h>
#include <cln/real.h>

#include <catch2/catch.hpp>
#include <string>

#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"
#include "numbers/exact_number.hpp"
#include "program/read_program.hpp"
#include "support/text.hpp"

namespace elgen::test {

struct Subject {
  Model model;
  Scene scene;
  Program program;
};

inline void add_parameter(Model& model, const std::string& name, const cln::cl_R& value,
                          const std::string& unit) {
  const auto index = static_cast<std::uint32_t>(model.parameters.size());
  const auto array = static_cast<std::uint32_t>(model.parameter_arrays.size());
  model.parameters.push_back({name, name, array, 0, value, Assumption::none, find_unit(unit)});
  ParameterArray declared;
  declared.name = name;
  declared.first = index;
  declared.unit_text = unit;
  model.parameter_arrays.push_back(declared);
}

/// Adds the parameter array `name`; an array "l" has the elements "l[1]", "l[2]", ….
inline void add_parameter_array(Model& model, const std::string& name,
                                const std::vector<cln::cl_R>& values) {
  ParameterArray declared;
  declared.name = name;
  declared.first = static_cast<std::uint32_t>(model.parameters.size());
  declared.count = static_cast<std::uint32_t>(values.size());
  declared.is_array = true;
  const auto array = static_cast<std::uint32_t>(model.parameter_arrays.size());
  for (std::uint32_t i = 0; i < declared.count; ++i) {
    const std::string element = name + "[" + std::to_string(i + 1) + "]";
    model.parameters.push_back(
        {element, name + "_" + std::to_string(i + 1), array, i, values[i], Assumption::none, {}});
  }
  model.parameter_arrays.push_back(declared);
}

/// Makes the first function read the parameter `leaf`, so that the parameter is emitted.
inline void read_parameter(Subject& subject, const std::string& leaf) {
  std::vector<std::string>& leaves = subject.program.leaves.parameters;
  const auto index = static_cast<std::uint32_t>(leaves.size());
  leaves.push_back(leaf);
  subject.program.functions.front().instructions.push_back(
      {Opcode::parameter, FunctionId::sin, index, 0});
  subject.program.functions.front().names.emplace_back();
}

/// Makes the first function load `constant`, so that the constant is emitted.
inline void load_constant(Subject& subject, const Constant& constant) {
  const std::uint32_t index = intern_constant(constant, subject.program.constants);
  subject.program.functions.front().instructions.push_back(
      {Opcode::constant, FunctionId::sin, index, 0});
  subject.program.functions.front().names.emplace_back();
}

inline void add_coordinate(Model& model, const std::string& name, const std::string& unit) {
  Coordinate coordinate;
  coordinate.name = name;
  coordinate.identifier = name;
  coordinate.unit = find_unit(unit);
  coordinate.unit_text = unit;
  append_coordinate(model, coordinate);
}

inline Model cart_pole_model() {
  Model model;
  model.source = make_source("/somewhere/models/cart_pole.toml", "");
  model.name = "cart_pole";
  model.title = "Cart and pole with a force on the cart";
  add_coordinate(model, "x", "m");
  add_coordinate(model, "theta", "rad");
  model.coordinates[0].range = Interval{-2, 2};
  add_parameter(model, "M", 1, "kg");
  add_parameter(model, "m", cln::cl_RA(1) / 10, "kg");
  add_parameter(model, "l", cln::cl_RA(1) / 2, "m");
  add_parameter(model, "g", cln::cl_RA(980665) / 100000, "m/s^2");
  model.parameter_arrays[0].doc = "cart mass";
  Input input;
  input.name = "u";
  input.identifier = "u";
  input.velocity = 0;
  input.unit = find_unit("N");
  input.unit_text = "N";
  input.limits = Interval{-20, 20};
  model.inputs.push_back(input);
  return model;
}

inline Subject cart_pole() {
  Subject subject;
  subject.model = cart_pole_model();
  subject.scene.base_name = "cart_pole";
  subject.scene.paths.model = "cart_pole.toml";
  subject.program = read_program(read_text(ELGEN_SOURCE_DIR "/tests/models/cart_pole.program"));
  return subject;
}

inline Subject cart_pole_in_c(ScalarKind scalar = ScalarKind::double_precision) {
  Subject subject = cart_pole();
  subject.scene.emission.language = LanguageId::c99;
  subject.scene.numerics.scalars = {scalar};
  return subject;
}

}  // namespace elgen::test
