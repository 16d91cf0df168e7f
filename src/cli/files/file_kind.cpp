// file_kind: a row for every kind of file that is not simply read and replaced.
#include "cli/files/file_kind.hpp"

namespace elgen::cli {

std::string_view special_kind(mode_t mode) {
  switch (mode & S_IFMT) {
    case S_IFREG:
      return {};
    case S_IFDIR:
      return "a folder";
    case S_IFCHR:
    case S_IFBLK:
      return "a device";
    case S_IFIFO:
      return "a FIFO";
    case S_IFSOCK:
      return "a socket";
    default:
      return "a symbolic link";
  }
}

}  // namespace elgen::cli
