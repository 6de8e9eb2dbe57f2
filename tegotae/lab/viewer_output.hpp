// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/stream/viewer_options.hpp>

#include <cstddef>
#include <functional>
#include <string>

namespace tegotae {

/// Where a session sends what it shows: the functions of a ViewerServer.
struct ViewerOutput {
  std::function<void(SharedText)> publish;         ///< the newest state, which the next one replaces
  std::function<void(ViewerId, SharedText)> send;  ///< to one, in order
  std::function<void(SharedText)> send_all;
  std::function<std::size_t()> viewer_count;
  std::function<void(ViewerId, std::string)> disconnect;
};

}  // namespace tegotae
