// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/gnuplot.hpp>

#include <tegotae/lab/child_process.hpp>
#include <tegotae/lab/input_error.hpp>

#include <fmt/format.h>

namespace tegotae {

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
