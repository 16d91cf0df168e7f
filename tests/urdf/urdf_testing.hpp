// Helpers for the tests of urdf: small robots, and the messages about them as lines of text.
#pragma once

#include <string>

#include "elgen/urdf.hpp"
#include "urdf/tree.hpp"

namespace elgen::test {

/// One line per diagnostic: "E804 3:7 `1,5` is not a decimal number | hint".
[[nodiscard]] std::string messages(const Diagnostics& diagnostics);

/// The messages of importing `text`.
[[nodiscard]] std::string import_messages(const std::string& text,
                                          const ImportOptions& options = {});

/// The imported model. Throws if there are errors.
[[nodiscard]] std::string imported(const std::string& text, const ImportOptions& options = {});

/// `<robot name="r">`, a link `base`, a link `arm` of mass 1 on line 3, and `rest` from line 4 on.
[[nodiscard]] std::string with_arm(const std::string& rest);

/// with_arm() and the joint `j` from base to arm, with this type and with `elements` on line 5.
[[nodiscard]] std::string arm_on(const std::string& type, const std::string& elements);

/// A joint `ab` from a to b, on a line of its own.
[[nodiscard]] std::string joint(const std::string& name, const std::string& type = "revolute",
                                const std::string& inside = "");

/// The XML and the robot of `text`, and the tree of `robot`. Each function throws if there are
/// errors. The source exists until the process ends.
[[nodiscard]] urdf::Element xml_of(const std::string& text);
[[nodiscard]] urdf::Robot robot_of(const std::string& text);
[[nodiscard]] urdf::LinkTree tree_of(const urdf::Robot& robot);

/// The messages of read_robot().
[[nodiscard]] std::string reading_messages(const std::string& text);

/// The rest of the line after `start`.
[[nodiscard]] std::string after(const std::string& text, const std::string& start);

}  // namespace elgen::test
