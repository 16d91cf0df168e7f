// target_folder: the stage bears a name of our own, so that what a killed process left is known and
// removed by the next one, under the lock.
#include "cli/files/target_folder.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <memory>

namespace elgen::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view stage_prefix = ".elgen-stage-";

bool write_all(const Descriptor& file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(file.number(), text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

bool holds(const std::string& path, const std::string& text) {
  std::error_code error;
  return fs::file_size(path, error) == text.size() && existing_text(path) == text;
}

bool create(const std::string& path, const std::string& text) {
  constexpr int flags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
  Descriptor file(::open(path.c_str(), flags, 0666));
  return file.is_open() && write_all(file, text) && file.close();
}

}  // namespace

void TargetFolder::finish(bool stays) noexcept {
  for (auto move = moves_.rbegin(); move != moves_.rend(); ++move) {
    const bool is_settled = stays || !move->is_done || undo(*move);
    (void)::unlink(move->fresh.c_str());
    // An old file that cannot be put back is kept where it is.
    if (move->had_old && is_settled) (void)::unlink(move->old.c_str());
  }
  if (!stage_.empty()) (void)::rmdir(stage_.c_str());
}

bool TargetFolder::lock() const {
  if (::flock(open_.number(), LOCK_EX | LOCK_NB) == 0) return true;
  return errno != EWOULDBLOCK && errno != EINTR;  // a file system without locks
}

bool TargetFolder::is_removed() const {
  struct stat status {};
  return ::fstat(open_.number(), &status) != 0 || status.st_nlink == 0;
}

/// The iterators of std::filesystem end the process where memory is refused.
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

std::optional<Failure> TargetFolder::stage(std::vector<std::string>& written) {
  for (const OutputFile* file : files_) {
    if (holds(file->path, file->text)) continue;
    if (stage_.empty() && !create_stage()) return Failure{file->path, errno};
    const std::string number = std::to_string(moves_.size());
    moves_.push_back({file->path, stage_ + "/new" + number, stage_ + "/old" + number});
    if (!create(moves_.back().fresh, file->text)) return Failure{file->path, errno};
    written.push_back(file->path);
  }
  return std::nullopt;
}

std::optional<Failure> TargetFolder::commit() {
  for (Move& move : moves_) {
    const char* const target = move.target.c_str();
    struct stat found {};
    // Where a file can have no second name it is moved away.
    if (::lstat(target, &found) == 0) {
      const char* const old = move.old.c_str();
      move.had_old = ::link(target, old) == 0 || ::rename(target, old) == 0;
      if (!move.had_old) return Failure{move.target, errno};
    }
    move.is_done = true;
    if (::rename(move.fresh.c_str(), target) != 0) return Failure{move.target, errno};
  }
  return std::nullopt;
}

bool TargetFolder::undo(const Move& move) noexcept {
  return move.had_old ? ::rename(move.old.c_str(), move.target.c_str()) == 0
                      : ::unlink(move.target.c_str()) == 0;
}

}  // namespace elgen::cli
