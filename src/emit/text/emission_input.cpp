// emission_input: hashes and printed equations. A file states the hash of its own text, computed
// with sixteen zeros in place of the hash. Headers have the hash after " body " in the first two
// lines, sidecars after the last "body":.
#include "emit/text/emission_input.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>

#include "emit/text/layout.hpp"

namespace elgen {
namespace {

constexpr std::string_view scene_separator = " of ";
constexpr std::string_view sources_suffix = ". DO NOT EDIT.";

/// The source files as text: "cart_pole.toml" without a scene file, otherwise
/// "cart_pole_balance.scene.toml of cart_pole.toml".
std::string sources_text(const SourcePaths& paths) {
  const std::string model = comment_text(paths.model);
  return paths.scene.empty()
             ? model
             : fmt::format("{}{}{}", comment_text(paths.scene), scene_separator, model);
}

constexpr std::size_t hash_length = 16;
constexpr std::string_view header_mark = " body ";
constexpr std::string_view sidecar_mark = "\"body\": \"";

bool is_hash(std::string_view text) {
  return text.size() == hash_length &&
         text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// The position of the stated hash in the text; npos without a stated hash.
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

std::string content_hash(std::string_view text) {
  return fmt::format("{:016x}", XXH3_64bits(text.data(), text.size()));
}

std::string short_hash(std::string_view text) { return content_hash(text).substr(0, 8); }

SourcePaths stated_paths(std::string_view text) {
  const std::string start = fmt::format("{} from ", generated_marker);
  const std::size_t at = text.find(start);
  if (at == std::string_view::npos) return {};
  std::string_view stated = text.substr(at + start.size());
  stated = stated.substr(0, stated.find(sources_suffix));
  for (const std::string scene_ending : {".scene.toml", "<stdin>"}) {
    const std::size_t found = stated.find(scene_ending + std::string(scene_separator));
    if (found == std::string_view::npos) continue;
    const std::size_t end = found + scene_ending.size();
    return {std::string(stated.substr(end + scene_separator.size())),
            std::string(stated.substr(0, end))};
  }
  return {std::string(stated), {}};
}

EmissionInput emission_input(const Model& model, const Scene& scene, const Program& program,
                             const PagePrograms& book) {
  std::vector<FunctionEquations> printed;
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    printed.push_back(equations(program, i));
  }
  return {model,
          scene,
          program,
          book,
          std::move(printed),
          fmt::format("{} from {}{}", generated_marker, sources_text(scene.paths), sources_suffix),
          content_hash(model.canonical_text),
          scene.canonical_text.empty() ? "full" : content_hash(scene.canonical_text)};
}

std::string_view blank_hash() { return "0000000000000000"; }

std::string with_body_hash(std::string text) {
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
