// fill_template: strict Mustache. kainjow's own context answers an unknown name with nothing; this
// one throws, so that a misspelt hole fails the first test that renders it.
#include "emit/text/fill_template.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "elgen/templates.hpp"

namespace elgen {
namespace {

class StrictContext final : public kainjow::mustache::context<std::string> {
 public:
  using Base = kainjow::mustache::context<std::string>;
  explicit StrictContext(const TemplateData* data) : Base(data) {}

  [[nodiscard]] const TemplateData* get(const std::string& name) const override {
    return known(Base::get(name), name);
  }
  [[nodiscard]] const TemplateData* get_partial(const std::string& name) const override {
    return known(Base::get_partial(name), name);
  }

 private:
  static const TemplateData* known(const TemplateData* value, const std::string& name) {
    if (value == nullptr) throw std::logic_error("template hole without a value: " + name);
    return value;
  }
};

/// kainjow leaves an empty line where a section on lines of its own is not rendered.
std::string without_repeated_blank_lines(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool repeats = c == '\n' && result.size() > 1 && result.back() == '\n' &&
                         result[result.size() - 2] == '\n';
    if (!repeats) result += c;
  }
  return result;
}

}  // namespace

TemplateData section_if(bool present, const TemplateData& values) {
  TemplateData list(TemplateData::type::list);
  if (present) list.push_back(values);
  return list;
}

TemplateData lines_data(const std::vector<std::string>& lines) {
  TemplateData list(TemplateData::type::list);
  for (const std::string& line : lines) list.push_back(TemplateData("line", line));
  return list;
}

std::string fill_template(std::string_view path, const TemplateData& data) {
  const std::string_view text = embedded_template(path);
  if (text.empty()) throw std::logic_error(fmt::format("no template {}", path));
  kainjow::mustache::mustache picture{std::string(text)};
  picture.set_custom_escape([](const std::string& value) { return value; });
  StrictContext context(&data);
  const std::string result = picture.render(context);
  if (!picture.is_valid()) throw std::logic_error(picture.error_message());
  return without_repeated_blank_lines(result);
}

}  // namespace elgen
