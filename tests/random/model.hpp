// The entries of a random model and of its scene, as in their files, and the text of the files.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "random/expression.hpp"

namespace elgen::test::random {

struct Coordinate {
  std::string name;
  bool is_rotation = false;
  int repeat = 0;  ///< > 0: NAME[1] … NAME[repeat]
  Expression armature = {};
};

struct Parameter {
  std::string name;
  std::vector<Expression> values;  ///< one, or one per element
  bool is_array = false;
};

struct Named {
  std::string name;
  Expression value;
};

enum class Turn { none, rotate, rpy, dh_standard, dh_modified, quaternion, rotation };

/// One rotation of `rotate` about a constant axis, which is given by components or by a letter.
struct AxisTurn {
  int letter = 0;                     ///< 0, 1, 2: "x", "y", "z"; ignored if `axis` is given
  std::vector<Expression> axis = {};  ///< empty, or three components
  Expression angle = {};
};

struct Frame {
  std::string name;
  std::string parent;
  std::vector<Expression> translate = {};
  Turn turn = Turn::none;
  std::vector<AxisTurn> turns = {};
  std::vector<Expression> numbers = {};  ///< rpy, (a, alpha, d, theta) or a quaternion
  std::string rotation = {};             ///< the name of a rotation coordinate
};

struct Point {
  std::string name;
  std::vector<Expression> at;
  Expression mass = {};
  std::string frame = {};
  int repeat = 0;
};

struct Body {
  std::string name;
  Expression mass = {};
  std::vector<Expression> com = {};
  std::vector<Expression> inertia = {};
  std::string frame = {};
  std::vector<Expression> spin = {};
  bool is_about_origin = false;
};

struct Input {
  std::string name;
  std::string on = {};
};

struct Force {
  std::string name;
  std::vector<Expression> value;
  std::string on = {};  ///< a coordinate, or NAME[k]; "NAME[i]" with `repeat`
  std::string at = {};
  std::string frame = {};
  std::string from = {};
  std::string in = {};
  int repeat = 0;
};

struct Output {
  std::string name;
  std::vector<Expression> value = {};
  std::string frame = {};
  bool in_frame_axes = false;
  bool has_jacobian = false;
};

struct Model {
  std::string name;
  std::vector<Coordinate> coordinates = {};
  std::vector<Parameter> parameters = {};
  std::vector<Named> definitions = {};
  std::vector<Named> prescribed = {};
  std::vector<Frame> frames = {};
  std::vector<Point> points = {};
  std::vector<Body> bodies = {};
  std::vector<Expression> gravity = {};
  Expression T = {}, V = {}, D = {}, L = {};
  std::vector<Input> inputs = {};
  std::vector<Force> forces = {};
  std::vector<Output> outputs = {};
};

struct Lock {
  std::string coordinate;         ///< "q1", "r[2]"
  std::vector<Expression> value;  ///< one, or four for a rotation
  bool has_reaction = false;
};

struct Scene {
  bool is_present = false;
  std::vector<Named> fixed = {};
  bool fixes_all = false;
  std::vector<Lock> locks = {};
  int order = 0;                  ///< key of [approximate]; 0 if the scene is exact
  std::vector<Named> about = {};  ///< point of expansion, for the expanded coordinates
  bool is_c99 = false;
  bool has_eigen = false;
  bool is_float = false;
  bool is_column_major = false;
  std::string form = {};  ///< closed, recursive, or empty for the default
  bool has_lone_sines = false;
};

/// A closed form in [[expect]]: an output's name and its entries.
struct Claim {
  std::string output;
  std::vector<std::vector<Expression>> rows;
};

struct System {
  Model model;
  Scene scene;
};

/// The indices of the inputs in the scene. Inputs that act only on locked coordinates are excluded.
[[nodiscard]] std::vector<std::size_t> acting_inputs(const System& system);

[[nodiscard]] std::string text_of(const Model& model, const std::vector<Claim>& claims = {});
[[nodiscard]] std::string text_of(const Scene& scene, const Model& model);

/// The name of the files in the output folder, of the namespace and of the C prefix.
[[nodiscard]] std::string base_name(const System& system);

}  // namespace elgen::test::random
