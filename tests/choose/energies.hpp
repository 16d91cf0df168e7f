// The energies of energies.txt: models with V as users type it, stable forms of gravity and V that
// keep their digits, and the states near which sums cancel.
#pragma once

#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "elgen/evaluate.hpp"
#include "elgen/model.hpp"
#include "support/models.hpp"
#include "support/shell.hpp"

namespace elgen::test {

/// One entry of energies.txt; lists are split into items.
struct TypedEnergy {
  std::string name = {};
  std::vector<std::string> coordinates = {};  ///< items such as "th rad [-3, 3]"
  std::vector<std::string> parameters = {};   ///< items such as "k = 7 N/m"
  std::vector<std::string> points = {};       ///< items such as "P = a*cos(th); a*sin(th)"
  std::string V = {};
  std::string stable = {};  ///< a stable form of V; "-" if unknown
  std::vector<std::string> gravity = {};
  std::vector<std::string> near = {};  ///< places such as "x ~ y, y = 0.7"
};

/// The items of `list`, without surrounding blanks.
inline std::vector<std::string> items_of(const std::string& list, char separator) {
  std::vector<std::string> items;
  std::istringstream stream(list);
  for (std::string item; std::getline(stream, item, separator);) {
    const std::size_t first = item.find_first_not_of(' ');
    const std::size_t last = item.find_last_not_of(' ');
    if (first != std::string::npos) items.push_back(item.substr(first, last - first + 1));
  }
  return items;
}

inline void read_line(const std::string& key, const std::string& rest, TypedEnergy& energy) {
  if (key == "coordinates") {
    energy.coordinates = items_of(rest, ';');
  } else if (key == "parameters") {
    energy.parameters = items_of(rest, ';');
  } else if (key == "point") {
    energy.points.push_back(rest);
  } else if (key == "V") {
    energy.V = rest;
  } else if (key == "stable") {
    energy.stable = rest;
  } else if (key == "gravity") {
    energy.gravity = items_of(rest, ';');
  } else if (key == "near") {
    energy.near.push_back(rest);
  } else {
    throw std::runtime_error("energies.txt: unknown key " + key);
  }
}

/// The energies of $ELGEN_ENERGIES, or of energies.txt.
inline std::vector<TypedEnergy> typed_energies() {
  std::vector<TypedEnergy> energies;
  const char* const named = std::getenv("ELGEN_ENERGIES");
  const std::string path = named != nullptr ? named : ELGEN_SOURCE_DIR "/tests/choose/energies.txt";
  for (const std::string& line : split_lines(read_text(path))) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream words(line);
    std::string key;
    std::string rest;
    words >> key >> std::ws;
    std::getline(words, rest);
    if (key == "energy") {
      energies.push_back({.name = rest});
    } else {
      read_line(key, rest, energies.at(energies.size() - 1));
    }
  }
  return energies;
}

inline std::string quoted_list(const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "\"" : ", \"") + item + "\"";
  return "[" + text + "]";
}

inline std::string coordinate_entry(const std::string& item) {
  std::istringstream words(item);
  std::string name;
  std::string unit;
  std::string range;
  words >> name >> unit;
  std::getline(words, range);
  if (!range.empty()) range = "range = " + range + "\n";
  return "[[coordinate]]\nname = \"" + name + "\"\nunit = \"" + unit + "\"\n" + range;
}

inline std::string parameter_line(const std::string& item) {
  std::istringstream words(item);
  std::string name;
  std::string equals;
  std::string value;
  std::string unit;
  words >> name >> equals >> value >> unit;
  if (!unit.empty()) unit = ", unit = \"" + unit + "\"";
  return name + " = { value = " + value + unit + ", assume = \"positive\" }\n";
}

inline std::string point_entry(const std::string& line) {
  const std::vector<std::string> sides = items_of(line, '=');
  return "[[point]]\nname = \"" + sides.at(0) +
         "\"\nat = " + quoted_list(items_of(sides.at(1), ';')) + "\n";
}

/// The model text. Its outputs are the stable form of gravity and, if known, the stable form of V.
inline std::string model_of(const TypedEnergy& energy) {
  std::string text;
  std::string T;
  for (const std::string& item : energy.coordinates) {
    text += coordinate_entry(item);
    T += (T.empty() ? "" : " + ") + ("1/2*inertia*dot(" + items_of(item, ' ').front() + ")^2");
  }
  text += "[parameters]\ninertia = 1\n";
  for (const std::string& item : energy.parameters) text += parameter_line(item);
  for (const std::string& line : energy.points) text += point_entry(line);
  text += "[energy]\nT = \"" + T + "\"\nV = \"" + energy.V + "\"\n";
  text += "[[output]]\nname = \"stable_gravity\"\nvalue = " + quoted_list(energy.gravity) + "\n";
  if (energy.stable != "-") {
    text += "[[output]]\nname = \"stable_energy\"\nvalue = \"" + energy.stable + "\"\n";
  }
  return model_text("energy", text);
}

/// The value of a signed sum of names and numbers, such as "y + l" or "-h".
inline double sum_of(const std::string& text, const std::map<std::string, double>& known) {
  double sum = 0;
  for (const std::string& item : items_of(text, ' ')) {
    if (item == "+") continue;
    const bool is_negative = item.front() == '-';
    const std::string name = item.substr(is_negative ? 1 : 0);
    const auto found = known.find(name);
    const double value = found != known.end() ? found->second : std::stod(name);
    sum += is_negative ? -value : value;
  }
  return sum;
}

/// `place` (1 + `step`); `step` if `place` is 0; 1/`step` if `place` is infinite.
inline double displaced(double place, double step) {
  if (std::isinf(place)) return 1 / step;
  return place == 0 ? step : place * (1 + step);
}

/// The states near the places in one line of `near`.
class StatesNear {
 public:
  StatesNear(const Model& model, const std::string& line) : model_(model) {
    for (const Parameter& parameter : model.parameters) {
      known_[parameter.name] = to_double(parameter.value);
    }
    known_["pi"] = 3.141592653589793;
    known_["halfpi"] = 1.5707963267948966;
    for (const std::string& item : items_of(line, ',')) {
      const std::size_t equals = item.find(" = ");
      const std::size_t tilde = item.find(" ~ ");
      if (equals != std::string::npos) {
        known_[item.substr(0, equals)] = sum_of(item.substr(equals + 3), known_);
      } else {
        approached_.push_back({item.substr(0, tilde), item.substr(tilde + 3)});
      }
    }
  }

  /// The coordinates of up to four states, about `distance` away from the places, on both sides.
  /// States outside the ranges are left out.
  [[nodiscard]] std::vector<std::vector<double>> at(double distance) const {
    const std::vector<std::vector<double>> shares{{1, -0.8125, 0.59375, -1.15625},
                                                  {0.71875, 0.90625, -1.0625, -0.65625}};
    std::vector<std::vector<double>> states;
    for (std::size_t turn = 0; turn < shares[0].size(); ++turn) {
      std::map<std::string, double> values = known_;
      for (std::size_t i = 0; i < approached_.size(); ++i) {
        const double place = sum_of(approached_[i].place, values);
        values[approached_[i].coordinate] = displaced(place, distance * shares.at(i)[turn]);
      }
      add_inside(values, states);
    }
    return states;
  }

 private:
  struct Approached {
    std::string coordinate;
    std::string place;
  };

  void add_inside(const std::map<std::string, double>& values,
                  std::vector<std::vector<double>>& states) const {
    std::vector<double> q;
    for (const Coordinate& coordinate : model_.coordinates) {
      const double x = values.at(coordinate.name);
      const std::optional<Interval>& range = coordinate.range;
      if (range && (x < to_double(range->low) || x > to_double(range->high))) return;
      q.push_back(x);
    }
    states.push_back(q);
  }

  const Model& model_;
  std::map<std::string, double> known_ = {};
  std::vector<Approached> approached_ = {};
};

}  // namespace elgen::test
