// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/interface_choice.hpp>
#include <tegotae/lab/session_settings.hpp>
#include <tegotae/model/scene_geometry.hpp>
#include <tegotae/runtime/tick_record.hpp>

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tegotae {

/// A simulated interface for an experiment, and the hand that holds it.
struct InterfaceRequest {
  SimulatedChoice choice;
  std::string hand_name;
  HandImpedance hand;
};

/// By names from a command line. Throws InputError, a sentence with what there is.
InterfaceRequest interface_request(std::string_view interface, std::string_view hand);

/// The settings held to what the interface is rated for in its hand; `warning` tells what was lowered (one sentence;
/// empty: nothing).
SessionSettings held_in_hand(const SessionSettings& settings, const InterfaceRequest& request, std::string& warning);

/// What an experiment's motion becomes on an interface.
struct ExperimentInterface {
  std::unique_ptr<ObservedInterface> interface;
  std::vector<std::string> notes;  ///< for the head of files, a line each
};

/// The interface where the motion needs it (a SPIDAR: place_spidar), in a hand that means the tool to follow the motion
/// with the effort (hand_effort.hpp) that its exact playback asks for: `played`, from the motion's start on. Throws
/// InputError where the motion leaves the interface's workspace.
ExperimentInterface interface_for(const InterfaceRequest& request, const Trajectory& motion, const Vector3& up_W,
                                  std::span<const TickRecord> played, const Tool& tool);

}  // namespace tegotae
