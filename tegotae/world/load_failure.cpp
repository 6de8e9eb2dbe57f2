// SPDX-License-Identifier: Apache-2.0
#include <tegotae/world/load_failure.hpp>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cctype>
#include <regex>

namespace tegotae {
namespace {

// Elements, attributes and keywords of MJCF that came after 2.2.2: the usual ones, each between spaces.
constexpr std::string_view kNewerElements =
    " attach clock deformable distance e_kinetic e_potential edge elasticity extension flex flexcomp flexstrain"
    " flexvert frame fromto insidesite layer model normal pin plugin replicate tactile ";
constexpr std::string_view kNewerAttributes =
    " actdim actearly actuatorfrclimited actuatorfrcrange actuatorgravcomp actuatorgroupdisable align alignfree"
    " autoreset bvactive ccd_iterations ccd_tolerance colorspace content_type dampratio eulerdamp focal focalpixel"
    " gravcomp hdri island ls_iterations ls_tolerance maxhullvert memory midphase nativeccd octree_depth"
    " orthographic plugin principal principalpixel projection resolution saveinertial sdf_initpoints"
    " sdf_iterations sensorsize sleep sleep_tolerance ";
constexpr std::string_view kNewerKeywords =
    " allowed convex dcmotor exact flex implicitfast init legacy never sdf shell ";

bool contains(std::string_view list, const std::string& word) {
  return !word.empty() && list.find(" " + word + " ") != std::string_view::npos;
}

bool contains_text(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

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

// A missing file that the scene includes, a fault of markup, or empty.
std::string describe_xml_failure(const std::string& where, const std::string& text) {
  const std::string code = first_match(text, "XML_ERROR_([A-Z_]+)");
  if (code.empty()) return {};
  // The scene itself is there, so it is an <include>; MuJoCo says "filename=gone.xml".
  const std::string included = first_match(text, "filename=([^\\n]+)");
  if (code == "FILE_NOT_FOUND" && !included.empty()) {
    return fmt::format(
        "{}: the file '{}' of an <include> is not there, or it may not be read; correct its path, which is relative to "
        "the scene's folder",
        where, included);
  }
  const std::string detail = first_match(text, "Line number=[0-9]+: *([^\\n]+)");
  return fmt::format("{}: malformed XML ({}{}{}); correct the markup there", where, words_of(code),
                     detail.empty() ? "" : ": ", detail);
}

std::string mend_for(const std::string& text) {
  // MuJoCo 2.2.2 counts no pairs for planes on more than one body.
  if (contains_text(text, "Broadphase buffer full")) {
    return "more than one body has a plane; only the world may have planes, make those of other bodies thin boxes";
  }
  if (contains_text(text, "annot open file") || contains_text(text, "ould not open")) {
    return "put the file there or correct its path";
  }
  const std::string missing = first_match(text, "('[^']*') not found");
  if (!missing.empty()) return fmt::format("define {} (meshes and the like in <asset>) or correct the name", missing);
  return "correct it there";
}

}  // namespace

std::string describe_load_failure(std::string_view file, std::string_view engine_text) {
  const std::string text(engine_text);
  const std::string where = place(file, text);
  std::string malformed = describe_xml_failure(where, text);
  if (!malformed.empty()) return malformed;
  std::string reason = std::regex_replace(text, std::regex("^(XML )?Error: (Schema violation: )?"), "");
  reason = std::regex_replace(reason, std::regex(",? *line *=? *-?[0-9]+|,? *column *= *-?[0-9]+"), "");
  reason = std::regex_replace(reason, std::regex("Object name = , id = (-?[0-9]+)"), "unnamed object (id $1)");
  reason = std::regex_replace(reason, std::regex("Object name = ([^,\\n]*), id = (-?[0-9]+)"), "object '$1' (id $2)");
  reason = std::regex_replace(reason, std::regex("Element '"), "in element '");
  reason = on_one_line(reason);
  if (is_newer_markup(text)) {
    return fmt::format("{}: this scene needs a newer MuJoCo than {}: {}; remove it or write it in the older form",
                       where, mj_versionString(), reason);
  }
  return fmt::format("{}: MuJoCo {} refuses the scene: {}; {}", where, mj_versionString(), reason, mend_for(text));
}

}  // namespace tegotae
