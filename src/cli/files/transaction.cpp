// transaction: folders are created, opened, locked in one order for all processes, and looked at
// again: a process that fails removes the folders it made, perhaps under the hands of another.
#include "cli/files/transaction.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <thread>

#include "cli/files/target_folder.hpp"

namespace elgen::cli {

namespace {

constexpr std::chrono::milliseconds pause{5};
constexpr int most_attempts = 100;

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

}  // namespace

Transaction::Transaction(std::uint64_t seconds)
    : deadline_(std::chrono::steady_clock::now() + std::chrono::seconds(seconds)) {}

Transaction::~Transaction() {
  for (auto& [identity, folder] : folders_) {
    if (folder != nullptr) folder->finish(stays_);  // null where memory for it was refused
  }
  if (stays_) return;
  // Folders made in vain are empty now, and still locked.
  for (auto path = created_.rbegin(); path != created_.rend(); ++path) {
    (void)::rmdir(path->c_str());
  }
}

bool Transaction::create_folders(const std::string& path) {
  struct stat found {};
  if (::stat(path.c_str(), &found) == 0) return true;
  const std::string outer = folder_of(path);
  if (outer != path && !create_folders(outer)) return false;
  created_.push_back(path);
  if (::mkdir(path.c_str(), 0777) == 0) return true;
  const int error = errno;
  created_.pop_back();
  errno = error;
  return error == EEXIST;
}

std::optional<Failure> Transaction::open_folder(const OutputFile& file) {
  const std::string path = folder_of(file.path);
  if (!create_folders(path)) return Failure{file.path, errno};
  Descriptor open(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  struct stat found {};
  if (!open.is_open() || ::fstat(open.number(), &found) != 0) return Failure{file.path, errno};
  auto& folder = folders_[{found.st_dev, found.st_ino}];
  if (folder == nullptr) folder = std::make_unique<TargetFolder>(path, std::move(open));
  folder->add(file);
  return std::nullopt;
}

std::optional<Failure> Transaction::open_folders(const std::vector<OutputFile>& files) {
  folders_.clear();
  for (const OutputFile& file : files) {
    if (auto failure = open_folder(file)) return failure;
  }
  return std::nullopt;
}

std::optional<Failure> Transaction::lock_folders() const {
  for (const auto& [identity, folder] : folders_) {
    while (!folder->lock()) {
      const bool is_over = std::chrono::steady_clock::now() > deadline_;
      if (is_over || interrupt_waits()) return Failure{folder->path(), EWOULDBLOCK};
      std::this_thread::sleep_for(pause);
    }
    if (folder->is_removed()) return Failure{folder->path(), ENOENT};
  }
  return std::nullopt;
}

std::optional<Failure> Transaction::hold_folders(const std::vector<OutputFile>& files) {
  std::optional<Failure> failure;
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    failure = open_folders(files);
    if (!failure) failure = lock_folders();
    if (!failure || failure->error != ENOENT) return failure;
    std::this_thread::sleep_for(pause);
  }
  return failure;
}

std::optional<Failure> Transaction::write(const std::vector<OutputFile>& files) {
  if (auto failure = hold_folders(files)) return failure;
  // Before anything is staged, which would be left behind where this fails.
  for (auto& [identity, folder] : folders_) folder->remove_stale_stages();
  for (auto& [identity, folder] : folders_) {
    if (auto failure = folder->stage(written_)) return failure;
  }
  for (auto& [identity, folder] : folders_) {
    if (auto failure = folder->commit()) return failure;
  }
  stays_ = true;
  return std::nullopt;
}

}  // namespace elgen::cli
