// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tegotae::world_limits {

// Every limit and tolerance of the world layer, with its unit and its reason.

/// s. MuJoCo's contact softness depends on the time step: longer ones make objects feel like rubber.
inline constexpr double kMaxSubstep = 0.002;

/// Part of a substep. A duration that exceeds a whole number of substeps by less than this is rounding, not time.
inline constexpr double kSubstepRounding = 1e-9;

/// m. A mesh that dents its hull by less is used without a warning: at 9000 N/m the difference is 0.04 N, the least
/// force that a hand feels.
inline constexpr double kUnfeltDent = 4.4e-6;

/// kg/m^3. Of a tool to which the scene gives no mass: that of water, for its gyration length does not depend on it.
inline constexpr double kToolDensity = 1000.0;

/// Contacts and constraint rows that room is made for at first, and at most. MuJoCo 2.2.2 holds a matrix of rows by
/// rows (12 bytes an entry) in a buffer of less than 2^31 bytes, so the room grows only as it is needed.
inline constexpr int kFirstContacts = 256;
inline constexpr int kFirstRows = 1024;
inline constexpr int kMaxRows = 9000;

/// bytes. The most that newer MuJoCo's arena grows to, which holds its contacts and rows.
inline constexpr long long kMaxArena = 1LL << 32;

/// Warnings of one engine call that are kept word by word; a scene that warns more says nothing new.
inline constexpr int kMaxKeptWarnings = 32;

}  // namespace tegotae::world_limits
