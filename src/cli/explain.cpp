// elgen explain CODE: what an error code means and how to mend it.
#include <fmt/format.h>

#include "options.hpp"

namespace elgen::cli {

ExitCode explain(const GlobalOptions& global, const std::string& code) {
  const CodeRow* row = find_code(code);
  if (row != nullptr) {
    return print(global, fmt::format("{}: {}\n\n{}\n", row->name, row->title, row->explanation));
  }
  std::vector<std::string> names;
  for (const CodeRow& candidate : code_table()) names.emplace_back(candidate.name);
  const std::string near = nearest(code, names);
  return report(global, {{Code::E913,
                          {},
                          fmt::format("`{}` is no error code", code),
                          near.empty() ? "" : fmt::format("did you mean `{}`?", near)}});
}

}  // namespace elgen::cli
