// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/interface_driver.hpp>

#include <string>

namespace tegotae::test {

/// The sentence of the InterfaceError that `action` throws.
template <class Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const InterfaceError& error) {
    return error.what();
  }
  return "nothing was refused";
}

}  // namespace tegotae::test
