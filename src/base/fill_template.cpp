// fill_template: strict Mustache. kainjow renders an unknown name as empty text; StrictContext
// throws std::logic_error instead, so that tests find a misspelt hole.
#include "base/fill_template.hpp"

#include <stdexcept>

#include "elgen/templates.hpp"

namespace elgen {
namespace {

class StrictContext final : public kainjow::mustache::context<std::string> {
 public:
  using Base = kainjow::mustache::context<std::string>;
  StrictContext(const TemplateData* data, std::string_view path) : Base(data), path_(path) {}

  [[nodiscard]] const TemplateData* get(const std::string& name) const override {
    return require_value(Base::get(name), name);
  }
  [[nodiscard]] const TemplateData* get_partial(const std::string& name) const override {
    std::string text(require_template(partial_path(path_, name)));
    text.pop_back();  // the line end, which the including template has too
    return &partials_.insert_or_assign(name, TemplateData(text)).first->second;
  }

 private:
  static const TemplateData* require_value(const TemplateData* value, const std::string& name) {
    if (value == nullptr) throw std::logic_error("template hole without a value: " + name);
    return value;
  }

  std::string_view path_;
  mutable std::map<std::string, TemplateData> partials_ = {};
};

}  // namespace

TemplateData optional_section(bool present, const TemplateData& values) {
  TemplateData list(TemplateData::type::list);
  if (present) list.push_back(values);
  return list;
}

TemplateData lines_section(const std::vector<std::string>& lines) {
  return repeated_section(lines,
                          [](const std::string& line) { return TemplateData("line", line); });
}

std::string fill_template(std::string_view path, const TemplateData& data) {
  kainjow::mustache::mustache parsed{std::string(require_template(path))};
  parsed.set_custom_escape([](const std::string& value) { return value; });
  StrictContext context(&data, path);
  std::string result = parsed.render(context);
  if (!parsed.is_valid()) throw std::logic_error(parsed.error_message());
  return result;
}

std::string escape_markup(const std::string& text, const Escapes& escapes) {
  std::string result;
  for (const char c : text) {
    const auto found = escapes.find(c);
    result += found == escapes.end() ? std::string_view(&c, 1) : found->second;
  }
  return result;
}

}  // namespace elgen
