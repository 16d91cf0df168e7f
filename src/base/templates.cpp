// templates: finds an embedded template, and a partial in the folder of another template.
#include "elgen/templates.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace elgen {

std::string_view require_template(std::string_view path) {
  const std::string_view text = embedded_template(path);
  if (text.empty()) throw std::logic_error(fmt::format("no template {}", path));
  return text;
}

std::string partial_path(std::string_view path, std::string_view name) {
  const std::string_view folder = path.substr(0, path.find('/') + 1);
  return fmt::format("{}{}{}", folder, name, path.substr(path.find('.')));
}

}  // namespace elgen
