# Reads data of emitted headers below $scratch, and prints progress. Sourced by run and before.
say() {
  printf '== %s\n' "$*" >&2
}

header_of() {
  find "$scratch/$1" -name '*.hpp'
}

# The rows of the table in a header, as FUNCTION(name, additions, …). Functions so large that they write into their
# first argument are omitted.
functions_of() {
  awk 'NR == FNR { if ($1 == "ELGEN_FUNCTION" && $2 == "void") { sub(/\(.*/, "", $3); into_argument[$3] } next }
       /^\/\/   function / { inside = 1; next }
       /^\/\/$/ { inside = 0 }
       inside && !($2 in into_argument) {
         printf "FUNCTION(%s, %s, %s, %s, %s, %s, %s)\n", $2, $3, $4, $5, $6, $7, $8
       }' "$1" "$1"
}

# definitions LABEL: the macros for outputs.cpp and every_function.cpp.
definitions() {
  local header
  header=$(header_of "$1")
  functions_of "$header" >"$scratch/$1.functions"
  printf -- '-DMODEL=%s -DHEADER="%s" -DFUNCTIONS="%s"' "$(basename "$header" .hpp)" "$header" \
    "$scratch/$1.functions"
}
