// transaction: all processes create, open and lock folders in the same order. After locking they
// check that the folders still exist, because a process that fails removes the folders it created.
// New files are first written to a stage, a temporary folder with a known prefix inside the target
// folder. If a process is killed, the next process finds the stage of the killed process by the
// prefix, and removes this stage under the lock.
#include "cli/files/transaction.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "base/descriptor.hpp"

namespace elgen::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view stage_prefix = ".elgen-stage-";

bool write_all(const FileDescriptor& file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(file.number(), text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

bool has_text(const std::string& path, const std::string& text) {
  std::error_code error;
  return fs::file_size(path, error) == text.size() && read_existing_file(path) == text;
}

bool create_file(const std::string& path, const std::string& text) {
  constexpr int flags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
  FileDescriptor file(::open(path.c_str(), flags, 0666));
  return file.is_open() && write_all(file, text) && file.close();
}

constexpr std::chrono::milliseconds pause{5};
constexpr int most_attempts = 100;

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

}  // namespace

/// A folder that receives files, and its stage, which holds the new files.
class TargetFolder {
 public:
  TargetFolder(std::string path, FileDescriptor open)
      : path_(std::move(path)), open_(std::move(open)) {}

  void add(const OutputFile& file) { files_.push_back(&file); }

  /// The path of the first file, for messages.
  [[nodiscard]] const std::string& path() const { return files_.front()->path; }
  /// True if this process now has the lock; false if another process has it.
  [[nodiscard]] bool lock() const;
  /// True if another process removed the folder before this process locked it.
  [[nodiscard]] bool is_removed() const;

  /// Removes the stages that killed processes left.
  void remove_stale_stages() const;
  /// Writes the files that differ from the disk into a new stage, and appends their paths to
  /// `written`.
  [[nodiscard]] std::optional<WriteFailure> stage(std::vector<std::string>& written);
  /// Moves the files from the stage to their paths.
  [[nodiscard]] std::optional<WriteFailure> commit();
  /// Removes the stage. Unless `stays`, first undoes commit(). Allocates no memory.
  void end_transaction(bool stays) noexcept;

 private:
  /// `fresh`: the new file in the stage. `target`: the path to which commit() moves `fresh`. `old`:
  /// a second name of the replaced file, if `had_old` is true.
  struct StagedFile {
    std::string target = {};
    std::string fresh = {};
    std::string old = {};
    bool had_old = false;
    bool is_done = false;
  };

  [[nodiscard]] bool create_stage();
  static bool undo(const StagedFile& move) noexcept;

  std::string path_;
  FileDescriptor open_;
  std::vector<const OutputFile*> files_ = {};
  std::string stage_ = {};
  std::vector<StagedFile> moves_ = {};
};

void TargetFolder::end_transaction(bool stays) noexcept {
  for (auto move = moves_.rbegin(); move != moves_.rend(); ++move) {
    const bool can_remove_old = stays || !move->is_done || undo(*move);
    (void)::unlink(move->fresh.c_str());
    // If the old file could not be restored, its second name is not removed.
    if (move->had_old && can_remove_old) (void)::unlink(move->old.c_str());
  }
  if (!stage_.empty()) (void)::rmdir(stage_.c_str());
}

bool TargetFolder::lock() const {
  if (::flock(open_.number(), LOCK_EX | LOCK_NB) == 0) return true;
  return errno != EWOULDBLOCK && errno != EINTR;  // true if the file system has no locks
}

bool TargetFolder::is_removed() const {
  struct stat status {};
  return ::fstat(open_.number(), &status) != 0 || status.st_nlink == 0;
}

/// Uses readdir(), because the iterators of std::filesystem terminate the process if memory is
/// exhausted.
void TargetFolder::remove_stale_stages() const {
  const std::unique_ptr<DIR, int (*)(DIR*)> folder(::opendir(path_.c_str()), &::closedir);
  if (folder == nullptr) return;
  std::vector<fs::path> stale;
  while (const dirent* const entry = ::readdir(folder.get())) {
    const std::string_view name(entry->d_name);
    if (name.starts_with(stage_prefix)) stale.push_back(fs::path(path_) / name);
  }
  std::error_code error;
  for (const fs::path& stage : stale) fs::remove_all(stage, error);
}

bool TargetFolder::create_stage() {
  std::string name = fmt::format("{}/{}XXXXXX", path_, stage_prefix);
  if (::mkdtemp(name.data()) == nullptr) return false;
  stage_ = std::move(name);
  return true;
}

std::optional<WriteFailure> TargetFolder::stage(std::vector<std::string>& written) {
  for (const OutputFile* file : files_) {
    if (has_text(file->path, file->text)) continue;
    if (stage_.empty() && !create_stage()) return WriteFailure{file->path, errno};
    const std::string number = std::to_string(moves_.size());
    moves_.push_back({file->path, stage_ + "/new" + number, stage_ + "/old" + number});
    if (!create_file(moves_.back().fresh, file->text)) return WriteFailure{file->path, errno};
    written.push_back(file->path);
  }
  return std::nullopt;
}

std::optional<WriteFailure> TargetFolder::commit() {
  for (StagedFile& move : moves_) {
    const char* const target = move.target.c_str();
    struct stat found {};
    // If the file system has no hard links, the old file is renamed.
    if (::lstat(target, &found) == 0) {
      const char* const old = move.old.c_str();
      move.had_old = ::link(target, old) == 0 || ::rename(target, old) == 0;
      if (!move.had_old) return WriteFailure{move.target, errno};
    }
    move.is_done = true;
    if (::rename(move.fresh.c_str(), target) != 0) return WriteFailure{move.target, errno};
  }
  return std::nullopt;
}

bool TargetFolder::undo(const StagedFile& move) noexcept {
  return move.had_old ? ::rename(move.old.c_str(), move.target.c_str()) == 0
                      : ::unlink(move.target.c_str()) == 0;
}

Transaction::Transaction(std::uint64_t seconds)
    : deadline_(std::chrono::steady_clock::now() + std::chrono::seconds(seconds)) {}

Transaction::~Transaction() {
  for (auto& [identity, folder] : folders_) {
    if (folder != nullptr) folder->end_transaction(is_committed_);  // null if its allocation failed
  }
  if (is_committed_) return;
  // After a failure, folders that this process created are empty and still locked.
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

std::optional<WriteFailure> Transaction::open_folder(const OutputFile& file) {
  const std::string path = folder_of(file.path);
  if (!create_folders(path)) return WriteFailure{file.path, errno};
  FileDescriptor open(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  struct stat found {};
  if (!open.is_open() || ::fstat(open.number(), &found) != 0) return WriteFailure{file.path, errno};
  auto& folder = folders_[{found.st_dev, found.st_ino}];
  if (folder == nullptr) folder = std::make_unique<TargetFolder>(path, std::move(open));
  folder->add(file);
  return std::nullopt;
}

std::optional<WriteFailure> Transaction::open_folders(const std::vector<OutputFile>& files) {
  folders_.clear();
  for (const OutputFile& file : files) {
    if (auto failure = open_folder(file)) return failure;
  }
  return std::nullopt;
}

std::optional<WriteFailure> Transaction::lock_folders() const {
  for (const auto& [identity, folder] : folders_) {
    while (!folder->lock()) {
      const bool is_over = std::chrono::steady_clock::now() > deadline_;
      if (is_over || has_pending_interrupt()) return WriteFailure{folder->path(), EWOULDBLOCK};
      std::this_thread::sleep_for(pause);
    }
    if (folder->is_removed()) return WriteFailure{folder->path(), ENOENT};
  }
  return std::nullopt;
}

std::optional<WriteFailure> Transaction::open_and_lock_folders(
    const std::vector<OutputFile>& files) {
  std::optional<WriteFailure> failure;
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    failure = open_folders(files);
    if (!failure) failure = lock_folders();
    if (!failure || failure->error != ENOENT) return failure;
    std::this_thread::sleep_for(pause);
  }
  return failure;
}

std::optional<WriteFailure> Transaction::write(const std::vector<OutputFile>& files) {
  if (auto failure = open_and_lock_folders(files)) return failure;
  // Stale stages are removed before new stages are made, so that a failure leaves no stage behind.
  for (auto& [identity, folder] : folders_) folder->remove_stale_stages();
  for (auto& [identity, folder] : folders_) {
    if (auto failure = folder->stage(written_)) return failure;
  }
  for (auto& [identity, folder] : folders_) {
    if (auto failure = folder->commit()) return failure;
  }
  is_committed_ = true;
  return std::nullopt;
}

}  // namespace elgen::cli
