// interpreted: runs a driver script, which imports the module, prints its declared numbers, and
// answers each line of numbers with a line of numbers. Seventeen digits distinguish all doubles:
//
//     0 1 1 2 0.75 …           ->      elgen: = 3.1415926535897931 …
//                                      elgen: ! ZeroDivisionError: …
//
// Other code may print, too; lines without the prefix "elgen: " are ignored.
#include "toolchain/interpreted.hpp"

#include <fmt/ranges.h>

#include <cstdlib>
#include <set>
#include <utility>

#include "base/fill_template.hpp"
#include "elgen/artifacts.hpp"
#include "elgen/spellings.hpp"
#include "elgen/wording.hpp"
#include "emit/interface/code_interface.hpp"
#include "numbers/exact_number.hpp"
#include "toolchain/process.hpp"
#include "toolchain/workshop.hpp"

namespace elgen {
namespace {

using Texts = std::vector<std::string>;
using Numbers = std::vector<double>;

constexpr std::string_view start_of_line = "elgen: ";
constexpr std::size_t most_output = std::size_t{1} << 30U;

/// The command in the language's environment variable ($PYTHON, for example), or the default
/// command.
Texts interpreter_of(const SourceSpelling& spelling) {
  const char* const chosen = std::getenv(std::string(spelling.variable).c_str());
  return words_of_command(chosen != nullptr && *chosen != '\0' ? chosen
                                                               : std::string(spelling.command));
}

/// The emitted parameters, with their indices among all parameters that the driver receives.
TemplateData parameters_data(const DriverInput& input) {
  const SourceSpelling& spelling = source_spelling(input.scene.emission.language);
  std::set<std::string> emitted;
  for (const ParameterArray& array : emitted_parameters(input.model, input.program)) {
    emitted.insert(array.name);
  }
  TemplateData list(TemplateData::type::list);
  std::size_t number = spelling.first_index;
  for (const auto& [name, place] : parameter_leaf_members(input.model, input.program.leaves)) {
    const auto element = fmt::runtime(place ? spelling.element : "");
    const TemplateRow row{
        {"name", name_in_language(spelling.language, name)},
        {"element", fmt::format(element, "", place.value_or(0) + spelling.first_index)},
        {"number", std::to_string(number++)}};
    if (emitted.contains(name)) list.push_back(row);
  }
  return list;
}

/// The numbers that a module declares, in the order in which the driver prints them.
std::vector<DeclaredNumber> declared_numbers(const DriverInput& input) {
  std::vector<DeclaredNumber> all;
  for (const DeclaredArray& array : declared_arrays(input.model, input.program)) {
    all.push_back({"the size of " + array.name, 0, static_cast<double>(array.size())});
    const std::vector<DeclaredNumber> numbers = declared_numbers_of(array);
    all.insert(all.end(), numbers.begin(), numbers.end());
  }
  for (const ParameterArray& array : emitted_parameters(input.model, input.program)) {
    for (std::uint32_t i = 0; i < array.count; ++i) {
      const Parameter& parameter = input.model.parameters[array.first + i];
      all.push_back({parameter.name, 0, to_double(parameter.value)});
    }
  }
  return all;
}

TemplateData arrays_data(const DriverInput& input) {
  return repeated_section(
      declared_arrays(input.model, input.program), [](const DeclaredArray& array) {
        return TemplateRow{{"name", array.name},
                           {"numbers", optional_section(array.kind != DeclaredArray::Kind::texts)}};
      });
}

TemplateData defaults_data(const DriverInput& input) {
  return repeated_section(
      emitted_parameters(input.model, input.program), [&](const ParameterArray& array) {
        return TemplateRow{{"name", name_in_language(input.scene.emission.language, array.name)}};
      });
}

TemplateData leaves_data(LanguageId language) {
  return repeated_section(leaf_table(), [language](const LeafRow& leaf) {
    return TemplateRow{{"name", name_in_language(language, leaf.symbol)},
                       {"single", optional_section(is_single(leaf.id))}};
  });
}

TemplateData functions_data(const DriverInput& input) {
  const LanguageId language = input.scene.emission.language;
  return repeated_section(input.program.functions, [&](const Function& function) {
    Texts arguments;
    for (const Opcode argument : arguments_of(input.model, function, input.program, language)) {
      arguments.push_back("x." + name_in_language(language, leaf_row(argument).symbol));
    }
    std::vector<std::string> fields;
    for (const Field& field : function.fields) {
      if (!field.name.empty()) fields.push_back(name_in_language(language, field.name));
    }
    return TemplateRow{{"name", name_in_language(language, function.name)},
                       {"fields", lines_section(fields)},
                       {"arguments", fmt::format("{}", fmt::join(arguments, ", "))}};
  });
}

std::string driver_text(const DriverInput& input) {
  const LanguageRow& language = language_row(input.scene.emission.language);
  return fill_template(fmt::format("{}/driver.{}.mustache", language.name, language.file_extension),
                       TemplateRow{{"module", input.scene.base_name},
                                   {"leaves", leaves_data(language.id)},
                                   {"parameters", parameters_data(input)},
                                   {"functions", functions_data(input)},
                                   {"declared", arrays_data(input)},
                                   {"defaults", defaults_data(input)}});
}

/// A line of the driver: its mark ("=", "!", …), and the text after the mark.
struct DriverAnswer {
  std::string_view mark = {};
  std::string_view text = {};
};

std::vector<DriverAnswer> parse_answers(std::string_view output) {
  std::vector<DriverAnswer> answers;
  while (!output.empty()) {
    std::string_view line = output.substr(0, output.find('\n'));
    output.remove_prefix(std::min(line.size() + 1, output.size()));
    if (!line.starts_with(start_of_line)) continue;
    line.remove_prefix(start_of_line.size());
    const std::size_t space = line.find(' ');
    answers.push_back(
        {line.substr(0, space), space == std::string_view::npos ? "" : line.substr(space + 1)});
  }
  return answers;
}

/// A line of input, "3 2 1 0.10000000000000001 …": the index of the function; then for each kind of
/// leaf, in table order, the number of values and the values.
std::string question_line(std::size_t function, const Arguments<double>& arguments) {
  std::string line = std::to_string(function);
  for (const LeafRow& leaf : leaf_table()) {
    const auto count = static_cast<std::uint32_t>(leaf_count(arguments, leaf.id));
    line += fmt::format(" {}", count);
    for (std::uint32_t i = 0; i < count; ++i) {
      line += fmt::format(" {:.17g}", leaf_of(arguments, leaf.id, i));
    }
  }
  return line + "\n";
}

class InterpretedModel final : public CompiledModel {
 public:
  InterpretedModel(TemporaryDirectory directory, Texts command, const DriverInput& input,
                   std::uint64_t seconds)
      : directory_(std::move(directory)), command_(std::move(command)), seconds_(seconds) {
    for (const Function& function : input.program.functions) names_.push_back(function.name);
  }

  /// Runs the driver once, with these lines as input.
  [[nodiscard]] ProcessResult run_driver(const std::string& questions) const {
    return run_with_input(command_, seconds_, most_output, questions);
  }
  /// The command in messages, without the path of the driver, which has a random name.
  [[nodiscard]] std::string command() const {
    return fmt::format("`{}`", fmt::join(command_.begin(), command_.end() - 1, " "));
  }

  [[nodiscard]] DriverFunction<double> find(std::string_view /*function*/) const override {
    return nullptr;
  }
  [[nodiscard]] Numbers call(std::string_view function,
                             const Arguments<double>& arguments) const override {
    const auto all = call_at_states({function}, {arguments});
    return all ? all->front().front() : Numbers();
  }
  [[nodiscard]] std::vector<float> call(std::string_view /*function*/,
                                        const Arguments<float>& /*arguments*/) const override {
    return {};
  }
  [[nodiscard]] bool has(ScalarKind scalar) const override {
    return scalar == ScalarKind::double_precision;
  }

  using CompiledModel::call_at_states;
  [[nodiscard]] Result<FunctionResults<double>> call_at_states(
      const std::vector<std::string_view>& functions,
      const std::vector<Arguments<double>>& states) const override {
    std::string questions;
    for (const std::string_view function : functions) {
      const auto number = std::ranges::find(names_, function) - names_.begin();
      for (const Arguments<double>& state : states) {
        questions += question_line(static_cast<std::size_t>(number), state);
      }
    }
    const ProcessResult process = run_driver(questions);
    std::vector<DriverAnswer> answers = parse_answers(process.output);
    std::erase_if(answers, [](const DriverAnswer& x) { return x.mark != "=" && x.mark != "!"; });
    if (answers.size() != functions.size() * states.size()) {
      return Diagnostic{Code::E709, {}, failure_text(process, answers.size())};
    }
    FunctionResults<double> values(functions.size());
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const auto numbers = answers[i].mark == "=" ? parse_numbers(answers[i].text) : Numbers();
      values[i / states.size()].push_back(numbers.value_or(Numbers()));
    }
    return values;
  }

  [[nodiscard]] std::string failure_text(const ProcessResult& process, std::size_t answers) const {
    const std::string ended = ending_text(process.ending, process.status, seconds_);
    const std::string after = answers == 0 ? "" : ", after " + count_text(answers, "answer");
    return fmt::format("{} {}{}{}", command(), ended, after, indent_output(process.errors));
  }

 private:
  TemporaryDirectory directory_;
  Texts command_;
  std::uint64_t seconds_;
  Texts names_ = {};
};

/// The reason why the code cannot be called; "" if it can. E705 if the module is refused. Sets the
/// declared numbers in `all`. The driver prints a line before it imports the module, so that a
/// missing interpreter differs from a refused module.
Result<std::string> check_first_run(const InterpretedModel& model,
                                    std::vector<DeclaredNumber>& all) {
  const ProcessResult process = model.run_driver("");
  if (process.ending == ProcessEnding::not_started) return model.command() + " could not be run";
  const std::vector<DriverAnswer> answers = parse_answers(process.output);
  if (answers.empty()) return model.failure_text(process, 0);
  if (answers.front().mark == "!") return std::string(answers.front().text);
  const auto numbers = answers.size() < 2 ? std::nullopt : parse_numbers(answers[1].text);
  if (!process.succeeded() || !numbers || numbers->size() != all.size()) {
    return Diagnostic{Code::E705, {}, model.failure_text(process, answers.size() - 1)};
  }
  for (std::size_t i = 0; i < all.size(); ++i) all[i].declared = (*numbers)[i];
  return std::string();
}

}  // namespace

Result<CompiledHeaders> load_interpreted_module(const EmittedFiles& files, const DriverInput& input,
                                                const Limits& limits) {
  const SourceSpelling& spelling = source_spelling(input.scene.emission.language);
  const std::string ending = fmt::format(".{}", language_row(spelling.language).file_extension);
  const std::string driver =
      "elgen-driver" + ending;  // cannot collide: names of models have no hyphen
  Result<TemporaryDirectory> directory =
      make_source_directory({}, {{input.scene.base_name + ending,
                                  files.files.at(artifact_path(input.scene, ArtifactId::source))},
                                 {driver, driver_text(input)}});
  if (!directory) return directory.diagnostics;
  Texts command = interpreter_of(spelling);
  command.push_back((directory->path() / driver).string());
  auto functions = std::make_unique<InterpretedModel>(std::move(*directory), std::move(command),
                                                      input, limits.seconds);
  std::vector<DeclaredNumber> numbers = declared_numbers(input);
  const Result<std::string> lacking = check_first_run(*functions, numbers);
  if (!lacking) return lacking.diagnostics;
  CompiledHeaders headers(1);
  CompiledHeader& header = headers.front();
  header.roundings = spelling.roundings;
  header.own_implementations = spelling.own_implementations;
  header.failure_reason = *lacking;
  if (!lacking->empty()) return headers;
  header.functions = std::move(functions);
  header.declared = std::move(numbers);
  return headers;
}

}  // namespace elgen
