// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_board.hpp>

#include <tegotae/device/interface_driver.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {

static_assert(kSpidarStrings == TEGOTAE_SPIDAR_STRINGS);

SpidarBoard::SpidarBoard(const SpidarBoardLibrary& library, const std::string& name)
    : library_(library), board_(library.open(name.c_str())) {
  if (board_ == nullptr) {
    throw InterfaceError("spidar-g6: the board" + (name.empty() ? "" : " '" + name + "'") + " cannot be opened (" +
                         library_.why() + "): check its power, its cable and the rights on its port.");
  }
  const int strings = library_.strings(board_);
  if (strings == kSpidarStrings) return;
  library_.close(board_);
  throw InterfaceError("spidar-g6: the board has " + std::to_string(strings) + " strings, and a SPIDAR-G6 has eight.");
}

SpidarBoard::~SpidarBoard() {
  library_.stop(board_);
  library_.close(board_);
}

bool SpidarBoard::read_uncalibrated(SpidarVector& counts) noexcept {
  tegotae_spidar_reading reading = {};
  if (!succeeded(library_.read(board_, &reading)) || !std::isfinite(reading.age)) return false;
  std::copy(std::begin(reading.counts), std::end(reading.counts), counts.data());
  age_ = std::max(reading.age, 0.0);
  buttons_ = reading.buttons;
  is_calibrated_ = reading.is_uncalibrated == 0;
  return true;
}

bool SpidarBoard::read(double, SpidarVector& counts) noexcept { return read_uncalibrated(counts) && is_calibrated_; }

bool SpidarBoard::silence(const SpidarBoardLibrary& library, const std::string& name) noexcept {
  if (library.sharing == TEGOTAE_SPIDAR_NEVER) return false;
  tegotae_spidar_board* board = library.open(name.c_str());
  if (board == nullptr) return false;
  const bool is_stopped = library.stop(board) == 0;
  library.close(board);
  return is_stopped;
}

}  // namespace tegotae
