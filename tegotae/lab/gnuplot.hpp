// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tegotae {

/// Lets gnuplot draw NAME.gnuplot in `folder`, its working folder. Throws InputError, a sentence with the mend, where
/// gnuplot is not there or fails.
void run_gnuplot(const std::string& name, const std::filesystem::path& folder);

/// A text as it stands between double quotes in a script and is shown letter by letter: what gnuplot reads as markup or
/// as the end of the text is escaped.
std::string gnuplot_text(std::string_view text);

/// `text` in lines of `columns` characters at most (above 0), broken at spaces, rather before a bracket, else within a
/// word. Markup counts as what it is written with, and an escape is not taken apart.
std::vector<std::string> lines_of(std::string_view text, size_t columns);

/// A script that makes the same `drawing` (gnuplot commands) twice, as NAME.svg and NAME.png of `width` and `height`
/// (pixels, units of the SVG), after `settings`.
std::string gnuplot_script(const std::string& name, const std::string& settings, const std::string& drawing, int width,
                           int height);

}  // namespace tegotae
