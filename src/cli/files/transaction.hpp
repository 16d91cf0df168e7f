// Transaction: many files change at once, or none does.
#pragma once

#include <sys/stat.h>

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/no_interrupts.hpp"
#include "cli/files/output_files.hpp"

namespace elgen::cli {

/// The path that could not be written, and the number of the system's error.
struct Failure {
  std::string path = {};
  int error = 0;
};

class TargetFolder;

/// While it lives, interrupts wait and the folders are locked. Unless write() succeeded, its end
/// puts everything back as it was.
class Transaction {
 public:
  explicit Transaction(std::uint64_t seconds);
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();

  /// Waits for other processes that write to the same folders, stages what differs from the disk,
  /// and moves it to its place.
  [[nodiscard]] std::optional<Failure> write(const std::vector<OutputFile>& files);

  /// The paths of the files that differed.
  [[nodiscard]] const std::vector<std::string>& written() const { return written_; }

 private:
  using Identity = std::pair<dev_t, ino_t>;
  /// In the order of their identities, in which every process locks them.
  using Folders = std::map<Identity, std::unique_ptr<TargetFolder>>;

  /// Open and locked, all of them.
  [[nodiscard]] std::optional<Failure> hold_folders(const std::vector<OutputFile>& files);
  [[nodiscard]] std::optional<Failure> open_folders(const std::vector<OutputFile>& files);
  [[nodiscard]] std::optional<Failure> open_folder(const OutputFile& file);
  [[nodiscard]] bool create_folders(const std::string& path);
  [[nodiscard]] std::optional<Failure> lock_folders() const;

  NoInterrupts until_done_;
  std::chrono::steady_clock::time_point deadline_;
  std::vector<std::string> created_ = {};  ///< folders, outer ones first
  Folders folders_;
  std::vector<std::string> written_ = {};
  bool stays_ = false;
};

}  // namespace elgen::cli
