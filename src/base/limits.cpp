// limits: the table behind --limits and --limit NAME=VALUE.
#include "elgen/limits.hpp"

namespace elgen {

const std::vector<LimitRow>& limit_table() {
  static const std::vector<LimitRow> table{
      {"file_bytes", &Limits::file_bytes, "bytes", "size of an input file"},
      {"expression_depth", &Limits::expression_depth, "levels", "nesting of one expression"},
      {"literal_digits", &Limits::literal_digits, "digits", "digits of one number"},
      {"decimal_exponent", &Limits::decimal_exponent, "", "largest N of a number like 1eN"},
      {"integer_power", &Limits::integer_power, "", "largest N of a power like x^N"},
      {"coordinates", &Limits::coordinates, "", "coordinates after repetition"},
      {"definitions", &Limits::definitions, "", "definitions, points, bodies after repetition"},
      {"derived_nodes", &Limits::derived_nodes, "nodes", "size of the derived expressions"},
      {"seconds", &Limits::seconds, "s", "processor time for one input"},
      {"boxes", &Limits::boxes, "boxes", "boxes in the search for equilibria"},
      {"enclosures", &Limits::enclosures, "", "interval operations in this search, 7e6 per second"},
      {"memory_mib", &Limits::memory_mib, "MiB", "memory"},
      {"page_bytes", &Limits::page_bytes, "bytes", "size of an animated page"},
  };
  return table;
}

}  // namespace elgen
