// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/render/constraint_problem.hpp>

#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

// Arithmetic on the eight rows of a group, as four pairs of numbers: SSE2's register. On g++'s and clang's vector type
// and forced inline: through Eigen's expressions g++ 12 calls these few instructions as functions, at several times
// their cost.
namespace tegotae::internal {

using Pair = double __attribute__((vector_size(16)));
using PairBits = decltype(Pair{} > Pair{});

[[gnu::always_inline]] inline Pair load_pair(const double* p) noexcept {
  Pair pair;
  std::memcpy(&pair, p, sizeof pair);
  return pair;
}
[[gnu::always_inline]] inline double sum(const Pair& pair) noexcept { return pair[0] + pair[1]; }
[[gnu::always_inline]] inline long double sum(long double value) noexcept { return value; }
[[gnu::always_inline]] inline Pair positive_part(const Pair& v) noexcept {
  return reinterpret_cast<Pair>((v > Pair{}) & reinterpret_cast<PairBits>(v));
}
[[gnu::always_inline]] inline unsigned bits_above(const Pair& v, double threshold) noexcept {
#ifdef __SSE2__
  return static_cast<unsigned>(_mm_movemask_pd(_mm_cmpgt_pd(v, _mm_set1_pd(threshold))));
#else
  return static_cast<unsigned>(v[0] > threshold) | static_cast<unsigned>(v[1] > threshold) << 1;
#endif
}

struct Lanes {
  Pair a, b, c, d;

  [[gnu::always_inline]] static inline Lanes load(const double* p) noexcept {
    return {load_pair(p), load_pair(p + 2), load_pair(p + 4), load_pair(p + 6)};
  }
  [[gnu::always_inline]] static inline Lanes load(const RowLanes& rows) noexcept { return load(rows.data()); }
  [[gnu::always_inline]] inline void store(RowLanes& rows) const noexcept {
    std::memcpy(rows.data(), &a, sizeof a);
    std::memcpy(rows.data() + 2, &b, sizeof b);
    std::memcpy(rows.data() + 4, &c, sizeof c);
    std::memcpy(rows.data() + 6, &d, sizeof d);
  }
  [[gnu::always_inline]] inline Lanes operator+(const Lanes& o) const noexcept {
    return {a + o.a, b + o.b, c + o.c, d + o.d};
  }
  [[gnu::always_inline]] inline Lanes operator-(const Lanes& o) const noexcept {
    return {a - o.a, b - o.b, c - o.c, d - o.d};
  }
  [[gnu::always_inline]] inline Lanes operator*(const Lanes& o) const noexcept {
    return {a * o.a, b * o.b, c * o.c, d * o.d};
  }
  [[gnu::always_inline]] inline Lanes operator*(double s) const noexcept { return {a * s, b * s, c * s, d * s}; }
  [[gnu::always_inline]] inline Lanes positive() const noexcept {
    return {positive_part(a), positive_part(b), positive_part(c), positive_part(d)};
  }
  /// The lanes' sum, in two halves.
  [[gnu::always_inline]] inline Pair fold() const noexcept { return (a + b) + (c + d); }
  /// Bit set of the lanes above a threshold.
  [[gnu::always_inline]] inline unsigned above(double threshold) const noexcept {
    return bits_above(a, threshold) | bits_above(b, threshold) << 2 | bits_above(c, threshold) << 4 |
           bits_above(d, threshold) << 6;
  }
  /// 1 in the lanes of a bit set, 0 elsewhere.
  [[gnu::always_inline]] static inline Lanes of(unsigned bits) noexcept {
    constexpr double kPairs[] = {0, 0, 1, 0, 0, 1, 1, 1};
    const auto pair = [&kPairs](unsigned two) { return load_pair(kPairs + 2 * (two & 3u)); };
    return {pair(bits), pair(bits >> 2), pair(bits >> 4), pair(bits >> 6)};
  }
};

/// J d for the rows of a group.
template <int N>
[[gnu::always_inline]] inline Lanes rows_times(const RowGroup<N>& rows, const Unknowns<N>& d) noexcept {
  Lanes sum = Lanes::load(rows.J.data()) * d[0];
  for (int j = 1; j < N; ++j) sum = sum + Lanes::load(rows.J.data() + j * kRowLanes) * d[j];
  return sum;
}

}  // namespace tegotae::internal
