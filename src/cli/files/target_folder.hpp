// TargetFolder: a folder that files go to, and the stage inside it on which they are made ready.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/descriptor.hpp"
#include "cli/files/transaction.hpp"

namespace elgen::cli {

class TargetFolder {
 public:
  TargetFolder(std::string path, Descriptor open)
      : path_(std::move(path)), open_(std::move(open)) {}

  void add(const OutputFile& file) { files_.push_back(&file); }

  /// That of the first file.
  [[nodiscard]] const std::string& path() const { return files_.front()->path; }
  /// Whether the lock is ours now; false while another process has it.
  [[nodiscard]] bool lock() const;
  /// Whether another process removed the folder before it was locked.
  [[nodiscard]] bool is_removed() const;

  /// Of processes that were killed.
  void remove_stale_stages() const;
  /// Writes what differs from the disk into a fresh folder inside; `written` gains the paths.
  [[nodiscard]] std::optional<Failure> stage(std::vector<std::string>& written);
  /// Moves it to its place.
  [[nodiscard]] std::optional<Failure> commit();
  /// Removes the stage, and undoes commit() unless it is to stay. Needs no memory.
  void finish(bool stays) noexcept;

 private:
  /// A file on its way. The old one is kept under a second name.
  struct Move {
    std::string target = {};
    std::string fresh = {};
    std::string old = {};
    bool had_old = false;
    bool is_done = false;
  };

  [[nodiscard]] bool create_stage();
  static bool undo(const Move& move) noexcept;

  std::string path_;
  Descriptor open_;
  std::vector<const OutputFile*> files_ = {};
  std::string stage_ = {};
  std::vector<Move> moves_ = {};
};

}  // namespace elgen::cli
