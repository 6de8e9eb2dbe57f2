// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/render/constraint_solver.hpp>
#include <tegotae/render/contact_tracker.hpp>
#include <tegotae/render/contact_transient.hpp>
#include <tegotae/render/contact_view.hpp>
#include <tegotae/render/coupling.hpp>
#include <tegotae/render/render_types.hpp>

#include <array>
#include <optional>
#include <vector>

namespace tegotae {

/// The default method. The *proxy* is the pose of the tool nearest to where the hand holds it that nothing forbids, in
/// the metric of the coupling; what is felt is the coupling's pull between the two. Each tick moves the proxy by up to
/// four linearisations:
///
///     minimise 1/2 |x - x_free|_K^2   over the small displacement x of the proxy about its present pose
///     subject to  gap_i + J_i x >= skin  at every contact point i near,  J_i = [n, r_i x n]
///
/// with x_free the way to the interface's pose, K the coupling's stiffness, every row slightly compliant, and friction
/// a bristle for each pair (Bristle). Contacts are found at the proxy's pose, at the haptic rate (ContactTracker,
/// overlay), so they are those that the surfaces really have, however deep the interface is pressed in. No
/// linearisation moves a tool point further than the margin beyond the nearest distance, and the new pose is accepted
/// by certified distances: the step is halved until no gap is worse than a quarter of the skin or what it was.
///
/// A tool that is inside something is brought out at a bounded speed. A local minimum: pressed on an edge above its
/// centre the proxy tips where stretch times height exceeds the square of the metric length, as a real stick held
/// softly.
///
/// Related: the god-object of Zilles and Salisbury (1995) in six degrees of freedom (Ortega, Redon and Coquillart
/// 2007), here posed as a metric projection with contacts refreshed at the haptic rate. Construction allocates;
/// `render` does not, nor throws, and its loops are bounded. Keeps a reference to the geometry.
class ProxyMethod {
 public:
  struct Parameters {
    Coupling coupling;
    double margin = 1e-3;  ///< m that one linearisation may move a tool point; more where hand or bodies are fast
    std::optional<double> friction;    ///< Coulomb coefficient of all pairs, in place of the scene's
    double friction_scale = 1.0;       ///< of the scene's coefficients
    double kinetic_friction = 1.0;     ///< while slipping, as a part of the coefficient
    double viscous_friction = 0.0;     ///< N s/m
    bool weight = false;               ///< the tool's own weight is felt
    bool inertia = false;              ///< the tool's own inertia is felt: the proxy has the tool's mass
    Vector3 gravity{0.0, 0.0, -9.81};  ///< m/s^2
    ContactTransient::Parameters transient;
  };

  ProxyMethod(const Parameters& parameters, const SceneGeometry& geometry);

  void render(const RenderInput& input, RenderOutput& output) noexcept;

  static ModelNeeds needs() noexcept { return {false, true}; }

  /// Forgets the past: the proxy starts at the interface's pose.
  void reset() noexcept;

  /// Takes the settings of `other`, and goes on as it is: what is touched stays touched.
  void adopt(const ProxyMethod& other) noexcept;

  /// Starts with the tool where the hand holds it, `X_WT`, and the proxy at `X_WP`.
  void start_at(const Pose& X_WP, const Pose& X_WT) noexcept;

  /// What the last `render` worked with: the planes of the pairs that it measured, the points of its last linearisation
  /// and the bristles that hold.
  void view(const RenderInput& input, const RenderOutput& output, ContactView& view) const noexcept;

 private:
  struct RowSource {
    int contact;
    Vector3 p_W;
    double gap;
  };

  void start(const Pose& X_WP, const Pose& X_WT) noexcept;
  bool admit(const RenderInput& input, RenderOutput& output) noexcept;
  bool linearise(const RenderInput& input, double& margin, RenderOutput& output) noexcept;
  void set_objective(const RenderInput& input) noexcept;
  void collect_rows(double reach) noexcept;
  void find_pushing_normals() noexcept;
  bool is_pushing_direction(const Vector3& n_W) const noexcept;
  Facing facing_of_rows(NearContact& contact) noexcept;
  void fill_problem(const RenderInput& input, const Vector3& p_WCm, bool push_out) noexcept;
  void add_friction(const RenderInput& input, const Vector3& p_WCm) noexcept;
  Vector6 solve(const RenderInput& input, const Vector3& p_WCm, RenderOutput& output) noexcept;
  Vector6 solve_filled(const RenderInput& input, const Vector3& p_WCm, bool push_out, RenderOutput& output) noexcept;
  bool is_inside() noexcept;
  void predict(const Vector6& x) noexcept;
  double step(const Vector6& x, const Vector3& p_WCm) noexcept;
  bool is_settled(double stretch) noexcept;
  double way_of_turned_arms(const Vector6& x, const Vector3& p_WCm) const noexcept;
  double first_margin(const RenderInput& input) noexcept;
  double take_loads(const Pose& X_WP_solved) noexcept;
  ContactLoad load_of(int contact, const Vector3& n_W, size_t& active) noexcept;
  void display(const RenderInput& input, RenderOutput& output) noexcept;
  double deepest_at_hand() const noexcept;
  void push_bodies(RenderOutput& output) noexcept;
  void feel_impact(const RenderInput& input, RenderOutput& output) noexcept;
  double way_of(const Vector6& x) const noexcept {
    return x.head<3>().norm() + x.tail<3>().norm() * tracker_.tool_radius();
  }

  Parameters parameters_;
  MassProperties mass_;
  double skin_;
  ContactTracker tracker_;
  ConstraintProblem<6> problem_;
  ConstraintWorkspace<6> workspace_;
  ConstraintSolution<6> solution_;
  ConstraintSolver<6> solver_;
  std::vector<RowSource> rows_;
  std::vector<int> blocks_;  ///< contact of each friction block
  std::vector<Vector2> patch_;
  ContactTransient transient_;

  static constexpr int kMostPushing = 4;
  std::array<Vector3, kMostPushing> pushing_normals_;  ///< of contacts that carried in the last solve
  int pushing_count_ = 0;

  bool started_ = false;
  bool touched_ = false;
  int left_out_ = 0;                        ///< points without a row, this tick
  Pose X_WP_;                               ///< the proxy
  Pose X_WP_start_;                         ///< at the start of the tick
  double margin_limit_ = 0.0;               ///< m, of a linearisation in this tick
  double push_out_ = 0.0;                   ///< m that the tool may still be pushed out of something in this tick
  Vector6 moved_before_ = Vector6::Zero();  ///< displacement of the proxy in the last tick
  Vector6 displacement_before_ = Vector6::Zero();
  Vector6 to_hand_ = Vector6::Zero();  ///< from where the last linearisation was posed to where the hand holds the tool
  Pose X_WT_before_;
};

}  // namespace tegotae
