// The header of batches, included after macros that <windows.h> defines.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>

#define near
#define far
#define small char
#define interface struct
#define min(x, y) (((x) < (y)) ? (x) : (y))
#define max(x, y) (((x) > (y)) ? (x) : (y))

#include "panda7_rollouts/panda7_rollouts_batch.hpp"

int main() {
  const float state[7] = {};
  float torques[7];
  panda7_rollouts::batch::inverse_dynamics<float>({}, 1, state, state, state, torques);
  return torques[0] < 1e9F ? 0 : 1;
}
