// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/device_watch.hpp>

namespace tegotae {

DeviceWatch::News DeviceWatch::see(double time, bool silent) noexcept {
  if (silent == is_silent_) {
    differs_ = false;
    return News::kNone;
  }
  if (!differs_) {
    differs_ = true;
    since_ = time;
  }
  if (time - since_ < kLasting) return News::kNone;
  is_silent_ = silent;
  differs_ = false;
  return silent ? News::kSilent : News::kBack;
}

}  // namespace tegotae
