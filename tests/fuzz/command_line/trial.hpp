// Trial: one command of elgen on one mutated input, and what must be true of how it ended.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace elgen::fuzz {

/// Files by name; the last one in the order of `inputs` is given to the command.
struct Input {
  std::string name = {};                          ///< of the file that the command is given
  std::map<std::string, std::string> files = {};  ///< files to lie beside it, itself included
};

/// Every model, scene and robot of the folder, below tests/ and models/, and random models.
class Corpus {
 public:
  explicit Corpus(std::size_t random_models);

  /// Robots in a folder, beside those of the tests.
  void add_robots(const std::filesystem::path& folder);

  [[nodiscard]] const std::vector<Input>& inputs() const { return inputs_; }

 private:
  std::vector<Input> inputs_;
};

struct Trial {
  Input input = {};  ///< with one file mutated
  std::vector<std::string> command = {};
};

/// The same trial for a seed and a corpus in every run.
[[nodiscard]] Trial drawn(const Corpus& corpus, std::uint64_t seed);

struct Verdict {
  bool worked = false;  ///< the command did what it was told, and said 0
  /// Empty, or what is wrong: a signal, an exit code that is not documented or says that elgen made
  /// a mistake, a self-check that failed, a check beside [[expect]] that does not hold, a file left
  /// behind, or (`compiles`) a header that a compiler warns about.
  std::string fault = {};
};

[[nodiscard]] Verdict tried(const Trial& trial, bool compiles);

/// Files and command, so that the trial can be typed again.
void save(const Trial& trial, const std::string& fault, const std::filesystem::path& folder);

}  // namespace elgen::fuzz
