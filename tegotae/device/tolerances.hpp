// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Tolerances of this layer, each with its unit and reason.
namespace tegotae::tolerance {

/// m. A step of the pose from string lengths (rotation: times the knots' radius) that ends the iteration: under a
/// ten-thousandth of an encoder's pulse, and a million times what rounding leaves.
inline constexpr double kSpidarStep = 1e-9;

/// Steps of that iteration. A warm start takes two to four; a start half a turn away up to about fifteen.
inline constexpr int kSpidarSteps = 40;

/// Halvings of one step that makes the lengths fit worse.
inline constexpr int kSpidarHalvings = 12;

/// Least pivot of the strings' 6 x 6 normal matrix, of their 6 x 8 wrench matrix in the second (rotation in units of
/// the knots' radius), relative to the greatest. Under it a motion of the grip, or a wrench, is one in a million of the
/// others to the strings: an encoder's pulse would be a metre.
inline constexpr double kSpidarNormalPivot = 1e-12;
inline constexpr double kSpidarWrenchPivot = 1e-6;

/// Weight of a string in a facet of the reachable wrenches under which it is rounding of zero: weights are at most 1,
/// and come from products of numbers of that size.
inline constexpr double kSpidarWeight = 1e-9;

/// N. By this the limits of the tensions are widened while they are chosen, then clipped again: at the greatest scale
/// that is reachable they leave one choice alone, which rounding (1e-14 of 20 N) would refuse. A ten-thousandth of the
/// 1e-6 that is promised.
inline constexpr double kSpidarTensionSlack = 1e-10;

/// Weights, where no part of a wrench is reachable, of a great part and of small tensions against a small stray wrench:
/// the whole wrench is worth a thirty-thousandth of it of stray, and 20 N less in all strings 0.06 mN. With more, the
/// wrench would jump where its parts cease to be reachable.
inline constexpr double kSpidarPreferGreat = 1e-9;
inline constexpr double kSpidarPreferSmall = 1e-12;

/// N. Slope of that problem, per newton of tension, under which a bound does not hold the minimum back: ten times what
/// rounding leaves of 20 N in eight strings, and what the preference for small tensions pulls with at 0.1 N.
inline constexpr double kSpidarPull = 1e-13;

/// Steps of its active set: it takes about ten, and each costs a third of a microsecond.
inline constexpr int kSpidarActiveSteps = 60;

/// m, RMS misfit of eight lengths to one pose above which they are not believed: a counter slipped, a string is slack,
/// or the geometry is not this device's. Rounding leaves 9 um; 10 N stretch a thin string of 0.1 m by 0.3 mm.
inline constexpr double kSpidarMisfit = 1e-3;

/// What the product of a reported rotation matrix and its transpose may differ from the identity by, each entry, to be
/// believed: a device's encoders and single precision leave less than a tenth of it; a matrix that its library did not
/// fill, or filled in another order, differs by about 1.
inline constexpr double kRotationMatrix = 1e-3;

/// m/s. Lengths that change faster come from a counter that slipped, or one that does not look like it: a hand reaches
/// with 4 m/s, and the strings follow the knots.
inline constexpr double kSpidarFastest = 6.0;

/// m, RMS misfit at which lengths that changed faster are believed all the same. Ten times what rounding leaves; a slip
/// of 6 mm in any string leaves 0.3 mm and more, but within the millimetre above may fit a pose far away.
inline constexpr double kSpidarSureMisfit = 1e-4;

/// N and N m. A geometry must display at least this in every direction at its centre: the least force that a hand
/// feels, and at the radius of a knot about the same.
inline constexpr double kSpidarLeastForce = 0.04;
inline constexpr double kSpidarLeastTorque = 1e-3;

/// Of an HD transform's columns, lengths and angles (1 and radians), and of its last row: ten times what numbers of
/// single precision from a chain of six joints leave, a hundredth of what another layout would.
inline constexpr double kRigidTransform = 1e-3;

/// m. No grip of such a device is farther from its base: in another unit it would be.
inline constexpr double kGreatestReach = 2.0;

}  // namespace tegotae::tolerance
