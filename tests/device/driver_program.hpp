// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace tegotae::test {

/// What a driver_probe printed, and how it ended.
struct ProbeResult {
  std::string text;
  int exit_code = -1;
};

/// Runs driver_probe in an environment in which the makers' libraries are those of the doubles' folders `folders`
/// (separated by ':'), or none.
inline ProbeResult run_probe(const std::string& folders, const std::string& arguments) {
  std::string paths;
  for (std::size_t begin = 0; begin < folders.size();) {
    const std::size_t end = std::min(folders.find(':', begin), folders.size());
    paths += std::string(TEGOTAE_DOUBLES) + '/' + folders.substr(begin, end - begin) + ':';
    begin = end + 1;
  }
  const std::string command = "LD_LIBRARY_PATH='" + paths + "' '" + TEGOTAE_DRIVER_PROBE + "' " + arguments + " 2>&1";
  std::FILE* pipe = popen(command.c_str(), "r");
  ProbeResult result;
  if (pipe == nullptr) return result;
  char buffer[512];
  for (std::size_t size = 0; (size = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) result.text.append(buffer, size);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  return result;
}

/// A driver_probe that displays a force until it is killed.
class HoldingProbe {
 public:
  HoldingProbe(const std::string& folder, const std::string& driver, const std::string& options) {
    std::vector<std::string> environment;
    for (char** each = environ; *each != nullptr; ++each) {
      if (std::string(*each).rfind("LD_LIBRARY_PATH=", 0) != 0) environment.emplace_back(*each);
    }
    environment.push_back("LD_LIBRARY_PATH=" + std::string(TEGOTAE_DOUBLES) + '/' + folder);
    std::vector<std::string> arguments = {TEGOTAE_DRIVER_PROBE, "hold", driver, options};
    const auto pointers = [](std::vector<std::string>& texts) {
      std::vector<char*> result;
      for (std::string& text : texts) result.push_back(text.data());
      result.push_back(nullptr);
      return result;
    };
    const int error = posix_spawn(&pid_, TEGOTAE_DRIVER_PROBE, nullptr, nullptr, pointers(arguments).data(),
                                  pointers(environment).data());
    EXPECT_EQ(error, 0);
  }
  HoldingProbe(const HoldingProbe&) = delete;
  HoldingProbe& operator=(const HoldingProbe&) = delete;
  ~HoldingProbe() { kill_it(); }

  bool is_running() const { return pid_ > 0 && waitpid(pid_, nullptr, WNOHANG) == 0; }
  void kill_it() {
    if (pid_ <= 0) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
    pid_ = -1;
  }

 private:
  pid_t pid_ = -1;
};

}  // namespace tegotae::test
