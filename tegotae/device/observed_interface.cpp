// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/observed_interface.hpp>

#include <utility>

namespace tegotae {
namespace {

// Ticks that nobody may take for so long: 8 s at 1 kHz.
constexpr std::size_t kCapacity = 8192;

// The grip's motion in a hand that means the tool to move.
class GripOfTool final : public IntendedMotion {
 public:
  GripOfTool(std::unique_ptr<IntendedMotion> of_tool, const Quaternion& q_GT)
      : of_tool_(std::move(of_tool)), q_TG_(q_GT.conjugate()) {}

  Pose start() const noexcept override { return grip(of_tool_->start()); }
  Pose at(double time) noexcept override { return grip(of_tool_->at(time)); }

 private:
  Pose grip(const Pose& X_WT) const noexcept { return {X_WT.p, (X_WT.q * q_TG_).normalized()}; }

  std::unique_ptr<IntendedMotion> of_tool_;
  Quaternion q_TG_;
};

class ObservedDevice final : public ObservedInterface {
 public:
  ObservedDevice(const SimulatedDevice& device, const HandImpedance& hand, std::unique_ptr<IntendedMotion> intended)
      : ObservedInterface(Quaternion::Identity()),
        max_force_(device.capability.max_force),
        max_torque_(device.capability.max_torque),
        interface_(std::move(intended), device, hand) {}

  InterfaceCapability capability() const override { return interface_.capability(); }

 private:
  InterfaceStatus read_grip(double time, InterfaceState& state) noexcept override {
    return interface_.read(time, state);
  }
  InterfaceStatus write_grip(const InterfaceCommand& command) noexcept override { return interface_.write(command); }

  GripTruth truth(const InterfaceCommand& command) const noexcept override {
    GripTruth truth;
    truth.displayed = interface_.displayed();
    truth.X_WT = interface_.grip().X_WG;
    truth.X_WH = interface_.intended();
    truth.falls_short = command.wrench.force.norm() > max_force_ || command.wrench.torque.norm() > max_torque_;
    return truth;
  }

  double max_force_, max_torque_;  ///< N, N m
  SimulatedHandInterface interface_;
};

class ObservedSpidar final : public ObservedInterface {
 public:
  ObservedSpidar(const SpidarSettings& settings, std::unique_ptr<SimulatedSpidar> simulated, const Quaternion& q_GT)
      : ObservedInterface(q_GT), simulated_(simulated.get()), interface_(settings, std::move(simulated)) {}

  InterfaceCapability capability() const override { return interface_.capability(); }

 private:
  InterfaceStatus read_grip(double time, InterfaceState& state) noexcept override {
    return interface_.read(time, state);
  }
  InterfaceStatus write_grip(const InterfaceCommand& command) noexcept override { return interface_.write(command); }

  GripTruth truth(const InterfaceCommand& /*command*/) const noexcept override {
    GripTruth truth;
    truth.displayed = simulated_->displayed();
    truth.X_WT = simulated_->grip().X_WG;
    truth.X_WH = simulated_->intended();
    truth.falls_short = interface_.display().display != SpidarDisplay::kExact;
    return truth;
  }

  SimulatedSpidar* simulated_;  ///< the driver's transport
  SpidarInterface interface_;
};

}  // namespace

ObservedInterface::ObservedInterface(const Quaternion& q_GT) : q_GT_(q_GT.normalized()), truths_(kCapacity) {}

InterfaceStatus ObservedInterface::read(double time, InterfaceState& state) noexcept {
  time_ = time;
  const InterfaceStatus status = read_grip(time, state);
  if (status == InterfaceStatus::kOk) state.X_WT = of_tool(state.X_WT);
  return status;
}

InterfaceStatus ObservedInterface::write(const InterfaceCommand& command) noexcept {
  const InterfaceStatus status = write_grip(command);
  GripTruth now = truth(command);
  now.time = time_;
  now.X_WT = of_tool(now.X_WT);
  now.X_WH = of_tool(now.X_WH);
  truths_.push(now);
  return status;
}

Pose ObservedInterface::of_tool(const Pose& X_WG) const noexcept { return {X_WG.p, (X_WG.q * q_GT_).normalized()}; }

std::unique_ptr<ObservedInterface> observed_device(const SimulatedDevice& device, const HandImpedance& hand,
                                                   std::unique_ptr<IntendedMotion> intended) {
  return std::make_unique<ObservedDevice>(device, hand, std::move(intended));
}

std::unique_ptr<ObservedInterface> observed_spidar(const SpidarSettings& settings, const HandImpedance& hand,
                                                   std::unique_ptr<IntendedMotion> intended, const Quaternion& q_GT) {
  SimulatedSpidarSettings simulated;
  simulated.geometry = settings.geometry;
  simulated.X_WS = settings.X_WS;
  simulated.hand = hand;
  auto grip = std::make_unique<GripOfTool>(std::move(intended), q_GT);
  return std::make_unique<ObservedSpidar>(settings, std::make_unique<SimulatedSpidar>(simulated, std::move(grip)),
                                          q_GT);
}

}  // namespace tegotae
