// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

namespace tegotae {

/// A text of a figure, and the rectangle that it takes at most.
struct SvgText {
  std::string text;
  double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;
};

/// The texts of an SVG that gnuplot wrote. Widths are estimated: 0.6 of the font's size a letter, and a third more, as
/// the PNG of the same drawing has its title that much larger.
inline std::vector<SvgText> svg_texts(const std::string& svg) {
  static const std::regex group(
      R"re(<g transform="translate\(([-\d.]+),([-\d.]+)\)( rotate\(270\))?"[^>]*font-size="([\d.]+)"[^>]*text-anchor="(\w+)">\s*<text>([^\n]*)</text>)re");
  static const std::regex tag("<[^>]*>"), entity("&[a-z]+;");
  std::vector<SvgText> texts;
  for (std::sregex_iterator match(svg.begin(), svg.end(), group), end; match != end; ++match) {
    SvgText text;
    text.text = std::regex_replace(std::regex_replace((*match)[6].str(), tag, ""), entity, "&");
    const double x = std::stod((*match)[1]), y = std::stod((*match)[2]), size = std::stod((*match)[4]) * 4.0 / 3.0;
    const double length = 0.6 * size * static_cast<double>(text.text.size());
    const std::string anchor = (*match)[5];
    const double before = anchor == "start" ? 0.0 : anchor == "middle" ? 0.5 * length : length;
    if ((*match)[3].matched) {  // read upwards
      text.left = x - size;
      text.right = x;
      text.top = y + before - length;
      text.bottom = y + before;
    } else {
      text.left = x - before;
      text.right = x - before + length;
      text.top = y - size;
      text.bottom = y;
    }
    texts.push_back(text);
  }
  return texts;
}

/// Those of its texts that may leave the picture.
inline std::vector<std::string> texts_outside(const std::string& svg) {
  static const std::regex size(R"re(width="(\d+)" height="(\d+)")re");
  std::smatch found;
  if (!std::regex_search(svg, found, size)) return {"no size"};
  const double width = std::stod(found[1]), height = std::stod(found[2]);
  std::vector<std::string> outside;
  for (const SvgText& text : svg_texts(svg)) {
    const bool is_inside = text.left >= 0.0 && text.right <= width && text.top >= 0.0 && text.bottom <= height;
    if (!is_inside) outside.push_back(text.text);
  }
  return outside;
}

/// Whether a line of one of its texts reads so.
inline bool shows_text(const std::string& svg, const std::string& wanted) {
  const std::vector<SvgText> texts = svg_texts(svg);
  return std::any_of(texts.begin(), texts.end(), [&](const SvgText& text) { return text.text == wanted; });
}

}  // namespace tegotae
