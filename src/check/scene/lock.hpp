// lock: a model with what a scene locks taken out of its coordinates.
#pragma once

#include "elgen/model.hpp"

namespace elgen {

/// The model in which functions of time stand for the locked coordinates, fewer of which are left.
/// The model given is kept as `unlocked`. Without locks it is returned as it is. Closed forms of
/// [[expect]] are those of the whole model and do not carry over.
[[nodiscard]] Model locked(Model model);

}  // namespace elgen
