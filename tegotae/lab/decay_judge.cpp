// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/decay_judge.hpp>

#include <cmath>

namespace tegotae {

double DecayJudge::Window::root_mean_square() const noexcept {
  return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0.0;
}

bool DecayJudge::add(double time, double speed) noexcept {
  // Written so that NaN counts as diverged.
  if (!(speed < kDiverged)) diverged_ = true;
  if (diverged_) return false;
  const double since = time - begin_;
  if (since >= 0.0 && since < kWindow) {
    first_.squares += speed * speed;
    ++first_.count;
  }
  if (since >= kDuration - kWindow && since < kDuration) {
    last_.squares += speed * speed;
    ++last_.count;
  }
  return since < kDuration;
}

bool DecayJudge::decayed() const noexcept {
  if (diverged_ || last_.count == 0) return false;
  return last_speed() <= kStill || last_speed() <= kShrink * first_speed();
}

}  // namespace tegotae
