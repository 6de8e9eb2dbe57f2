// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_file.hpp>

#include <tegotae/device/spidar_presets.hpp>
#include <tegotae/device/spidar_reach.hpp>

#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace tegotae {
namespace {

// Beyond these a number was given in another unit: a frame stands on a table, a pulse is a step of a pulley.
constexpr double kFarthestPlace = 5.0;     // m
constexpr double kLargestPulse = 1e-3;     // m
constexpr double kLargestTension = 200.0;  // N

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file.string()) {}

  SpidarGeometry read(std::istream& stream) {
    for (std::string text; std::getline(stream, text);) {
      ++line_;
      std::istringstream words(text.substr(0, text.find('#')));
      std::string word;
      if (words >> word) take(word, words);
    }
    if (count_ < geometry_.strings.size()) {
      line_ = 0;
      refuse("it has " + std::to_string(count_) + " strings and a SPIDAR-G6 has 8; add a line 'string' for each");
    }
    if (!unused_.empty()) {
      line_ = unused_line_;
      refuse("'" + unused_ + "' holds for the strings below it, and there are none; write it above them");
    }
    return geometry_;
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw SpidarFileError(file_ + (line_ > 0 ? ":" + std::to_string(line_) : "") + ": " + what + ".");
  }

 private:
  void take(const std::string& word, std::istringstream& words) {
    if (word == "metres_per_pulse" || word == "volts_per_newton" || word == "tension" || word == "left_handed") {
      unused_ = word;
      unused_line_ = line_;
    }
    if (word == "name") {
      if (!(words >> geometry_.name)) refuse("'name' needs a name; write 'name NAME'");
      if (geometry_.name.find('/') != std::string::npos) refuse("a name with '/' would be a path; leave it out");
      expect_end(words);
    } else if (word == "metres_per_pulse") {
      common_.metres_per_pulse = number(word, words);
      if (!(common_.metres_per_pulse > 0.0 && common_.metres_per_pulse <= kLargestPulse)) {
        refuse("'metres_per_pulse' must be above 0 and at most 1e-3 m; a sign stands at the end of its 'string'");
      }
      has_pulse_ = true;
    } else if (word == "volts_per_newton") {
      common_.volts_per_newton = number(word, words);
      has_volts_ = true;
    } else if (word == "tension") {
      const std::vector<double> values = numbers(words);
      if (values.size() != 2) refuse("'tension' needs two numbers; write 'tension LEAST GREATEST', in newtons");
      common_.min_tension = values[0];
      common_.max_tension = values[1];
      if (!(0.0 < values[0] && values[0] < values[1] && values[1] <= kLargestTension)) {
        refuse("'tension' needs 0 < LEAST < GREATEST <= 200 N");
      }
      has_tension_ = true;
    } else if (word == "axial_stiffness") {
      geometry_.axial_stiffness = number(word, words);
    } else if (word == "left_handed") {
      is_left_handed_ = true;
      expect_end(words);
    } else if (word == "string") {
      take_string(numbers(words));
    } else {
      refuse("there is no word '" + word +
             "'; there are: name, metres_per_pulse, volts_per_newton, tension, axial_stiffness, left_handed, string");
    }
  }

  void take_string(const std::vector<double>& values) {
    if (values.size() != 6 && values.size() != 7) {
      refuse("'string' needs 6 or 7 numbers and has " + std::to_string(values.size()) +
             "; write 'string X Y Z KX KY KZ SIGN': motor and knot in metres, 1 or -1");
    }
    if (!has_pulse_ || !has_volts_ || !has_tension_) {
      refuse("above the first string there must be 'metres_per_pulse', 'volts_per_newton' and 'tension'");
    }
    unused_.clear();
    for (int i = 0; i < 6; ++i) {
      if (std::abs(values[static_cast<std::size_t>(i)]) > kFarthestPlace) {
        refuse("a motor or knot is more than 5 m from the middle; places are in metres, not millimetres");
      }
    }
    if (count_ == geometry_.strings.size()) refuse("this is the ninth string, and a SPIDAR-G6 has 8; remove one");
    if (values.size() == 7 && std::abs(values[6]) != 1.0) {
      refuse("the sign of a count must be 1 or -1 (the count falls as the string grows longer)");
    }
    SpidarString string = common_;
    const Vector3 motor(values[0], values[1], values[2]), knot(values[3], values[4], values[5]);
    string.motor_S = is_left_handed_ ? from_left_handed(motor) : motor;
    string.knot_G = is_left_handed_ ? from_left_handed(knot) : knot;
    if (values.size() == 7) string.metres_per_pulse *= values[6];
    geometry_.strings[count_++] = string;
  }

  std::vector<double> numbers(std::istringstream& words) const {
    std::vector<double> result;
    for (std::string word; words >> word;) {
      std::istringstream text(word);
      double value = 0.0;
      if (!(text >> value) || !(text >> std::ws).eof() || !std::isfinite(value)) {
        refuse("'" + word + "' is not a finite number; write it as 0.05 or 5e-2");
      }
      result.push_back(value);
    }
    return result;
  }

  double number(const std::string& word, std::istringstream& words) const {
    const std::vector<double> values = numbers(words);
    if (values.size() != 1) refuse("'" + word + "' needs one number; write '" + word + " NUMBER'");
    return values[0];
  }

  void expect_end(std::istringstream& words) const {
    std::string word;
    if (words >> word) refuse("'" + word + "' is too much on this line; remove it");
  }

  std::string file_;
  std::size_t line_ = 0, count_ = 0;
  bool is_left_handed_ = false, has_pulse_ = false, has_volts_ = false, has_tension_ = false;
  std::string unused_;  ///< the last word that holds for strings below it, while there are none
  std::size_t unused_line_ = 0;
  SpidarString common_;
  SpidarGeometry geometry_;
};

}  // namespace

SpidarGeometry read_spidar_file(const std::filesystem::path& file) {
  Reader reader(file);
  std::ifstream stream(file);
  std::error_code error;
  if (!stream || std::filesystem::is_directory(file, error)) {
    reader.refuse("no such file, or it may not be read; name a file with a SPIDAR's geometry");
  }
  SpidarGeometry geometry = reader.read(stream);
  if (geometry.name.empty()) geometry.name = file.stem().string();
  try {
    check_force_closure(geometry);
  } catch (const std::invalid_argument& fault) {
    throw SpidarFileError(file.string() + ": " + fault.what());
  }
  return geometry;
}

SpidarGeometry find_spidar_geometry(std::string_view preset_or_file) {
  std::string names;
  for (const SpidarPreset& preset : spidar_presets()) {
    if (preset.name == preset_or_file) return preset.geometry;
    if (!preset.is_refused) names.append(names.empty() ? "" : ", ").append(preset.name);
  }
  std::error_code error;
  if (!std::filesystem::exists(preset_or_file, error)) {
    throw SpidarFileError("'" + std::string(preset_or_file) + "' is neither a SPIDAR that has a name (" + names +
                          ") nor a file with the geometry of one.");
  }
  return read_spidar_file(preset_or_file);
}

}  // namespace tegotae
