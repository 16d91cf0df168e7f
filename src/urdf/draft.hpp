// Draft: a model file before it is spelled, in the order of its text. Values are expressions of the
// model language, or the digits of numbers; "0" is what is not there.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "urdf/tree.hpp"

namespace elgen::urdf {

using Components = std::array<std::string, 3>;

struct CoordinateDraft {
  std::string name = {};
  std::string unit = {};  ///< empty for a rotation
  std::string doc = {};
  std::string low = {};  ///< range, as TOML values
  std::string high = {};
  std::string rate = {};  ///< greatest rate
  bool wraps = false;
};

struct ParameterDraft {
  std::string name = {};
  std::string value = {};
  std::string unit = {};
  std::string more = {};  ///< `key = value, …`
};

/// The parameters of one link and of the joint that carries it.
struct ParameterGroup {
  std::string title = {};
  std::vector<ParameterDraft> parameters = {};
};

struct AxisAngle {
  Components axis = {};  ///< "x", "y" or "z" and nothing else, or three numbers
  std::string angle = {};
};

struct FrameDraft {
  std::vector<std::string> comments = {};
  std::string name = {};
  std::string parent = {};
  Components translate = {"0", "0", "0"};
  std::vector<AxisAngle> rotate = {};
  std::string rotation = {};  ///< a coordinate of kind rotation
};

struct BodyDraft {
  std::vector<std::string> comments = {};
  std::string name = {};
  std::string frame = {};
  std::string mass = {};
  Components com = {"0", "0", "0"};
  std::vector<std::string> inertia = {};  ///< three, or six, or none
};

/// A link: the frames between it and its parent, the last of which has its name.
struct LinkDraft {
  std::vector<FrameDraft> frames = {};
  std::vector<BodyDraft> bodies = {};  ///< at most one
};

struct InputDraft {
  std::string name = {};
  std::string unit = {};
  std::string on = {};
  std::string limit = {};
  std::string doc = {};
};

struct ForceDraft {
  std::string on = {};
  std::string value = {};
};

/// A line of the tree in the head of the file.
struct TreeLine {
  std::size_t depth = 0;
  std::string link = {};
  std::string joint = {};
};

struct Draft {
  std::string name = {};
  std::string title = {};
  std::string file = {};
  std::vector<TreeLine> tree = {};
  std::vector<std::string> renamed = {};
  std::vector<CoordinateDraft> coordinates = {};
  std::vector<ParameterGroup> parameters = {};
  std::vector<LinkDraft> links = {};
  std::vector<std::string> dissipation = {};  ///< terms of D
  std::vector<InputDraft> inputs = {};
  std::vector<ForceDraft> forces = {};
};

/// The model of a robot without errors.
[[nodiscard]] Draft make_draft(const Robot& robot, const LinkTree& tree);

/// The text of the model file.
[[nodiscard]] std::string print(const Draft& draft);

}  // namespace elgen::urdf
