// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/model/scene_geometry.hpp>
#include <tegotae/render/adachi_method.hpp>
#include <tegotae/render/berkelman_method.hpp>
#include <tegotae/render/ortega_method.hpp>
#include <tegotae/render/otaduy_lin_method.hpp>
#include <tegotae/render/paper_method.hpp>
#include <tegotae/render/proxy_method.hpp>

#include <optional>
#include <span>
#include <string_view>
#include <variant>

namespace tegotae {

/// Any of the methods. They share a port, not a base class: `render(RenderInput, RenderOutput&) noexcept`, `reset()`.
using RenderingMethod =
    std::variant<PaperMethod, ProxyMethod, AdachiMethod, BerkelmanMethod, OtaduyLinMethod, OrtegaMethod>;

/// What a user may set of a method.
struct MethodSettings {
  double stiffness = 1000.0;  ///< N/m, > 0
  double damping = 0.0;       ///< N s/m, >= 0
  /// m, > 0. Not set: `default_metric_length`.
  std::optional<double> metric_length;
  std::optional<double> rotational_damping;  ///< N m s/rad, in place of damping times metric length squared, >= 0
  ConstraintSet constraint_set = ConstraintSet::kPenetratingPoints;  ///< of `paper`

  // Of `proxy`.
  double friction_scale = 1.0;             ///< of the scene's coefficients of sliding, >= 0
  std::optional<double> friction;          ///< one Coulomb coefficient for all pairs in place of the scene's, >= 0
  double kinetic_friction = 1.0;           ///< while slipping, as a part of the coefficient, 0 to 1
  double viscous_friction = 0.0;           ///< N s/m, >= 0
  double contact_margin = 1e-3;            ///< m that one linearisation may move the tool, > 0
  bool tool_weight = false;                ///< the tool's own weight is felt
  bool tool_inertia = false;               ///< the tool's own inertia is felt
  Vector3 gravity{0.0, 0.0, -9.81};        ///< m/s^2, for the tool's weight
  ContactTransient::Parameters transient;  ///< off by default
};

/// A name that `make_method` knows, and a sentence on the method for listings.
struct MethodName {
  std::string_view name;
  std::string_view summary;
};
std::span<const MethodName> method_names() noexcept;

/// The metric length (m) that the method called `name` has unless one is set: 1 m for `paper`, whose equations give
/// translation and rotation one stiffness; the tool's gyration length for every other.
double default_metric_length(std::string_view name, const Tool& tool);

/// Makes the method called `name` for the tool and the bodies of `geometry`, which must outlive it. Throws
/// std::invalid_argument, with the names or the range permitted, if there is none of that name or a setting is out of
/// range. Allocates.
RenderingMethod make_method(std::string_view name, const MethodSettings& settings, const SceneGeometry& geometry);

/// What the method asks of the physics rate.
ModelNeeds needs_of(const RenderingMethod& method) noexcept;

// std::visit throws where the variant holds nothing, which it never does: methods are moved in whole.
// NOLINTNEXTLINE(bugprone-exception-escape)
/// Renders with the method that there is. Not by std::visit, which may throw.
template <class... Methods>
void render(std::variant<Methods...>& method, const RenderInput& input, RenderOutput& output) noexcept {
  const auto render_with = [&](auto* chosen) {
    if (chosen != nullptr) chosen->render(input, output);
    return chosen != nullptr;
  };
  (render_with(std::get_if<Methods>(&method)) || ...);
}

/// What the last `render`, of `input`, worked with, into `view`, which is cleared first.
template <class... Methods>
void view_contacts(const std::variant<Methods...>& method, const RenderInput& input, const RenderOutput& output,
                   ContactView& view) noexcept {
  view.clear();
  const auto view_with = [&](const auto* chosen) {
    if (chosen != nullptr) chosen->view(input, output, view);
    return chosen != nullptr;
  };
  (view_with(std::get_if<Methods>(&method)) || ...);
}

/// Changes from one method, or its settings, to another while the hand holds the tool: `current` takes the settings of
/// `next` where both are of one kind (then true). Otherwise `next` starts where `current` has brought the tool and is
/// to be used from now on.
template <class... Methods>
bool adopt_or_start(std::variant<Methods...>& current, std::variant<Methods...>& next, const Pose& X_WP,
                    const Pose& X_WT) noexcept {
  const auto change = [&](auto* chosen, auto* present) {
    if (chosen == nullptr) return false;
    if (present == nullptr) {
      chosen->start_at(X_WP, X_WT);
      return false;
    }
    present->adopt(*chosen);
    return true;
  };
  return (change(std::get_if<Methods>(&next), std::get_if<Methods>(&current)) || ...);
}

/// Whether a method renders each model as it was received until the next one comes, as its source does: it declares
/// `kHoldsModel`. The others are given models interpolated to now.
template <class Method>
constexpr bool declares_holding() noexcept {
  if constexpr (requires { Method::kHoldsModel; }) return Method::kHoldsModel;
  return false;
}
template <class... Methods>
bool holds_model(const std::variant<Methods...>& method) noexcept {
  constexpr bool kHolds[] = {declares_holding<Methods>()...};
  return !method.valueless_by_exception() && kHolds[method.index()];
}

}  // namespace tegotae
