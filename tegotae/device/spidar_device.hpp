// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/axis_map.hpp>
#include <tegotae/device/open_device.hpp>
#include <tegotae/device/spidar_board.hpp>
#include <tegotae/device/spidar_interface.hpp>

#include <memory>
#include <string>
#include <string_view>

namespace tegotae {

/// What `--interface spidar-g6:...` says of a device on its owner's transport.
struct SpidarOptions {
  SpidarGeometry geometry;
  std::string transport;      ///< file of the library that speaks to the board (spidar_transport.h)
  std::string board;          ///< which board: the library's own words
  AxisMap axes;               ///< from S (x to the right, y away from the person, z up)
  double rate = 1000.0;       ///< Hz
  double stiffness = 1000.0;  ///< N/m that it is rated for: none is published, and what a wall needs
  bool is_zero_kept = false;  ///< the counts' zero is that of an earlier calibration
  double hold_time = 2.0;     ///< s for which the grip must be held still before the counts are set to zero

  /// Throws InterfaceError, also for a geometry that cannot be used.
  static SpidarOptions parse(std::string_view text);
};

/// A SPIDAR on its owner's transport, taken into use. Its limits are SpidarInterface's, its stiffness the options',
/// the other ratings assumed_ratings.hpp's. kFailed: the board refused a call. kNotReady: it answers, and no pose fits
/// its counts, or they have lost their zero.
class SpidarDevice final : public OpenDevice {
 public:
  /// Opens the board. SpidarZero::kHere: displays least tensions until the counts have stood still (the strings are
  /// taut then, and a hand holds the grip) for the options' `hold_time`, then sets them to zero; a device whose counts
  /// do not come to stand for `kPatience` is refused. kKept: refuses a board whose counters lost their zero. Throws
  /// InterfaceError. Takes seconds.
  SpidarDevice(const SpidarBoardLibrary& library, const SpidarOptions& options, SpidarZero zero);

  InterfaceCapability capability() const override;
  DeviceAnswer read(double time, InterfaceState& state) noexcept override;
  DeviceAnswer write(const InterfaceCommand& command) noexcept override;
  std::string remarks() override;

  static constexpr double kPatience = 30.0;  ///< s, beyond `hold_time`

 private:
  SpidarInterface take_into_use(std::unique_ptr<SpidarBoard> board, SpidarZero zero);
  void wait_for_a_still_grip() const;
  void require_zero() const;
  DeviceAnswer answer(InterfaceStatus status) noexcept;

  SpidarOptions options_;
  SpidarBoard* board_ = nullptr;  ///< the interface's
  SpidarInterface interface_;
};

}  // namespace tegotae
