// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/doctor_system.hpp>

#include <tegotae/runtime/realtime_thread.hpp>

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace tegotae {
namespace {

// Bits of a process's capabilities (linux/capability.h).
constexpr int kCapabilityToLockMemory = 14, kCapabilityToSchedule = 23;

// Empty where it cannot be read.
std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text;
}

// What follows `label` on the line of `text` that begins with it.
std::string line_after(const std::string& text, std::string_view label) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.compare(0, label.size(), label) == 0) return line.substr(label.size());
  }
  return {};
}

// "unlimited", a number, or "unknown".
std::string soft_limit(const SystemRoots& roots, std::string_view name) {
  std::istringstream words(line_after(text_of(roots.proc / "self/limits"), name));
  std::string soft;
  return words >> soft ? soft : "unknown";
}

bool has_capability(const SystemRoots& roots, int bit) {
  std::istringstream words(line_after(text_of(roots.proc / "self/status"), "CapEff:"));
  std::string mask;
  words >> mask;
  std::uint64_t bits = 0;
  std::from_chars(mask.data(), mask.data() + mask.size(), bits, 16);
  return ((bits >> bit) & 1U) != 0;
}

bool is_root(const SystemRoots& roots) {
  std::istringstream words(line_after(text_of(roots.proc / "self/status"), "Uid:"));
  long real = -1, effective = -1;
  words >> real >> effective;
  return effective == 0;
}

constexpr std::string_view kRights =
    "sudo groupadd -f realtime; sudo usermod -aG realtime $USER; printf '@realtime - rtprio 90\\n@realtime - memlock "
    "unlimited\\n' | sudo tee /etc/security/limits.d/realtime.conf; then log in again";

constexpr std::string_view kPreemption =
    "install a real-time kernel (sudo apt install linux-image-rt-amd64; reboot), or add preempt=full to "
    "GRUB_CMDLINE_LINUX in /etc/default/grub (then sudo update-grub; reboot)";

// The mode in use stands in brackets: "none voluntary (full)".
std::string chosen_mode(const std::string& modes) {
  const size_t begin = modes.find('('), end = modes.find(')');
  if (begin == std::string::npos || end == std::string::npos || end < begin) return {};
  return modes.substr(begin + 1, end - begin - 1);
}

std::string mode_in_command_line(const SystemRoots& roots) {
  std::istringstream words(text_of(roots.proc / "cmdline"));
  constexpr std::string_view kOption = "preempt=";
  std::string mode;
  for (std::string word; words >> word;) {
    if (word.compare(0, kOption.size(), kOption) == 0) mode = word.substr(kOption.size());
  }
  return mode;
}

// "real-time", "full", "lazy", "voluntary", "none"; empty: not told.
std::string preemption_of(const SystemRoots& roots, const std::string& version) {
  const auto built_with = [&version](std::string_view word) { return version.find(word) != std::string::npos; };
  if (text_of(roots.sys / "kernel/realtime") == "1" || built_with("PREEMPT_RT")) return "real-time";
  if (built_with("PREEMPT_DYNAMIC")) {
    const std::string mode = chosen_mode(text_of(roots.sys / "kernel/debug/sched/preempt"));
    return !mode.empty() ? mode : mode_in_command_line(roots);
  }
  return built_with("PREEMPT") ? "full" : "voluntary or none";
}

}  // namespace

Finding kernel_finding(const SystemRoots& roots) {
  const std::string version = text_of(roots.proc / "version");
  const std::string release = text_of(roots.proc / "sys/kernel/osrelease");
  if (version.empty() && release.empty()) {
    return {Verdict::kCouldBeBetter, "kernel", fmt::format("{} does not tell its version.", roots.proc.string()),
            "look at it with 'uname -a'; the measured wake-ups count"};
  }
  const std::string preemption = preemption_of(roots, version);
  const bool good = preemption == "real-time" || preemption == "full";
  const std::string how = preemption.empty() ? "chosen at boot, which one is told to root only" : preemption;
  return {good ? Verdict::kOk : Verdict::kCouldBeBetter, "kernel",
          fmt::format("Linux {}, preemption: {}.", release.empty() ? version : release, how),
          good ? std::string() : std::string(kPreemption)};
}

Finding scheduling_finding(const SystemRoots& roots, bool granted) {
  const bool capable = has_capability(roots, kCapabilityToSchedule);
  const std::string permitted = fmt::format("limit of real-time priority {}, {} CAP_SYS_NICE",
                                            soft_limit(roots, "Max realtime priority"), capable ? "with" : "without");
  if (granted) {
    return {Verdict::kOk, "scheduling",
            fmt::format("SCHED_FIFO at priority {} is granted ({}).", kHapticPriority, permitted), ""};
  }
  return {Verdict::kCouldBeBetter, "scheduling",
          fmt::format("SCHED_FIFO at priority {} is refused ({}): ticks come late when the machine is busy.",
                      kHapticPriority, permitted),
          is_root(roots) ? "grant the container or service CAP_SYS_NICE (docker run --cap-add SYS_NICE; systemd: "
                           "LimitRTPRIO=90)"
                         : std::string(kRights)};
}

Finding memory_finding(const SystemRoots& roots, bool granted) {
  const bool capable = has_capability(roots, kCapabilityToLockMemory);
  const std::string permitted = fmt::format("limit of locked memory {} bytes, {} CAP_IPC_LOCK",
                                            soft_limit(roots, "Max locked memory"), capable ? "with" : "without");
  if (granted) return {Verdict::kOk, "memory", fmt::format("all memory can be locked ({}).", permitted), ""};
  return {Verdict::kCouldBeBetter, "memory",
          fmt::format("memory cannot be locked ({}): a tick may wait for paging.", permitted),
          is_root(roots) ? "grant the container or service CAP_IPC_LOCK without limit (docker run --cap-add IPC_LOCK "
                           "--ulimit memlock=-1; systemd: LimitMEMLOCK=infinity)"
                         : std::string(kRights)};
}

Finding governor_finding(const SystemRoots& roots) {
  std::map<std::string, int> governors;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(roots.sys / "devices/system/cpu", error)) {
    const std::string governor = text_of(entry.path() / "cpufreq/scaling_governor");
    if (!governor.empty()) ++governors[governor];
  }
  if (governors.empty()) {
    return {Verdict::kOk, "clock rate",
            "the system does not control it here (a virtual machine, or the firmware does).", ""};
  }
  std::string found;
  for (const auto& [governor, count] : governors) {
    found += fmt::format("{}{} on {}", found.empty() ? "" : ", ", governor, count);
  }
  const bool good = governors.size() == 1 && governors.count("performance") == 1;
  return {good ? Verdict::kOk : Verdict::kCouldBeBetter, "clock rate",
          fmt::format("governor {} processor{}.", found,
                      governors.size() == 1 && governors.begin()->second == 1 ? "" : "s"),
          good ? "" : "echo performance | sudo tee /sys/devices/system/cpu/cpu*/cpufreq/scaling_governor"};
}

}  // namespace tegotae
