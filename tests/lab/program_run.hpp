// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tests/lab/temporary_folder.hpp>

#include <sys/wait.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace tegotae {

struct ProgramResult {
  int exit_code = -1;
  std::string out, err;
};

/// Runs the built program `tegotae` with these arguments, through a shell as a person would. `environment`:
/// "NAME=value" words before the command.
inline ProgramResult run_program(const std::vector<std::string>& arguments, const std::string& environment = "") {
  const TemporaryFolder streams;
  const std::string out = (streams.path() / "out").string(), err = (streams.path() / "err").string();
  std::string command = environment + " '" TEGOTAE_PROGRAM "'";
  for (const std::string& argument : arguments) command += " '" + argument + "'";
  command += " >'" + out + "' 2>'" + err + "' </dev/null";
  const int status = std::system(command.c_str());  // NOLINT(bugprone-command-processor,concurrency-mt-unsafe)
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), contents_of(out), contents_of(err)};
}

}  // namespace tegotae
