// Draws models and scenes: every entry of the language for motion, forces and outputs, in unusual
// combinations. Half of the seeds have irrational constants.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "random/draw.hpp"
#include "random/model.hpp"

namespace elgen::test::random {

class Generator {
 public:
  explicit Generator(std::uint64_t seed);

  /// The model and scene of the seed.
  [[nodiscard]] System system();

 private:
  Draw draw_;
  System made_;
  std::vector<Expression> positions_;  ///< names of coordinates, without rotations
  std::vector<Expression> rates_;
  bool has_units_ = false;  ///< true if the model has a rotation: components of a rotation have
                            ///< units, so that elgen checks the units of numbers too

  // generator.cpp
  void add_coordinates(int count);
  Expression parameter();
  Expression any_constant();
  Expression positive_constant();
  void make_energies();
  void make_lagrangian();
  void make_quiet();
  Expression clock();
  Expression without_unit(const Expression& constant) const;
  void leave_units_out();
  Expression squared_sum();
  void add_terms();

  // generate_bodies.cpp
  void make_planar();
  void make_array();
  void make_spatial(bool turns);
  Expression angle();
  std::vector<Expression> offset(int dimension, bool moving);
  void add_frame(const std::string& name, const std::string& parent);
  void turn(Frame& frame);
  void add_body(const std::string& name, const std::string& frame);

  // generate_forces.cpp
  void add_prescribed();
  void add_dissipation();
  void add_inputs();
  void add_forces();
  void add_force(int index);
  void add_outputs();
  Expression force_size();

  // generate_scene.cpp
  void add_scene();
  void add_locks(Scene& scene);
  void add_fixed(Scene& scene);
  void add_emission(Scene& scene);
};

}  // namespace elgen::test::random
