// losses CERTIFICATE.json: prints two cells of the table of losses from the output of `elgen verify
// --format json`: the number of losses above `tolerated`, and the largest loss.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>

namespace {

/// A loss up to this factor is explained by the rounding of a few operations.
constexpr double tolerated = 64;

struct Losses {
  std::size_t fields = 0;  ///< losses above `tolerated`; an output has one loss per scalar type
  std::size_t all = 0;
  double worst = 0;
  std::string where = {};
};

Losses losses_in(const char* path) {
  std::ifstream file(path);
  const auto certificate = nlohmann::json::parse(file);
  Losses losses;
  for (const auto& row : certificate.at("checks")) {
    if (row.at("check") != "digits lost" || row.at("samples") == 0) continue;
    ++losses.all;
    const double loss = row.at("loss");
    if (loss <= tolerated) continue;
    ++losses.fields;
    if (loss <= losses.worst) continue;
    losses.worst = loss;
    losses.where = row.at("subject");
  }
  return losses;
}

std::string cells(const Losses& losses) {
  if (losses.fields == 0) return fmt::format("0 of {} | |", losses.all);
  const double lost = std::log10(losses.worst);
  const std::string digits =
      lost > std::numeric_limits<double>::digits10 ? "all" : fmt::format("{:.1f}", lost);
  return fmt::format("{} of {} | {} in `{}` |", losses.fields, losses.all, digits, losses.where);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return EXIT_FAILURE;
  std::cout << cells(losses_in(argv[1])) << '\n';
}
