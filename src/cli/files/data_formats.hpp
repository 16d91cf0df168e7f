// data_formats: the formats of tables and rows. A name or a file's ending selects the format.
#pragma once

#include <fmt/ranges.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/reason.hpp"
#include "elgen/diagnostic.hpp"

namespace elgen::cli {

template <class Data>
struct DataFormat {
  std::string_view name;
  std::string (*text)(const Data&);
};

/// The formats csv, json and svg, for data that has to_csv(), to_json() and to_svg().
template <class Data>
inline constexpr std::array data_formats{
    DataFormat<Data>{"csv", [](const Data& data) { return to_csv(data); }},
    DataFormat<Data>{"json", [](const Data& data) { return to_json(data); }},
    DataFormat<Data>{"svg", [](const Data& data) { return to_svg(data); }}};

/// The format that the ending of `file` selects; E913 if the ending selects none. The message also
/// lists the ending `other`, because the command itself handles files with this ending.
template <class Data>
[[nodiscard]] Result<DataFormat<Data>> select_format(
    const std::string& file, const std::array<DataFormat<Data>, 3>& formats = data_formats<Data>,
    std::string_view other = {}) {
  std::vector<std::string> endings;
  for (const DataFormat<Data>& format : formats) {
    endings.push_back(fmt::format(".{}", format.name));
    if (file.ends_with(endings.back())) return format;
  }
  if (!other.empty()) endings.push_back(fmt::format(".{}", other));
  const std::string last = endings.back();
  endings.pop_back();
  return Diagnostic{
      Reason::unknown_ending,
      {},
      fmt::format("`{}` ends in none of {} and {}", file, fmt::join(endings, ", "), last),
      "the ending selects the format"};
}

}  // namespace elgen::cli
