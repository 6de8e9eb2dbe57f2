// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/spidar_geometry.hpp>

#include <span>
#include <string_view>

namespace tegotae {

/// A SPIDAR that has a name, and what its numbers are worth.
struct SpidarPreset {
  std::string_view name;
  std::string_view remark;
  SpidarGeometry geometry;
  bool is_refused = false;  ///< as check_force_closure refuses it
};

/// "x3r", "x3l", "x3f", "x4r" and "x4l". Places, pairing, pulses, volts and tensions as published in Springhead's
/// HISpidar.cpp (Hasegawa laboratory), its left-handed frame turned into S; none was run here. x3f as published has no
/// force closure, so the driver refuses it. Allocated once, valid for the program's life.
std::span<const SpidarPreset> spidar_presets();

/// By name. Throws std::invalid_argument, with the names, where there is none.
const SpidarPreset& spidar_preset(std::string_view name);

}  // namespace tegotae
