// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/closest_points.hpp>
#include <tegotae/contact/gjk.hpp>

namespace tegotae::gjk {

/// How many cold starts there are, each from another direction.
inline constexpr int kColdStarts = 7;

/// Takes the hints, and as first simplex the cached one (cores with vertices) or the support point along the cached
/// direction; without either, starts cold. Cached indices out of range are not used.
void start_warm(Pair& pair, const ClosestPointsCache& cache, Simplex& simplex) noexcept;

/// Only the hill-climbing hints of the cache, brought into range.
void take_hints(Pair& pair, const ClosestPointsCache& cache) noexcept;

/// First simplex of cold start number `attempt`: the support point along the line between the shapes' frames, then
/// along directions spread over the sphere.
void start_cold(Pair& pair, int attempt, Simplex& simplex) noexcept;

/// First simplex from a direction (object's frame, nonzero).
void start_along(Pair& pair, const Vector3& n, Simplex& simplex) noexcept;

/// Writes what the next query of this pair starts from.
void store(const Pair& pair, const Simplex& simplex, const Result& found, ClosestPointsCache& cache) noexcept;

}  // namespace tegotae::gjk
