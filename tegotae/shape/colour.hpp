// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tegotae {

/// How a surface is drawn: red, green, blue as a screen takes them (sRGB) and opacity, each 0 to 1. Neutral grey where
/// nobody says otherwise.
struct Colour {
  float r = 0.5F, g = 0.5F, b = 0.5F, a = 1.0F;
  bool operator==(const Colour&) const = default;
};

}  // namespace tegotae
