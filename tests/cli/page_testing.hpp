// Animated pages of the tests, and their scripts in Node.
#pragma once

#include <catch2/catch.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "cli/cli_testing.hpp"
#include "support/installed.hpp"

namespace elgen::test {

class Pages : public Workspace {
 public:
  [[nodiscard]] std::string page(const std::string& model, const std::string& options = "") const {
    prepare("elgen simulate -q --time 20 -o page.html --force " + options + " " + model);
    return read("page.html");
  }

  /// The value of the JavaScript `code` after the script of page.html, without a browser.
  [[nodiscard]] std::string value(const std::string& code) const {
    const Outcome shown =
        run("node " ELGEN_SOURCE_DIR "/tests/player/page.js page.html '" + code + "'");
    INFO(shown.errors);
    REQUIRE(shown.status == 0);
    return shown.output.substr(0, shown.output.find('\n'));
  }

  /// The last row of `elgen simulate` for `seconds`, without t and E.
  [[nodiscard]] std::vector<double> end_of_run(const std::string& seconds,
                                               const std::string& input) const {
    prepare("elgen simulate -q --force --time " + seconds + " --every " + seconds + " -o run.csv " +
            input);
    const std::string rows = read("run.csv");
    const std::string last = rows.substr(rows.rfind('\n', rows.size() - 2) + 1);
    const std::vector<double> numbers = numbers_of(last);
    return {numbers.begin() + 1, numbers.end() - 1};
  }

  [[nodiscard]] static std::vector<double> numbers_of(const std::string& list) {
    std::vector<double> numbers;
    std::istringstream words(list);
    for (std::string word; std::getline(words, word, ',');) numbers.push_back(std::stod(word));
    return numbers;
  }
};

inline std::string shipped(const std::string& name) { return models + "/" + name + ".toml"; }

}  // namespace elgen::test
