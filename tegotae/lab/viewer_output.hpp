// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/stream/viewer_options.hpp>

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace tegotae {

/// Where a session sends what it shows: the functions of a ViewerServer.
struct ViewerOutput {
  std::function<void(SharedText)> publish;         ///< the newest state, which the next one replaces
  std::function<void(ViewerId, SharedText)> send;  ///< to one, in order
  std::function<void(SharedText)> send_all;
  std::function<std::size_t()> viewer_count;
  std::function<void(ViewerId, std::string)> disconnect;
};

/// Between two states that a view is shown: 60 a second.
inline constexpr std::chrono::microseconds kStatePeriod{16'667};

/// A text that several viewers are sent.
inline SharedText shared(std::string text) { return std::make_shared<const std::string>(std::move(text)); }

}  // namespace tegotae
