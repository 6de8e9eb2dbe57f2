// SPDX-License-Identifier: Apache-2.0
#pragma once

// Appending a row: inline, as thousands are appended every tick.

namespace tegotae {

template <int N>
inline bool ConstraintProblem<N>::add_contact(const Unknowns<N>& J, double b, double c) noexcept {
  if (contact_count_ == contact_capacity_) {
    ++dropped_count_;
    return false;
  }
  const int lane = contact_count_ % kRowLanes;
  RowGroup<N>& group = groups_[contact_count_ / kRowLanes];
  RowCompliance& compliance = compliances_[contact_count_ / kRowLanes];
  if (lane == 0) {
    group.J.setZero();
    group.b.setConstant(-1.0);
    compliance.c.setOnes();
    compliance.stiffness.setZero();
  }
  group.J.row(lane) = J.transpose().array();
  group.b[lane] = b;
  compliance.c[lane] = c;
  compliance.stiffness[lane] = c > 0.0 ? 1.0 / c : 0.0;
  ++contact_count_;
  const double norm_squared = norm_weights_.dot(J.cwiseAbs2());
  // Anything not finite makes this difference NaN, and so unequal to zero.
  const double probe = norm_squared + std::abs(b) + c;
  valid_ = valid_ && probe - probe == 0.0 && c >= 0.0;
  row_norm_squared_ = std::max(row_norm_squared_, norm_squared);
  least_compliance_ = std::min(least_compliance_, c);
  return true;
}

}  // namespace tegotae
