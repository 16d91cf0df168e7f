// Transaction: writes many files together, or none.
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

/// A path that could not be written, and the system's error number.
struct WriteFailure {
  std::string path = {};
  int error = 0;
};

class TargetFolder;

/// While a Transaction exists, folders are locked and interrupts are deferred. The destructor
/// restores all files, unless write() succeeded.
class Transaction {
 public:
  explicit Transaction(std::uint64_t seconds);
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();

  /// Waits for other processes that write to the same folders; then stages the files that differ
  /// from the disk, and moves them to their paths.
  [[nodiscard]] std::optional<WriteFailure> write(const std::vector<OutputFile>& files);

  /// The paths of the files that differed from the disk.
  [[nodiscard]] const std::vector<std::string>& written_paths() const { return written_; }

 private:
  using FolderIdentity = std::pair<dev_t, ino_t>;
  /// Sorted by identity, so that every process locks folders in the same order.
  using Folders = std::map<FolderIdentity, std::unique_ptr<TargetFolder>>;

  /// Creates, opens and locks the folders of all files.
  [[nodiscard]] std::optional<WriteFailure> open_and_lock_folders(
      const std::vector<OutputFile>& files);
  [[nodiscard]] std::optional<WriteFailure> open_folders(const std::vector<OutputFile>& files);
  [[nodiscard]] std::optional<WriteFailure> open_folder(const OutputFile& file);
  [[nodiscard]] bool create_folders(const std::string& path);
  [[nodiscard]] std::optional<WriteFailure> lock_folders() const;

  SignalBlocker until_done_;
  std::chrono::steady_clock::time_point deadline_;
  std::vector<std::string> created_ = {};  ///< folders made by this process, outer first
  Folders folders_;
  std::vector<std::string> written_ = {};
  bool is_committed_ = false;
};

}  // namespace elgen::cli
