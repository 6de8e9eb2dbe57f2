// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/guard_process.hpp>

#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <thread>
#include <utility>

extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace tegotae {
namespace {

constexpr char kFarewell = 'f';
constexpr std::chrono::milliseconds kBetweenTries{5};
constexpr int kBetweenLooks = 10;  // ms, at the heart

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
pid_t spawn(const GuardProgram& program, std::vector<char*> arguments, int end) {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&actions);
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_adddup2(&actions, end, STDIN_FILENO);
  if (program.heartbeat >= 0) posix_spawn_file_actions_adddup2(&actions, program.heartbeat, kGuardHeartbeat);
  posix_spawn_file_actions_addclosefrom_np(&actions, program.heartbeat >= 0 ? kGuardHeartbeat + 1 : kGuardHeartbeat);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID);
  arguments.push_back(nullptr);
  pid_t pid = -1;
  const int error = posix_spawn(&pid, program.file.c_str(), &actions, &attributes, arguments.data(), environ);
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

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// By a signal: not by a debugger, which wants it so.
bool is_stopped(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(file, text);
  const std::size_t name_end = text.rfind(") ");  // a name may hold anything
  return name_end != std::string::npos && name_end + 2 < text.size() && text[name_end + 2] == 'T';
}

// Looks at the heart of the guarded process, and helps where it stands still.
class HeartWatch {
 public:
  HeartWatch(const InterfaceDriver& driver, const std::string& options, const GuardedProcess& guarded)
      : driver_(driver), options_(options), guarded_(guarded) {}

  void look() {
    const double now = steady_seconds();
    if (!standstill_.see(now, *guarded_.heart)) {
      is_silent_ = is_told_ = false;
      next_silence_ = 0.0;
      return;
    }
    if (guarded_.rescue == RescueTime::kAnyTime && now >= next_silence_ && driver_.silence(options_)) {
      next_silence_ = now + Standstill::kLongest;  // again, as a command that was on its way may come yet
      is_silent_ = true;
      tell("it is at zero.");
    }
    if (guarded_.process > 1 && is_stopped(guarded_.process)) {
      kill(guarded_.process, SIGCONT);
      tell("the program was stopped, and goes on, to say zero.");
    }
    if (!is_silent_) tell("nobody else can open it: if this lasts, switch it off.");
  }

 private:
  // What came of it first, in each standstill.
  void tell(const char* what) {
    if (std::exchange(is_told_, true)) return;
    fmt::print(stderr, "tegotae: the haptic thread stands still with a force on {}: {}\n", driver_.name, what);
  }

  const InterfaceDriver& driver_;
  const std::string& options_;
  const GuardedProcess& guarded_;
  Standstill standstill_;
  double next_silence_ = 0.0;  // s
  bool is_silent_ = false, is_told_ = false;
};

// Of another process: can be read when it is dead.
class Death {
 public:
  // By number, as the header of glibc 2.36 declares the function for C alone.
  explicit Death(pid_t process)
      : descriptor_(process > 1 ? static_cast<int>(syscall(SYS_pidfd_open, process, 0)) : -1) {}
  Death(const Death&) = delete;
  Death& operator=(const Death&) = delete;
  ~Death() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  int descriptor() const { return descriptor_; }  // negative: not known, which poll passes over

 private:
  int descriptor_;
};

// False where it died.
bool took_leave(int socket) {
  char word = 0;
  ssize_t length = 0;
  do length = recv(socket, &word, 1, MSG_DONTWAIT);
  while (length < 0 && errno == EINTR);
  return length == 1 && word == kFarewell;
}

// Its end of the socket may outlive it, in a process that a maker's library forked off.
void watch_until_it_ends(const InterfaceDriver& driver, const std::string& options, const GuardedProcess& guarded) {
  const Death death(guarded.process);
  pollfd ends[] = {{guarded.socket, POLLIN, 0}, {death.descriptor(), POLLIN, 0}};
  HeartWatch watch(driver, options, guarded);
  while (poll(ends, std::size(ends), guarded.heart != nullptr ? kBetweenLooks : -1) <= 0) {
    if (guarded.heart != nullptr) watch.look();
  }
}

// What a guard that was bidden farewell has to end.
constexpr std::chrono::milliseconds kFarewellTime{2000}, kFarewellLook{5};

}  // namespace

GuardProcess::GuardProcess(const GuardProgram& program) {
  SocketPair pair;
  std::vector<std::string> words = {program.file.string()};
  words.insert(words.end(), program.arguments.begin(), program.arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  pid_ = spawn(program, argv, pair.ends[1]);
  socket_ = pair.ends[0];
  pair.ends[0] = -1;
}

GuardProcess::~GuardProcess() {
  static_cast<void>(send(socket_, &kFarewell, 1, MSG_NOSIGNAL));
  close(socket_);
  for (auto left = kFarewellTime; !has_ended() && left.count() > 0; left -= kFarewellLook) {
    std::this_thread::sleep_for(kFarewellLook);
  }
  if (has_ended_) return;
  kill(pid_, SIGKILL);  // it hangs, perhaps in the maker's library
  wait(0);
}

bool GuardProcess::has_ended() noexcept { return has_ended_ || wait(WNOHANG | WUNTRACED); }

// For its end, as `options` of waitpid have it. One that was stopped is ended: it would not guard, nor hear a farewell.
bool GuardProcess::wait(int options) noexcept {
  int status = 0;
  pid_t found = 0;
  do found = waitpid(pid_, &status, options);
  while (found < 0 && errno == EINTR);
  if (found == 0) return false;
  has_ended_ = true;
  if (found != pid_ || !WIFSTOPPED(status)) return true;
  kill(pid_, SIGKILL);
  while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) continue;
  return true;
}

GuardEnd guard_interface(const InterfaceDriver& driver, const std::string& options, const GuardedProcess& guarded) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGTSTP}) std::signal(signal, SIG_IGN);
  watch_until_it_ends(driver, options, guarded);
  if (took_leave(guarded.socket)) return GuardEnd::kFarewell;
  return silenced(driver, options, guarded.patience) ? GuardEnd::kSilenced : GuardEnd::kFailed;
}

}  // namespace tegotae
