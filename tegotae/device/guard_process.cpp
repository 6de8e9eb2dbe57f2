// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/guard_process.hpp>

#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <initializer_list>
#include <thread>

extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace tegotae {
namespace {

constexpr char kFarewell = 'f';
constexpr std::chrono::milliseconds kBetweenTries{5};

[[noreturn]] void refuse(int error) {
  throw InterfaceError(fmt::format("the process that guards the interface cannot be started: {}.",
                                   std::strerror(error)));  // NOLINT(concurrency-mt-unsafe)
}

// Ends of a socket, both closed in programs that this process starts.
struct SocketPair {
  SocketPair() {
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) refuse(errno);
  }
  SocketPair(const SocketPair&) = delete;
  SocketPair& operator=(const SocketPair&) = delete;
  ~SocketPair() {
    for (const int end : ends) {
      if (end >= 0) close(end);
    }
  }
  int ends[2] = {-1, -1};
};

// `end` as standard input, in a session of its own: a signal to the terminal's group ends the guarded process alone.
pid_t spawn(const std::string& program, std::vector<char*> arguments, int end) {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&actions);
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_adddup2(&actions, end, STDIN_FILENO);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID);
  arguments.push_back(nullptr);
  pid_t pid = -1;
  const int error = posix_spawn(&pid, program.c_str(), &actions, &attributes, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) refuse(error);
  return pid;
}

bool silenced(const InterfaceDriver& driver, const std::string& options, double patience) {
  if (driver.silence == nullptr) return false;
  const auto last = std::chrono::steady_clock::now() + std::chrono::duration<double>(patience);
  while (!driver.silence(options)) {
    if (std::chrono::steady_clock::now() >= last) return false;
    std::this_thread::sleep_for(kBetweenTries);
  }
  return true;
}

}  // namespace

GuardProcess::GuardProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
  SocketPair pair;
  std::vector<std::string> words = {program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  pid_ = spawn(program.string(), argv, pair.ends[1]);
  socket_ = pair.ends[0];
  pair.ends[0] = -1;
}

GuardProcess::~GuardProcess() {
  static_cast<void>(send(socket_, &kFarewell, 1, MSG_NOSIGNAL));
  close(socket_);
  while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) continue;
}

GuardEnd guard_interface(const InterfaceDriver& driver, const std::string& options, int socket, double patience) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) std::signal(signal, SIG_IGN);
  char word = 0;
  ssize_t length = 0;
  do length = read(socket, &word, 1);
  while (length < 0 && errno == EINTR);
  if (length == 1 && word == kFarewell) return GuardEnd::kFarewell;
  return silenced(driver, options, patience) ? GuardEnd::kSilenced : GuardEnd::kFailed;
}

}  // namespace tegotae
