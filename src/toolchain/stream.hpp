// OutputPipe: a pipe to which a child writes; keeps the first bytes of the text.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string>
#include <utility>

#include "base/descriptor.hpp"

namespace elgen {

class OutputPipe {
 public:
  explicit OutputPipe(std::size_t most) : most_(most) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
    read_end_ = FileDescriptor(ends[0]);
    write_end_ = FileDescriptor(ends[1]);
    if (::fcntl(read_end_.number(), F_SETFL, O_NONBLOCK) != 0) (void)read_end_.close();
  }

  [[nodiscard]] bool is_open() const { return read_end_.is_open(); }
  [[nodiscard]] const FileDescriptor& read_end() const { return read_end_; }
  [[nodiscard]] const FileDescriptor& write_end() const { return write_end_; }
  /// Closes this process's write end, so that reading ends when the child closes its ends.
  void close_write_end() { (void)write_end_.close(); }

  /// Reads at most as much as a full pipe holds, because a child that never stops writing must not
  /// block elgen.
  void drain() {
    constexpr std::size_t largest_pipe = 1U << 20U;  // largest size on Linux without privileges
    std::array<char, 4096> part{};
    for (std::size_t reads = 0; reads <= largest_pipe / part.size(); ++reads) {
      const ssize_t count = ::read(read_end_.number(), part.data(), part.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return;
      text_.append(part.data(), std::min(static_cast<std::size_t>(count), most_ - text_.size()));
    }
  }
  [[nodiscard]] std::string take_text() { return std::exchange(text_, {}); }

 private:
  std::size_t most_;
  FileDescriptor read_end_ = {};
  FileDescriptor write_end_ = {};
  std::string text_ = {};
};

}  // namespace elgen
