// One of the two headers that before.cpp compares. The namespace of the header is renamed to SIDE,
// so that the linker keeps the functions of both headers. MODEL, HEADER and FUNCTIONS as in
// outputs.cpp.
#include "side.hpp"

#include "repeated.hpp"

namespace {

template <class Function>
bench::Timed timed(const char* name, const std::vector<int>& operations, Function function) {
  using Result = decltype(compiled::call(function, some_states<double>().front()));
  bool has_operations = false;
  for (const int count : operations) has_operations = has_operations || count > 0;
  return {name, sizeof(Result), has_operations, repeated<double>(function)};
}

}  // namespace

std::vector<bench::Timed> bench::SIDE() {
  std::vector<Timed> result;
#define FUNCTION(name, ...) \
  result.push_back(timed(   \
      #name, {__VA_ARGS__}, \
      [](const auto&... x) -> decltype(emitted::name(x...)) { return emitted::name(x...); }));
#include FUNCTIONS
#undef FUNCTION
  return result;
}
