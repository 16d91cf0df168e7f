# SPDX-License-Identifier: GPL-3.0-or-later
# Counts checks and reports their costs; sourced by .ci/run.
#
#   check NAME COMMAND…    runs the command and counts it as passed or failed
#   count_tests COMMAND…   runs a ctest command that logs to $tests_log, and counts its tests
#   conclude               prints the longest checks, the failures, and `N passed, N failed`; returns 1 if any failed

# The time limit of CI.
allowed_seconds=5400

passed=0
failed=0
failures=()
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
tests_log=$scratch/tests.log
touch "$scratch/costs" "$tests_log"

fail() {
  failed=$((failed + 1))
  failures+=("$1")
}

# Sets `processor_seconds` to the user and system time of all finished commands. `times` writes to a file, because in
# a command substitution it would report the times of the subshell.
measure_processor() {
  times >"$scratch/times"
  processor_seconds=$(awk -F '[ms ]+' 'NR == 2 { printf "%d", 60 * $1 + $2 + 60 * $3 + $4 }' "$scratch/times")
}

# measured NAME COMMAND…: runs the command and prints its wall time, its processor time and the remaining time.
measured() {
  local name=$1 start=$SECONDS status=0 before seconds
  shift
  measure_processor
  before=$processor_seconds
  printf '\n== %s\n' "$name"
  "$@" || status=$?
  measure_processor
  seconds=$((SECONDS - start))
  printf '%d\t%d\t%s\n' "$seconds" $((processor_seconds - before)) "$name" >>"$scratch/costs"
  printf '== %s: %s in %d s, %d s of processors; %d s of %d are left\n' "$name" \
    "$([ "$status" -eq 0 ] && echo passed || echo FAILED)" "$seconds" $((processor_seconds - before)) \
    $((allowed_seconds - SECONDS)) "$allowed_seconds"
  return "$status"
}

check() {
  if measured "$@"; then
    passed=$((passed + 1))
  else
    fail "$1"
  fi
}

# A command that ends without a summary of tests counts as a failure.
count_tests() {
  measured tests "$@"
  local summary
  summary=$(grep -E '^[0-9]+% tests passed, [0-9]+ tests failed out of [0-9]+' "$tests_log")
  if [[ $summary =~ ,\ ([0-9]+)\ tests\ failed\ out\ of\ ([1-9][0-9]*) ]]; then
    failed=$((failed + BASH_REMATCH[1]))
    passed=$((passed + BASH_REMATCH[2] - BASH_REMATCH[1]))
    mapfile -t -O "${#failures[@]}" failures < <(sed -n '/^The following tests FAILED:/,$s/^\t *[0-9]* - //p' "$tests_log")
  else
    fail tests
  fi
}

# ctest reports only the wall time of a test.
longest() {
  printf '\nlongest checks (s, s of processors) and tests (s):\n'
  sort -rn "$scratch/costs" | head -n 10 | awk -F '\t' '{ printf "%8d %8d  %s\n", $1, $2, $3 }'
  sed -En 's/^ *[0-9]+\/[0-9]+ Test +#[0-9]+: (.*[^.]) \.+.* ([0-9.]+) sec.*$/\2\t\1/p' "$tests_log" |
    sort -rn | head -n 10 | awk -F '\t' '{ printf "%8d %8s  %s\n", $1, "", $2 }'
}

# Failures are printed last, so that a truncated log still lists them.
conclude() {
  longest
  [ "$failed" -eq 0 ] || printf '\nfailed: %s' "${failures[@]}"
  printf '\n%d passed, %d failed\n' "$passed" "$failed"
  [ "$failed" -eq 0 ]
}
