// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/spidar_board_library.hpp>
#include <tegotae/device/spidar_transport.hpp>

#include <cstdint>
#include <string>
#include <utility>

namespace tegotae {

/// A SPIDAR's board that its owner's library speaks to (spidar_transport.h). What is not calibrated is as good as not
/// read, and so is what has an age that is not finite. The destructor stops the motors and closes the board.
class SpidarBoard final : public SpidarTransport {
 public:
  /// Opens the board that `name` names. Throws InterfaceError where it cannot be opened or has not eight strings.
  SpidarBoard(const SpidarBoardLibrary& library, const std::string& name);
  ~SpidarBoard() override;

  bool reset() noexcept override { return succeeded(library_.reset(board_)); }
  bool read(double time, SpidarVector& counts) noexcept override;
  bool write(const SpidarVector& tensions) noexcept override {
    return succeeded(library_.write(board_, tensions.data()));
  }
  double age() const noexcept override { return age_; }
  std::uint32_t buttons() const noexcept override { return buttons_; }

  /// As `read`, also where the counters have lost their zero.
  bool read_uncalibrated(SpidarVector& counts) noexcept;
  /// Whether they had not at the last reading.
  bool is_calibrated() const noexcept { return is_calibrated_; }
  /// Why the last call of this thread was refused, in the library's words.
  std::string why() const { return library_.why(); }
  /// Whether a call was refused since this was asked last.
  bool take_failure() noexcept { return std::exchange(has_failed_, false); }

  /// Stops the motors of a board that another process drives or drove, and lets go of it. False where the library does
  /// not permit that or a call fails.
  static bool silence(const SpidarBoardLibrary& library, const std::string& name) noexcept;

 private:
  bool succeeded(int result) noexcept {
    has_failed_ = has_failed_ || result != 0;
    return result == 0;
  }

  SpidarBoardLibrary library_;
  tegotae_spidar_board* board_;
  double age_ = 0.0;  ///< s
  std::uint32_t buttons_ = 0;
  bool is_calibrated_ = false, has_failed_ = false;
};

}  // namespace tegotae
