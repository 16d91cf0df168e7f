// sine_calls: which sines and cosines of a Function compiled code computes together.
//
//     1 = sin 0; 3 = cos 2; 5 = add 1 3; 6 = sin 5      group {1, 3}; 6 is alone
//     1 = sin 0; 2 = cos 0; 3 = multiply 1 2            pair 1, 2
#pragma once

#include <cstdint>
#include <vector>

#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// Calls of sin and cos that do not depend on each other, with at least two different angles. Calls
/// with the same angle are neighbours. Angles are in the order of evaluation.
using AngleGroup = std::vector<std::uint32_t>;

/// The most angles of a group: compilers limit the number of terms in a pack of parameters, clang++
/// to 256.
inline constexpr std::size_t most_angles_together = 64;

/// Calls with equally deep nesting of sines in their angles, and with equal `is_inner`, are in one
/// group, or in several if they have more than `most_angles_together` angles. Instructions of the
/// loop over columns are in no group.
[[nodiscard]] std::vector<AngleGroup> angle_groups(const Function& function);

/// True if some function has a group.
[[nodiscard]] bool has_angle_groups(const Program& program);

/// True if the instruction `at` is the sine of an angle and the next instruction is the cosine of
/// the same angle. Some languages compute both in one call.
[[nodiscard]] bool starts_sine_cosine_pair(const Function& function, std::size_t at);

/// How a language computes several sines and cosines.
/// `joint`: a single statement computes the sine and the cosine of an angle if both are needed.
/// `grouped`: also, a single statement computes all angles of a group.
enum class SineCosinePairing : std::uint8_t { separate, joint, grouped };

/// The pairing of the scene's language for sines in line.
[[nodiscard]] SineCosinePairing in_line_pairing(const Scene& scene);

/// One per instruction: true for a call of sin or cos that is in no pair and in no group. Empty if
/// there is no such call.
[[nodiscard]] std::vector<bool> lone_sine_calls(const Function& function,
                                                SineCosinePairing pairing);

/// True if some function has a sine or cosine that is computed alone.
[[nodiscard]] bool has_lone_sine_calls(const Program& program, SineCosinePairing pairing);

}  // namespace elgen
