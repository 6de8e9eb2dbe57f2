// SPDX-License-Identifier: Apache-2.0
#include <tegotae/world/load_failure.hpp>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <regex>

namespace tegotae {
namespace {

using std::string_view_literals::operator""sv;

// Elements, attributes and keywords of MJCF that came after 2.2.2: the usual ones.
constexpr std::array kNewerElements = {
    "attach"sv,    "deformable"sv, "e_kinetic"sv, "e_potential"sv, "edge"sv,       "elasticity"sv,
    "extension"sv, "flex"sv,       "flexcomp"sv,  "flexvert"sv,    "frame"sv,      "insidesite"sv,
    "layer"sv,     "model"sv,      "pin"sv,       "plugin"sv,      "replicate"sv,  "tactile"sv,
    "distance"sv,  "normal"sv,     "fromto"sv,    "clock"sv,       "flexstrain"sv,
};
constexpr std::array kNewerAttributes = {
    "actdim"sv,
    "actearly"sv,
    "actuatorfrclimited"sv,
    "actuatorfrcrange"sv,
    "actuatorgravcomp"sv,
    "actuatorgroupdisable"sv,
    "align"sv,
    "alignfree"sv,
    "autoreset"sv,
    "builtin"sv,
    "bvactive"sv,
    "ccd_iterations"sv,
    "ccd_tolerance"sv,
    "colorspace"sv,
    "content_type"sv,
    "dampratio"sv,
    "eulerdamp"sv,
    "fitaabb"sv,
    "focal"sv,
    "focalpixel"sv,
    "gravcomp"sv,
    "hdri"sv,
    "island"sv,
    "ls_iterations"sv,
    "ls_tolerance"sv,
    "maxhullvert"sv,
    "memory"sv,
    "midphase"sv,
    "mpos"sv,
    "mquat"sv,
    "multiccd"sv,
    "nativeccd"sv,
    "octree_depth"sv,
    "orthographic"sv,
    "plugin"sv,
    "principal"sv,
    "principalpixel"sv,
    "projection"sv,
    "resolution"sv,
    "saveinertial"sv,
    "sdf_initpoints"sv,
    "sdf_iterations"sv,
    "sensorsize"sv,
    "shellinertia"sv,
    "sleep"sv,
    "sleep_tolerance"sv,
    "solreffriction"sv,
};
constexpr std::array kNewerKeywords = {
    "implicitfast"sv, "flex"sv,   "sdf"sv,     "dcmotor"sv, "shell"sv, "exact"sv,
    "convex"sv,       "legacy"sv, "allowed"sv, "never"sv,   "init"sv,
};

template <size_t count>
bool contains(const std::array<std::string_view, count>& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

std::string first_match(const std::string& text, const char* pattern) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(pattern)) ? match[1].str() : std::string();
}

// Line breaks become "; ", so that the message is one line.
std::string on_one_line(const std::string& text) {
  const std::string joined = std::regex_replace(text, std::regex("\\s*[\\r\\n]+\\s*"), "; ");
  return std::regex_replace(joined, std::regex("^[;\\s]+|[;:\\s]+$"), "");
}

std::string place(std::string_view file, const std::string& text) {
  const std::string line = first_match(text, "[Ll]ine(?: number)?\\s*=?\\s*([0-9]+)");
  return line.empty() || line == "0" ? std::string(file) : fmt::format("{}, line {}", file, line);
}

// "XML_ERROR_MISMATCHED_ELEMENT" -> "mismatched element".
std::string words_of(std::string code) {
  std::transform(code.begin(), code.end(), code.begin(),
                 [](unsigned char c) { return c == '_' ? ' ' : static_cast<char>(std::tolower(c)); });
  return code;
}

bool is_newer_markup(const std::string& text) {
  const std::string element = first_match(text, "unrecognized element[^']*'([^']*)'");
  const std::string attribute = first_match(text, "unrecognized attribute[^']*'([^']*)'");
  const std::string keyword = first_match(text, "invalid keyword[^']*'([^']*)'");
  return contains(kNewerElements, element) || contains(kNewerAttributes, attribute) ||
         contains(kNewerKeywords, keyword);
}

}  // namespace

std::string describe_load_failure(std::string_view file, std::string_view engine_text) {
  const std::string text(engine_text);
  const std::string where = place(file, text);
  const std::string xml_code = first_match(text, "XML_ERROR_([A-Z_]+)");
  if (!xml_code.empty()) {
    const std::string detail = first_match(text, "Line number=[0-9]+: *([^\\n]+)");
    return fmt::format("{}: malformed XML ({}{}{}); correct the markup there", where, words_of(xml_code),
                       detail.empty() ? "" : ": ", detail);
  }
  std::string reason = std::regex_replace(text, std::regex("^(XML )?Error: (Schema violation: )?"), "");
  reason = std::regex_replace(reason, std::regex(",? *line *=? *-?[0-9]+|,? *column *= *-?[0-9]+"), "");
  reason = std::regex_replace(reason, std::regex("Object name = ([^,\\n]*), id = (-?[0-9]+)"), "object '$1' (id $2)");
  reason = std::regex_replace(reason, std::regex("Element '"), "in element '");
  reason = on_one_line(reason);
  if (is_newer_markup(text)) {
    return fmt::format(
        "{}: this scene needs MuJoCo 3.x; this build reads {}'s MJCF: {}; remove it or write it in the "
        "older form",
        where, mj_versionString(), reason);
  }
  return fmt::format("{}: MuJoCo {} refuses the scene: {}; correct it there", where, mj_versionString(), reason);
}

}  // namespace tegotae
