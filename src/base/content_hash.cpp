// The one hash of the house.
#include "base/content_hash.hpp"

#include <fmt/format.h>
#include <xxhash.h>

namespace elgen {

std::string content_hash(std::string_view text) {
  return fmt::format("{:016x}", XXH3_64bits(text.data(), text.size()));
}

std::string short_hash(std::string_view text) { return content_hash(text).substr(0, 8); }

}  // namespace elgen
