// fields: structs and plain results, numbers and arrays of one, storage.
#include "emit/text/fields.hpp"

#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole;

TEST_CASE("one unnamed field is no struct") {
  const Program program = cart_pole().program;
  CHECK_FALSE(gives_struct(program.functions[0]));
  CHECK(gives_struct(program.functions[4]));
}

TEST_CASE("an energy is a number, the force of one coordinate an array of one") {
  const Field one{"", 1, 1, {0}};
  CHECK(is_scalar(OutputKind::kinetic_energy, one));
  CHECK(is_scalar(OutputKind::user_value, one));
  CHECK_FALSE(is_scalar(OutputKind::gravity, one));
  CHECK_FALSE(is_scalar(OutputKind::user_jacobian, one));
  const Program program = cart_pole().program;
  CHECK(scalar_fields(program, program.functions[5]) == std::vector<bool>{false, false, true});
}

TEST_CASE("column-major matrices are their transposes, vectors stay") {
  Function function;
  function.fields = {{"A", 2, 3, {1, 2, 3, 4, 5, 6}}, {"b", 3, 1, {7, 8, 9}}};
  CHECK(stored(function, Storage::row_major).fields[0].entries == function.fields[0].entries);
  const Function columns = stored(function, Storage::column_major);
  CHECK(columns.fields[0].entries == std::vector<std::uint32_t>{1, 4, 2, 5, 3, 6});
  CHECK(columns.fields[0].rows == 3);
  CHECK(columns.fields[1].entries == function.fields[1].entries);
  CHECK(columns.fields[1].rows == 3);
}

TEST_CASE("what would not fit a stack is not returned") {
  Function function;
  function.fields = {{"", 64, 64, std::vector<std::uint32_t>(largest_returned, 0)}};
  CHECK(is_returned(function));
  function.fields[0].entries.push_back(0);
  CHECK_FALSE(is_returned(function));
}
