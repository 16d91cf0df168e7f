// interpreted: a driver script imports the module, says what it declares, and answers a line of
// hexadecimal floats for every line of them:
//
//     0 0x1p+0 0x1.8p-1 …      ->      elgen: = 0x1.921fb54442d18p+1 …
//                                      elgen: ! ZeroDivisionError: …
//
// Other lines are somebody's else: they are not read.
#include "toolchain/interpreted.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <utility>

#include "elgen/artifacts.hpp"
#include "elgen/spellings.hpp"
#include "emit/interface/code_interface.hpp"
#include "numbers/exact_number.hpp"
#include "render/fill_template.hpp"
#include "toolchain/process.hpp"
#include "toolchain/workshop.hpp"

namespace elgen {
namespace {

using Texts = std::vector<std::string>;
using Numbers = std::vector<double>;

constexpr std::string_view start_of_line = "elgen: ";
constexpr std::size_t most_output = std::size_t{1} << 30U;

/// The command, of the environment or of the language.
Texts interpreter_of(const SourceSpelling& spelling) {
  const char* const chosen = std::getenv(std::string(spelling.variable).c_str());
  return words_of_command(chosen != nullptr && *chosen != '\0' ? chosen
                                                               : std::string(spelling.command));
}

/// "x[0], (x[1], default.l[1])": what the struct of parameters is made of.
std::string parameter_values(const DriverInput& input) {
  const LeafNames& leaves = input.program.leaves;
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < leaves.parameters.size(); ++i) places[leaves.parameters[i]] = i;
  Texts values;
  for (const ParameterArray& array : emitted_parameters(input.model, input.program)) {
    Texts elements;
    const std::string name = spelt_name(input.scene.emission.language, array.name);
    for (std::uint32_t i = 0; i < array.count; ++i) {
      const auto found = places.find(input.model.parameters[array.first + i].name);
      elements.push_back(found == places.end() ? fmt::format("default.{}[{}]", name, i)
                                               : fmt::format("x[{}]", found->second));
    }
    values.push_back(array.is_array ? fmt::format("({},)", fmt::join(elements, ", "))
                                    : elements.front());
  }
  return fmt::format("{}", fmt::join(values, ", "));
}

/// The numbers that a module declares, as expressions of the driver.
class Declared {
 public:
  explicit Declared(const DriverInput& input) {
    for (const DeclaredArray& array : declared_arrays(input.model)) add_array(array);
    for (const ParameterArray& array : emitted_parameters(input.model, input.program)) {
      add_parameter(input, array);
    }
  }

  [[nodiscard]] const Texts& expressions() const { return expressions_; }
  [[nodiscard]] std::vector<DeclaredNumber> take() && { return std::move(numbers_); }

 private:
  void add(const std::string& name, std::string expression, double of_model) {
    expressions_.push_back(std::move(expression));
    numbers_.push_back({name, 0, of_model});
  }

  void add_array(const DeclaredArray& array) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    add("the size of " + array.name, fmt::format("len(code.{})", array.name),
        static_cast<double>(array.size()));
    for (std::size_t i = 0; i < array.numbers.size(); ++i) {
      const std::string element = fmt::format("{}[{}]", array.name, i);
      add(element, "code." + element, ScalarTraits<double>::from_real(array.numbers[i]));
    }
    for (std::size_t i = 0; i < array.intervals.size(); ++i) {
      const std::string element = fmt::format("{}[{}]", array.name, i);
      const std::optional<Interval>& interval = array.intervals[i];
      add(element + ".low", fmt::format("code.{}[0]", element),
          interval ? ScalarTraits<double>::from_real(interval->low) : -infinity);
      add(element + ".high", fmt::format("code.{}[1]", element),
          interval ? ScalarTraits<double>::from_real(interval->high) : infinity);
    }
  }

  void add_parameter(const DriverInput& input, const ParameterArray& array) {
    const std::string name = spelt_name(input.scene.emission.language, array.name);
    const std::vector<cln::cl_R> values = values_of(input.model, array);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string member = array.is_array ? fmt::format("{}[{}]", name, i) : name;
      add(member, "default." + member, ScalarTraits<double>::from_real(values[i]));
    }
  }

  Texts expressions_ = {};
  std::vector<DeclaredNumber> numbers_ = {};
};

TemplateData leaves_data() {
  return rows_data(leaf_table(), [](const LeafRow& leaf) {
    return TemplateRow{{"name", std::string(leaf.symbol)},
                       {"first", std::string(is_single(leaf.id) ? "[0]" : "")}};
  });
}

TemplateData functions_data(const DriverInput& input) {
  return rows_data(input.program.functions, [&](const Function& function) {
    Texts arguments;
    for (const Opcode argument : arguments_of(input.model, function)) {
      arguments.push_back(fmt::format("x[\"{}\"]", leaf_row(argument).symbol));
    }
    return TemplateRow{{"name", spelt_name(input.scene.emission.language, function.name)},
                       {"arguments", fmt::format("{}", fmt::join(arguments, ", "))}};
  });
}

std::string driver_text(const DriverInput& input, const Texts& declared) {
  return fill_template(
      fmt::format("{}/driver.{}.mustache", language_row(input.scene.emission.language).name,
                  language_row(input.scene.emission.language).ending),
      TemplateRow{{"module", input.scene.base_name},
                  {"leaves", leaves_data()},
                  {"parameters", parameter_values(input)},
                  {"functions", functions_data(input)},
                  {"numbers", lines_data(declared)}});
}

/// "0x1.8p+0", "-0x0.0p+0", "inf", "nan".
std::optional<double> hexadecimal(std::string_view word) {
  const bool is_negative = word.starts_with('-');
  if (is_negative) word.remove_prefix(1);
  if (word.starts_with("0x")) word.remove_prefix(2);
  double value = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value, std::chars_format::hex);
  if (error != std::errc() || stop != end) return std::nullopt;
  return is_negative ? -value : value;
}

/// A line of the driver: its mark, and what stands behind it.
struct Answer {
  std::string_view mark = {};
  std::string_view text = {};
};

std::vector<Answer> answers_in(std::string_view output) {
  std::vector<Answer> answers;
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

std::optional<Numbers> hexadecimals(std::string_view text) {
  Numbers numbers;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    const std::optional<double> value = hexadecimal(word);
    if (!value) return std::nullopt;
    numbers.push_back(*value);
    text.remove_prefix(std::min(word.size() + 1, text.size()));
  }
  return numbers;
}

/// "3 2 0x1p+0 0x1p+1 …": the function and all leaves, in the order of the table, behind their counts.
std::string question(std::size_t function, const Arguments<double>& arguments) {
  std::string line = std::to_string(function);
  for (const LeafRow& leaf : leaf_table()) {
    const auto count = static_cast<std::uint32_t>(leaf_count(arguments, leaf.id));
    line += fmt::format(" {}", count);
    for (std::uint32_t i = 0; i < count; ++i) {
      line += fmt::format(" {:a}", leaf_of(arguments, leaf.id, i));
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

  /// What the driver says to these questions.
  [[nodiscard]] ProcessResult said(const std::string& questions) const {
    return run_apart(command_, seconds_, most_output, questions);
  }
  [[nodiscard]] std::string command() const {
    return fmt::format("`{}`", fmt::join(command_, " "));
  }

  [[nodiscard]] DriverFunction<double> find(std::string_view /*function*/) const override {
    return nullptr;
  }
  [[nodiscard]] Numbers call(std::string_view function,
                             const Arguments<double>& arguments) const override {
    const auto all = call_all({function}, {arguments});
    return all ? all->front().front() : Numbers();
  }
  [[nodiscard]] std::vector<float> call(std::string_view /*function*/,
                                        const Arguments<float>& /*arguments*/) const override {
    return {};
  }
  [[nodiscard]] bool has(ScalarKind scalar) const override {
    return scalar == ScalarKind::double_precision;
  }

  [[nodiscard]] Result<ValuesOfFunctions> call_all(
      const std::vector<std::string_view>& functions,
      const std::vector<Arguments<double>>& states) const override {
    std::string questions;
    for (const std::string_view function : functions) {
      const auto number = std::ranges::find(names_, function) - names_.begin();
      for (const Arguments<double>& state : states) {
        questions += question(static_cast<std::size_t>(number), state);
      }
    }
    const ProcessResult process = said(questions);
    std::vector<Answer> answers = answers_in(process.output);
    std::erase_if(answers, [](const Answer& x) { return x.mark != "=" && x.mark != "!"; });
    if (answers.size() != functions.size() * states.size()) {
      return Diagnostic{Code::E709, {}, why_silent(process, answers.size())};
    }
    ValuesOfFunctions values(functions.size());
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const auto numbers = answers[i].mark == "=" ? hexadecimals(answers[i].text) : Numbers();
      values[i / states.size()].push_back(numbers.value_or(Numbers()));
    }
    return values;
  }

  [[nodiscard]] std::string why_silent(const ProcessResult& process, std::size_t answers) const {
    const std::string ended = process.ending == Ending::out_of_time
                                  ? fmt::format("has not ended within {} s", seconds_)
                                  : ending_text(process.ending, process.status);
    return fmt::format("{} {} after {} answers{}{}", command(), ended, answers,
                       process.errors.empty() ? "" : ":\n", plain_text(process.errors));
  }

 private:
  TemporaryDirectory directory_;
  Texts command_;
  std::uint64_t seconds_;
  Texts names_ = {};
};

/// Why there is no code to call; empty where there is. Reads the declared numbers.
Result<std::string> first_answer(const InterpretedModel& model, std::vector<DeclaredNumber>& all) {
  const ProcessResult process = model.said("");
  if (process.ending == Ending::not_started) return model.command() + " could not be run";
  const std::vector<Answer> answers = answers_in(process.output);
  if (!answers.empty() && answers.front().mark == "!") return std::string(answers.front().text);
  const auto numbers = answers.empty() ? std::nullopt : hexadecimals(answers.front().text);
  if (!process.succeeded() || !numbers || numbers->size() != all.size()) {
    return Diagnostic{Code::E705, {}, model.why_silent(process, answers.size())};
  }
  for (std::size_t i = 0; i < all.size(); ++i) all[i].declared = (*numbers)[i];
  return std::string();
}

bool write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  stream.close();
  return stream.good();
}

}  // namespace

Result<CompiledHeaders> interpret(const EmittedFiles& files, const DriverInput& input,
                                  const Limits& limits) {
  const SourceSpelling& spelling = source_spelling(input.scene.emission.language);
  std::optional<TemporaryDirectory> directory = TemporaryDirectory::create();
  const std::string ending(language_row(input.scene.emission.language).ending);
  Declared declared(input);
  const Artifact module = artifacts_of(input.scene).front();
  const bool is_written = directory &&
                          write(directory->path() / (input.scene.base_name + "." + ending),
                                files.files.at(module.path)) &&
                          write(directory->path() / ("elgen_driver." + ending),
                                driver_text(input, declared.expressions()));
  if (!is_written) {
    return Diagnostic{
        Code::E706, {}, "no temporary directory could be written; $TMPDIR names another"};
  }
  Texts command = interpreter_of(spelling);
  command.push_back((directory->path() / ("elgen_driver." + ending)).string());
  auto functions = std::make_unique<InterpretedModel>(std::move(*directory), std::move(command),
                                                      input, limits.seconds);
  std::vector<DeclaredNumber> numbers = std::move(declared).take();
  const Result<std::string> lacking = first_answer(*functions, numbers);
  if (!lacking) return lacking.diagnostics;
  CompiledHeaders headers(1);
  CompiledHeader& header = headers.front();
  header.roundings = spelling.roundings;
  header.own_implementations = spelling.own_implementations;
  header.lacking = *lacking;
  if (!lacking->empty()) return headers;
  header.functions = std::move(functions);
  header.declared = std::move(numbers);
  return headers;
}

}  // namespace elgen
