// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace tegotae {

/// Lets gnuplot draw NAME.gnuplot in `folder`, its working folder. Throws InputError, a sentence with the mend, where
/// gnuplot is not there or fails.
void run_gnuplot(const std::string& name, const std::filesystem::path& folder);

/// A script that makes the same `drawing` (gnuplot commands) twice, as NAME.svg and NAME.png of `width` and `height`
/// (pixels, units of the SVG), after `settings`.
std::string gnuplot_script(const std::string& name, const std::string& settings, const std::string& drawing, int width,
                           int height);

}  // namespace tegotae
