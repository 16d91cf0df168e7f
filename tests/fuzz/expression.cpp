// Expressions: a parsed expression can be printed, and parsing the printed text gives the same
// expression.
#include "elgen/syntax.hpp"
#include "fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace elgen;
  const Limits limits = test::small_limits();
  const SourcePointer source = test::source_of(data, size, "expression");
  const auto expression = parse_expression(source, limits);
  test::require_answer(expression);
  if (!expression) return 0;
  const std::string printed = dump(*expression);
  Limits printed_limits = limits;
  printed_limits.expression_depth *= 3;  // printing adds brackets around every operation
  const SourcePointer printed_source = make_source("printed", printed);
  const auto again = parse_expression(printed_source, printed_limits);
  test::require(again && dump(*again) == printed, "printed and read again: " + printed);
  return 0;
}
