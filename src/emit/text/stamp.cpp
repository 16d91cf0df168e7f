// stamp: a file states the hash of its own text, taken with sixteen zeros where the hash will
// stand. It stands behind " body " in the first two lines of a header, behind the last "body": of a
// sidecar.
#include "emit/text/stamp.hpp"

#include <algorithm>

#include "base/content_hash.hpp"
#include "elgen/emitted_files.hpp"

namespace elgen {
namespace {

constexpr std::size_t hash_length = 16;
constexpr std::string_view header_mark = " body ";
constexpr std::string_view sidecar_mark = "\"body\": \"";

bool is_hash(std::string_view text) {
  return text.size() == hash_length &&
         text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// Where the text states its hash; npos where it does not.
std::size_t find_body_hash(std::string_view text) {
  const std::size_t first_line = std::min(text.find('\n'), text.size() - 1);
  const std::string_view top = text.substr(0, text.find('\n', first_line + 1));
  const std::size_t in_header = top.rfind(header_mark);
  const std::size_t in_sidecar = text.rfind(sidecar_mark);
  for (const std::size_t at : {in_header + header_mark.size(), in_sidecar + sidecar_mark.size()}) {
    if (at < text.size() && is_hash(text.substr(at, hash_length))) return at;
  }
  return std::string_view::npos;
}

}  // namespace

std::string_view blank_hash() { return "0000000000000000"; }

std::string stamped(std::string text) {
  const std::size_t at = find_body_hash(text);
  if (at == std::string::npos) return text;
  const std::string hash = content_hash(text);
  return text.replace(at, hash_length, hash);
}

BodyHash body_hash(std::string_view text) {
  const std::size_t at = text.empty() ? std::string_view::npos : find_body_hash(text);
  if (at == std::string_view::npos) return {"", content_hash(text)};
  std::string blank(text);
  blank.replace(at, hash_length, blank_hash());
  return {std::string(text.substr(at, hash_length)), content_hash(blank)};
}

}  // namespace elgen
