// elgen schema NAME: the JSON Schema of what elgen reads or prints.
#include <array>

#include "base/diagnostic_data.hpp"
#include "cli/commands.hpp"
#include "diff/diff_schema.hpp"
#include "elgen/certificate.hpp"
#include "parse/file_schema.hpp"

namespace elgen::cli {

namespace {

struct SchemaRow {
  const char* name;
  std::string (*text)();
};

constexpr std::array schemas{
    SchemaRow{"model", [] { return file_schema(FileKind::model); }},
    SchemaRow{"scene", [] { return file_schema(FileKind::scene); }},
    SchemaRow{"diagnostics", &diagnostic_schema},
    SchemaRow{"certificate", &certificate_schema},
    SchemaRow{"diff", &diff_schema},
};

std::vector<std::string> schema_names() {
  std::vector<std::string> names;
  for (const SchemaRow& row : schemas) names.emplace_back(row.name);
  return names;
}

ExitCode schema(const GlobalOptions& global, const std::string& name) {
  const auto row = std::ranges::find(schemas, name, &SchemaRow::name);
  return print(global, row->text());
}

}  // namespace

void add_schema(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("schema", "the JSON Schema of a file, for editors and programs");
  const auto name = std::make_shared<std::string>();
  command->add_option("name", *name, "model, scene, diagnostics, certificate or diff")
      ->required()
      ->check(CLI::IsMember(schema_names()));
  set_action(*command, action, name, &schema);
}

}  // namespace elgen::cli
