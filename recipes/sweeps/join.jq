# SPDX-License-Identifier: 0BSD
# Of every check the row of the seed at which it is worst, with the number of seeds and the states of all of them.
map({model, scene, seed} + .checks[])
| group_by([.model, .scene, .check, .subject])
| map(max_by([.verdict == "fails", .loss // 0])
      + {seeds: length, samples: (map(.samples) | add)})
