// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/gnuplot.hpp>

#include <tegotae/lab/child_process.hpp>
#include <tegotae/lab/input_error.hpp>

#include <fmt/format.h>

namespace tegotae {
namespace {

// The last space within the first `columns` characters, rather before a bracket than within; 0: none.
size_t place_to_break(std::string_view text, size_t columns) {
  const size_t bracket = text.rfind(" (", columns), space = text.rfind(' ', columns);
  if (bracket != std::string_view::npos && 3 * bracket > columns) return bracket;
  return space == std::string_view::npos ? 0 : space;
}

}  // namespace

void run_gnuplot(const std::string& name, const std::filesystem::path& folder) {
  const ChildResult result = run_child({"gnuplot", name + ".gnuplot"}, folder);
  if (result.not_found) {
    throw InputError("the figures cannot be drawn, as gnuplot is not there; install it (Debian: gnuplot-nox).");
  }
  if (result.exit_code != 0) {
    throw InputError(fmt::format("{}: gnuplot failed with exit code {}; run 'gnuplot {}.gnuplot' there to see why.",
                                 folder.string(), result.exit_code, name));
  }
}

std::string gnuplot_text(std::string_view text) {
  constexpr std::string_view kMarkup = "_^{}@&~";
  std::string escaped;
  for (const char c : text) {
    if (kMarkup.find(c) != std::string_view::npos) {
      escaped += "\\\\";  // one for the quotes, one for the markup
    } else if (c == '"') {
      escaped += '\\';
    } else if (c == '\\') {
      escaped += "\\\\\\";
    }
    escaped += c;
  }
  return escaped;
}

std::vector<std::string> lines_of(std::string_view text, size_t columns) {
  std::vector<std::string> lines;
  while (text.size() > columns) {
    const size_t space = place_to_break(text, columns);
    const bool at_space = space > 0;
    size_t end = at_space ? space : columns;
    while (!at_space && end > 1 && text[end - 1] == '\\') --end;
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(at_space ? end + 1 : end);
  }
  lines.emplace_back(text);
  return lines;
}

std::string gnuplot_script(const std::string& name, const std::string& settings, const std::string& drawing, int width,
                           int height) {
  const auto terminal = [&](const char* kind, int font, const char* ending) {
    return fmt::format("set terminal {} size {},{} font 'sans,{}' background rgb 'white'\nset output '{}.{}'\n", kind,
                       width, height, font, name, ending);
  };
  return fmt::format("# Draws this figure again: gnuplot {}.gnuplot\nset encoding utf8\n{}", name, settings) +
         terminal("svg", 13, "svg") + drawing + terminal("pngcairo", 10, "png") + drawing + "set output\n";
}

}  // namespace tegotae
