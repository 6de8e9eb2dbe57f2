// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/progress.hpp>

#include <atomic>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>

namespace tegotae {

/// One of many works that do not depend on each other.
struct Work {
  double weight = 1.0;  ///< how long it takes, beside the others; for the progress alone
  /// Throws where it fails. Its Progress throws WorkStopped once the works are to stop.
  std::function<void(const Progress&)> perform;
  std::function<void(const std::string&)> failed = {};  ///< told `what()` of an exception, on the same thread
};

struct WorkStopped : std::runtime_error {
  WorkStopped() : std::runtime_error("stopped") {}
};

/// Performs all works, begun in their order, on `threads` threads besides the caller's, which waits; `progress` is told
/// the part of all weights that is done, one call at a time. Once `stop` (may be null) is true no further work is
/// begun, and those under way end where they next tell progress. A failed work does not hinder the others.
void perform_works(std::span<const Work> works, unsigned threads, const std::atomic<bool>* stop,
                   const Progress& progress);

}  // namespace tegotae
