// Requests for more digits add up in nested computations.
#include "numbers/more_digits.hpp"

#include <catch2/catch.hpp>
#include <vector>

using namespace elgen;

TEST_CASE("nested requests for digits add up") {
  CHECK(ExtraDigits::requested_digits() == 0);
  const auto count = [] { return ExtraDigits::requested_digits(); };
  CHECK(with_digits(10, [&] { return with_digits(64, count); }) == 74);
  CHECK(ExtraDigits::requested_digits() == 0);
}

TEST_CASE("a computation that loses too many digits is repeated with more digits") {
  std::vector<unsigned> counts;
  const auto losing = [&](const std::vector<unsigned>& losses) {
    counts.clear();
    return with_enough_digits([&] {
      counts.push_back(ExtraDigits::requested_digits());
      for (const unsigned digits : losses) ExtraDigits::report_lost(digits);
      return counts.size();
    });
  };
  CHECK(losing({10}) == 1);
  CHECK(counts == std::vector<unsigned>{0});
  CHECK(losing({100, 20}) == 2);
  CHECK(counts == std::vector<unsigned>{0, 100});
  CHECK(ExtraDigits::requested_digits() == 0);
}

TEST_CASE("a repeated computation may lose a few more digits") {
  int computations = 0;
  const auto compute = [&] {
    ++computations;
    ExtraDigits::report_lost(computations == 1 ? 100 : 105);
    return computations;
  };
  CHECK(with_enough_digits(compute) == 2);
}
