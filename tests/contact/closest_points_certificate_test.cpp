// SPDX-License-Identifier: Apache-2.0
// No distance where there is none: random and adversarial pairs of boxes against the separating-axis theorem.
#include <tegotae/contact/closest_points.hpp>
#include <tegotae/contact/penetration.hpp>

#include <tests/contact/separating_axis.hpp>
#include <tests/random_shapes.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

#include <string>

namespace tegotae::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct BoxPair {
  Vector3 half_a, half_b;
  Pose X_WA, X_WB;
};

Vector3 random_half(std::mt19937_64& random) {
  return {uniform(random, 0.05, 1.0), uniform(random, 0.05, 1.0), uniform(random, 0.05, 1.0)};
}

BoxPair random_pair(std::mt19937_64& random) {
  BoxPair pair{random_half(random), random_half(random), random_pose(random, 1.0), {}};
  pair.X_WB = {pair.X_WA.p + uniform(random, 0.0, 2.5) * random_unit(random), random_rotation(random)};
  return pair;
}

// Needles and plates of 1 : 1000.
BoxPair extreme_aspect(std::mt19937_64& random) {
  BoxPair pair = random_pair(random);
  for (Vector3* half : {&pair.half_a, &pair.half_b}) {
    *half = Vector3::Constant(1e-3);
    (*half)[static_cast<int>(random() % 3)] = 1.0;
    if (random() % 2 == 0) (*half)[static_cast<int>(random() % 3)] = 1.0;
  }
  return pair;
}

// Face to face, the rotation about the common normal one of a few that tie, a gap of any sign and size, including 0,
// and a tilt of 1e-9 rad or none.
BoxPair face_to_face(std::mt19937_64& random) {
  BoxPair pair{random_half(random), random_half(random), {}, {}};
  if (random() % 2 == 0) pair.half_b = pair.half_a;
  const double gaps[] = {0.0, 1e-16, 1e-12, 1e-8, 1e-7, 2e-6, 1e-3, -1e-16, -1e-12, -1e-8, -2e-6, -1e-3};
  const double turns[] = {0.0, 0.25 * kPi, 0.5 * kPi, 1e-9, uniform(random, 0.0, kPi)};
  const double gap = gaps[random() % 12];
  const Vector3 tilt = random() % 2 == 0 ? Vector3(1e-9 * random_unit(random)) : Vector3(Vector3::Zero());
  const double slides[] = {0.0, pair.half_a.x() + pair.half_b.x(), uniform(random, 0.0, 1.0)};
  const Pose relative = {{slides[random() % 3], slides[random() % 3], pair.half_a.z() + pair.half_b.z() + gap},
                         rotation_from_vector(tilt) * rotation_from_vector(Vector3(0.0, 0.0, turns[random() % 5]))};
  pair.X_WB = random() % 2 == 0 ? Pose{} : random_pose(random, 1.0);
  pair.X_WA = pair.X_WB * relative;
  return pair;
}

BoxPair deep_or_coincident(std::mt19937_64& random) {
  BoxPair pair = random_pair(random);
  const double shifts[] = {0.0, 1e-16, 1e-9, 1e-3, 0.02};
  pair.X_WB.p = pair.X_WA.p + shifts[random() % 5] * random_unit(random);
  if (random() % 2 == 0) pair.X_WB.q = pair.X_WA.q;
  if (random() % 2 == 0) pair.half_b = pair.half_a;
  return pair;
}

void check(const BoxPair& pair, Shape& a, Shape& b, ClosestPointsCache& cache, int& separated) {
  a.size = pair.half_a;  // a box's own size is all that the closest points need of it
  b.size = pair.half_b;
  const ClosestPoints found = closest_points({a, pair.X_WA}, {b, pair.X_WB}, cache);
  const SeparatingAxis truth(pair.half_a, pair.X_WA, pair.half_b, pair.X_WB);
  const double gap = truth.greatest_gap();
  if (found.separation == Separation::kSeparated) {
    ++separated;
    ASSERT_GT(found.distance, 0.0);
    ASSERT_GE(found.lower_bound, 0.999 * found.distance);
    ASSERT_GT(std::max(gap, truth.gap_along(found.n_W)), 0.0)
        << "a distance of " << found.distance << " m where there is none";
    ASSERT_GE(found.distance, gap - 1e-13);
    ASSERT_NEAR(found.lower_bound, truth.gap_along(found.n_W), 1e-14);
    ASSERT_NEAR((found.p_WA - found.p_WB).norm(), found.distance, 1e-13);
  } else {
    ASSERT_LT(gap, 1e-11) << "no distance found where there is one";
  }
}

using Generator = BoxPair (*)(std::mt19937_64&);

int sweep(Generator generator, int pairs, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Shape a = make_box({1.0, 1.0, 1.0});
  Shape b = a;
  ClosestPointsCache cache;  // one for all: foreign contents at every query
  int separated = 0;
  for (int i = 0; i < pairs && !::testing::Test::HasFatalFailure(); ++i) {
    if (i % 2 == 0) cache = {};
    check(generator(random), a, b, cache, separated);
    if (::testing::Test::HasFatalFailure()) ADD_FAILURE() << "pair " << i;
  }
  return separated;
}

TEST(ClosestPointsCertificate, RandomBoxes) {
  const int pairs = sweep_size(400000);
  const int separated = sweep(random_pair, pairs, 1);
  EXPECT_GT(separated, pairs / 10);
  EXPECT_LT(separated, pairs * 9 / 10);
}

TEST(ClosestPointsCertificate, NeedlesAndPlatesOfOneToAThousand) {
  const int pairs = sweep_size(200000);
  const int separated = sweep(extreme_aspect, pairs, 2);
  EXPECT_GT(separated, pairs / 10);
}

TEST(ClosestPointsCertificate, FaceToFaceNearlyParallelAndTouching) {
  const int pairs = sweep_size(200000);
  const int separated = sweep(face_to_face, pairs, 3);
  EXPECT_GT(separated, pairs / 10);
  EXPECT_LT(separated, pairs * 9 / 10);
}

TEST(ClosestPointsCertificate, DeepAndCoincidentBoxesHaveNoDistance) {
  EXPECT_EQ(sweep(deep_or_coincident, sweep_size(200000), 4), 0);
}

}  // namespace
}  // namespace tegotae::test
