// SPDX-License-Identifier: Apache-2.0
// driver_probe find|open|hold|silence DRIVER [OPTIONS]: what a driver does in a process of its own, which finds the
// makers' libraries as any program does. `find` prints what is found, `open` opens and closes, `hold` displays 2 N
// along z until it is killed, `silence` is what a guard does. A refusal is printed; the exit code is then 1.
#include <tegotae/device/interface_drivers.hpp>

#include <chrono>
#include <cstdio>
#include <exception>
#include <string>
#include <thread>

namespace {

using tegotae::InterfaceDriver;

int find(const InterfaceDriver& driver, const char* options) {
  const tegotae::InterfacePresence found = tegotae::find_interface(driver, options);
  std::printf("library '%s'\n", found.library.c_str());
  for (const std::string& name : found.looked_for) std::printf("looked for '%s'\n", name.c_str());
  for (const std::string& device : found.devices) std::printf("device '%s'\n", device.c_str());
  std::printf("trouble '%s'\n", found.trouble.c_str());
  return 0;
}

int hold(const InterfaceDriver& driver, const char* options) {
  const auto interface = driver.open(options);
  tegotae::InterfaceCommand command;
  command.wrench.force.z() = 2.0;
  for (double time = 0.0;; time += 1e-3) {
    tegotae::InterfaceState state;
    interface->read(time, state);
    interface->write(command);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

int run(const std::string& verb, const InterfaceDriver& driver, const char* options) {
  if (verb == "find") return find(driver, options);
  if (verb == "hold") return hold(driver, options);
  if (verb == "silence") return driver.silence(options) ? 0 : 1;
  std::printf("%s\n", driver.open(options)->capability().name.c_str());
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) return 2;
  try {
    return run(arguments[1], tegotae::find_interface_driver(arguments[2]), count > 3 ? arguments[3] : "");
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
}
