# Prints the commit, processor and compiler for a table of times. Sourced by run and accuracy; reads $cxx.
machine() {
  printf 'Commit: %s%s. Processor: %s, %s cores.\nCompiler of the timed code: %s.' "$(git rev-parse --short=8 HEAD)" \
    "$(git diff --quiet HEAD -- ../../src ../../include ../../templates || printf ', changed')" \
    "$(awk -F': *' '/^model name/ { print $2; exit }' /proc/cpuinfo)" "$(nproc)" "$("$cxx" --version | head -n 1)"
}
