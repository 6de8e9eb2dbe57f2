// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tests/lab/temporary_folder.hpp>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace tegotae {

/// The built program `tegotae`, started and still running: its output goes to a file.
class StartedProgram {
 public:
  /// `environment`: "NAME=value" words beside those of this process.
  StartedProgram(const std::vector<std::string>& arguments, const std::vector<std::string>& environment) {
    // Made before the fork: the child allocates nothing.
    std::vector<std::string> words = {"env"};
    words.insert(words.end(), environment.begin(), environment.end());
    words.emplace_back(TEGOTAE_PROGRAM);
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const std::string file = (folder_.path() / "output").string();
    pid_ = fork();
    if (pid_ < 0) throw std::runtime_error("no process");
    if (pid_ > 0) return;
    const int output = open(file.c_str(), O_CREAT | O_WRONLY | O_APPEND, 0600);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    execvp("env", argv.data());
    _exit(127);
  }
  StartedProgram(const StartedProgram&) = delete;
  StartedProgram& operator=(const StartedProgram&) = delete;
  ~StartedProgram() {
    if (has_ended()) return;
    kill(SIGKILL);
    wait();
  }

  pid_t pid() const { return pid_; }
  void kill(int signal) const { ::kill(pid_, signal); }

  bool has_ended() {
    if (!ended_) ended_ = waitpid(pid_, &status_, WNOHANG) == pid_;
    return ended_;
  }
  /// Its exit code, or 128 and the signal that ended it.
  int wait() {
    while (!has_ended()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
  }

  std::string output() const { return contents_of((folder_.path() / "output").string()); }

 private:
  TemporaryFolder folder_;
  pid_t pid_ = -1;
  int status_ = 0;
  bool ended_ = false;
};

}  // namespace tegotae
