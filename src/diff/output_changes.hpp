// output_changes: also where parameters of the newer version have values.
#pragma once

#include "diff/joint_program.hpp"
#include "elgen/diff.hpp"

namespace elgen {

[[nodiscard]] std::vector<OutputChange> output_changes_at(const Version& before,
                                                          const Version& after,
                                                          const Renames& renames,
                                                          const ParameterValues& values);

}  // namespace elgen
