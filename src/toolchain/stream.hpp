// Stream: a pipe to which a child writes, and the first part of its text.
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

class Stream {
 public:
  explicit Stream(std::size_t most) : most_(most) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
    reading_ = Descriptor(ends[0]);
    writing_ = Descriptor(ends[1]);
    if (::fcntl(reading_.number(), F_SETFL, O_NONBLOCK) != 0) (void)reading_.close();
  }

  [[nodiscard]] bool is_open() const { return reading_.is_open(); }
  [[nodiscard]] const Descriptor& reading() const { return reading_; }
  [[nodiscard]] const Descriptor& writing() const { return writing_; }
  /// Closes this process's end; reading then ends when the child closes its ends.
  void close_writing() { (void)writing_.close(); }

  /// Reads at most the content of one full pipe, so that a child that never stops writing cannot
  /// block elgen.
  void drain() {
    constexpr std::size_t largest_pipe = 1U << 20U;  // on Linux, without privileges
    std::array<char, 4096> part{};
    for (std::size_t reads = 0; reads <= largest_pipe / part.size(); ++reads) {
      const ssize_t count = ::read(reading_.number(), part.data(), part.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return;
      text_.append(part.data(), std::min(static_cast<std::size_t>(count), most_ - text_.size()));
    }
  }
  [[nodiscard]] std::string take() { return std::exchange(text_, {}); }

 private:
  std::size_t most_;
  Descriptor reading_ = {};
  Descriptor writing_ = {};
  std::string text_ = {};
};

}  // namespace elgen
