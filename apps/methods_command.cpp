// SPDX-License-Identifier: Apache-2.0
#include <apps/commands.hpp>
#include <tegotae/render/rendering_method.hpp>

#include <fmt/format.h>

namespace tegotae {

void add_methods_command(CLI::App& program) {
  CLI::App* const command = program.add_subcommand("methods", "List the rendering methods.");
  command->callback([] {
    for (const MethodName& method : method_names()) fmt::print("{:<16}{}\n", method.name, method.summary);
  });
}

}  // namespace tegotae
