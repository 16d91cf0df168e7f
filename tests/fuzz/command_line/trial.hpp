// Trial: one command of elgen on one mutated input, and the requirements on its result.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace elgen::test {

/// A model, a scene or a robot, and the files that it needs.
struct Input {
  std::string name = {};                          ///< the file given to the command
  std::map<std::string, std::string> files = {};  ///< name -> text; includes `name`
};

/// The models and scenes of models/, the robots of tests/urdf/robots/, and random models.
class Corpus {
 public:
  explicit Corpus(std::size_t random_models);

  /// Adds the robots of a folder.
  void add_robots(const std::filesystem::path& folder);

  [[nodiscard]] const std::vector<Input>& inputs() const { return inputs_; }

 private:
  std::vector<Input> inputs_;
};

struct Trial {
  Input input = {};  ///< one file is mutated
  std::vector<std::string> command = {};
};

/// A command on a mutated input of the corpus; the same for the same seed and corpus.
[[nodiscard]] Trial random_trial(const Corpus& corpus, std::uint64_t seed);

struct Verdict {
  bool worked = false;  ///< the exit code was 0
  /// Empty, or the fault: a signal; an exit code that is undocumented or reports an internal error;
  /// a failed self-check; a failed check (other than [[expect]] and a positive definite M); an
  /// unexpected file; or, if `compiles`, a header with compiler warnings.
  std::string fault = {};
};

[[nodiscard]] Verdict run_trial(const Trial& trial, bool compiles);

/// Writes the files and the command, so that the trial can be repeated by hand.
void save(const Trial& trial, const std::string& fault, const std::filesystem::path& folder);

}  // namespace elgen::test
