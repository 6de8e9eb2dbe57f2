// SPDX-License-Identifier: Apache-2.0
#include <bench/live/served_program.hpp>

#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace tegotae::bench {
namespace {

constexpr std::string_view kAddress = "http://127.0.0.1:";

}  // namespace

ServedProgram::ServedProgram(const std::vector<std::string>& command) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe can be made");
  output_ = ends[0];
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const int error = posix_spawn(&process_, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  if (error != 0) {
    process_ = 0;
    close(output_);
    throw std::runtime_error(command[0] + " cannot be started");
  }
  try {
    wait_for_address();
  } catch (...) {
    close(output_);
    kill(process_, SIGINT);
    waitpid(process_, nullptr, 0);
    throw;
  }
}

ServedProgram::~ServedProgram() {
  try {
    stop();
  } catch (const std::exception&) {
    // What is measured is void already, and said to be so by whoever ended this early.
  }
  close(output_);
}

void ServedProgram::wait_for_address() {
  std::string text;
  char byte = 0;
  while (read(output_, &byte, 1) == 1) {
    text += byte;
    const std::size_t begin = text.find(kAddress);
    if (byte != '\n' || begin == std::string::npos) continue;
    port_ = static_cast<std::uint16_t>(std::stoul(text.substr(begin + kAddress.size())));
    return;
  }
  throw std::runtime_error("the program has printed no address: " + text);
}

double ServedProgram::processor_time() const {
  std::ifstream file("/proc/" + std::to_string(process_) + "/stat");
  std::string text;
  std::getline(file, text);
  // After the name, which stands in brackets: the state and ten numbers, then user and system time (proc(5)).
  std::istringstream fields(text.substr(text.rfind(')') + 1));
  std::string skipped;
  for (int i = 0; i < 11; ++i) fields >> skipped;
  double user = 0.0, system = 0.0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

int ServedProgram::real_time_threads() const {
  int count = 0;
  for (const auto& task : std::filesystem::directory_iterator("/proc/" + std::to_string(process_) + "/task")) {
    if (sched_getscheduler(std::stoi(task.path().filename().string())) == SCHED_FIFO) ++count;
  }
  return count;
}

void ServedProgram::stop() {
  if (process_ == 0) return;
  kill(process_, SIGINT);
  int status = 0;
  waitpid(process_, &status, 0);
  process_ = 0;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw std::runtime_error("the program did not end well");
}

}  // namespace tegotae::bench
