// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/spidar_geometry.hpp>

#include <filesystem>
#include <stdexcept>
#include <string_view>

namespace tegotae {

/// A geometry file that cannot be used. `what()` is one sentence: the file, the line where it is known, what is wrong
/// and how to mend it.
struct SpidarFileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads a geometry from a text file. A line is a word and its values, separated by blanks; what follows # is a
/// comment. SI units, axes of S (spidar_geometry.hpp).
///
///     name NAME
///     metres_per_pulse LENGTH          m, of the strings named below it that do not say otherwise
///     volts_per_newton VOLTS           V
///     tension LEAST GREATEST           N
///     axial_stiffness FORCE            N, optional
///     left_handed                      places below it are in SPIDAR's x right, y up, z away
///     string X Y Z  KX KY KZ [SIGN]    m: motor, knot; 1 or -1 (count falls as it grows longer); eight of these
///
/// Throws SpidarFileError, and for a geometry without force closure as check_force_closure. Allocates.
SpidarGeometry read_spidar_file(const std::filesystem::path& file);

/// The geometry of the preset that is called so (spidar_presets.hpp), else that of the file. Throws SpidarFileError,
/// with the names that there are, where it is neither, and as `read_spidar_file`. A preset's force closure is not
/// checked. Allocates.
SpidarGeometry find_spidar_geometry(std::string_view preset_or_file);

}  // namespace tegotae
