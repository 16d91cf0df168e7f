// Sizes: the integers repetitions run to, as the model has them or as a scene overrides them.
#include <cln/integer.h>

#include "check/expressions/expand.hpp"
#include "elgen/syntax.hpp"

namespace elgen {
namespace {

void declare_size(Context& context, const KeySyntax& key) {
  const Scope nothing(context.sizes);
  const auto value = integer_value(key.value.expression, nothing, context.report);
  if (!value ||
      !context.symbols.declare({key.key, {}, key.key_span}, SymbolKind::size, 0, context.report)) {
    return;
  }
  context.sizes[key.key] = *value;
}

void override_size(Context& context, const SizeOverride& size) {
  const auto found = context.sizes.find(size.name);
  if (found != context.sizes.end()) {
    found->second = size.value;
    return;
  }
  std::vector<std::string> names;
  for (const auto& [name, value] : context.sizes) {
    names.push_back(name);
  }
  context.report.add(Code::E605, size.span, "unknown size " + quoted(size.name),
                     suggestion(size.name, names));
}

}  // namespace

void apply_sizes(Context& context, const FileSyntax& syntax,
                 const std::vector<SizeOverride>& overrides) {
  for (const EntrySyntax& entry : syntax.entries) {
    if (entry.name != "sizes") {
      continue;
    }
    for (const KeySyntax& key : entry.keys) {
      declare_size(context, key);
    }
  }
  for (const SizeOverride& size : overrides) {
    override_size(context, size);
  }
}

}  // namespace elgen
