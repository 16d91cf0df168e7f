# SPDX-License-Identifier: 0BSD
# For each check: the row of the seed with the worst result, plus the number of seeds and of all states.
map({model, scene, seed} + .checks[])
| group_by([.model, .scene, .check, .subject])
| map(max_by([.verdict == "fails", .loss // 0])
      + {seeds: length, samples: (map(.samples) | add)})
