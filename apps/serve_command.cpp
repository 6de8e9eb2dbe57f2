// SPDX-License-Identifier: Apache-2.0
#include <apps/commands.hpp>
#include <apps/interruption.hpp>
#include <apps/serving_options.hpp>
#include <apps/settings_options.hpp>
#include <apps/validators.hpp>
#include <tegotae/device/heartbeat.hpp>
#include <tegotae/device/interface_drivers.hpp>
#include <tegotae/device/interface_remarks.hpp>
#include <tegotae/device/kept_guard.hpp>
#include <tegotae/lab/experiment.hpp>
#include <tegotae/lab/live_messages.hpp>
#include <tegotae/lab/live_session.hpp>
#include <tegotae/lab/playback_driver.hpp>
#include <tegotae/lab/scene_file.hpp>

#include <fmt/format.h>
#include <sys/prctl.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tegotae {
namespace {

struct ServeOptions {
  std::string scene, tool, experiment, interface = "page", recording, recordings = ".";
  ServingOptions serving;
  SettingsOptions settings;
};

LiveScene first_scene(const ServeOptions& options) {
  if (options.scene.empty() && !options.tool.empty()) {
    throw UsageError("--tool is a body of SCENE; name the scene's file too, or leave it out.");
  }
  if (!options.experiment.empty()) {
    if (!options.scene.empty()) throw UsageError("give either a scene or --experiment, not both.");
    return live_scene_of(find_experiment(options.experiment));
  }
  if (options.scene.empty()) return {"table", find_scene("table.xml")};
  const std::filesystem::path file = options.scene;
  return {file.filename().string(), file, options.tool.empty() ? "tool" : options.tool};
}

LiveSessionOptions session_options(const ServeOptions& options) {
  LiveSessionOptions session;
  session.settings = options.settings.checked();
  session.scene = first_scene(options);
  session.scenes = shipped_scenes();
  if (!options.scene.empty()) session.scenes.insert(session.scenes.begin(), session.scene);
  session.recordings = options.recordings;
  if (!options.recording.empty()) session.file = options.recording;
  return session;
}

void log(NoticeLevel level, const std::string& text) {
  if (level == NoticeLevel::kInfo) {
    fmt::print("tegotae: {}\n", text);
    std::fflush(stdout);
    return;
  }
  fmt::print(stderr, "tegotae: {}: {}\n", level == NoticeLevel::kWarning ? "warning" : "error", text);
}

// What the hand holds, and the process that brings it to zero where this one dies or stands still.
struct HeldInterface {
  std::unique_ptr<HeartbeatMemory> heart;
  std::unique_ptr<KeptGuard> guard;
  std::unique_ptr<HapticInterface> device;    ///< null: a simulated one, which the page guides
  std::unique_ptr<BeatingInterface> guarded;  ///< the device, where there is a guard

  HapticInterface* in_use() const { return guarded ? static_cast<HapticInterface*>(guarded.get()) : device.get(); }
};

const InterfaceDriver& driver_called(const std::string& name) {
  try {
    return find_interface_driver(name, known_drivers());
  } catch (const InterfaceError& error) {
    throw UsageError(fmt::format("{} 'page' is a simulated interface and hand that the page guides.", error.what()));
  }
}

HeldInterface hold_interface(const std::string& text) {
  if (text == "page") return {};
  const InterfaceName name = parse_interface_name(text);
  if (name.driver == "simulated") {
    throw UsageError(
        fmt::format("{0}: a simulated hand holds it, which follows an experiment: tegotae experiment NAME --interface "
                    "{0}; here leave --interface out: the page is the hand.",
                    text));
  }
  const InterfaceDriver& driver = driver_called(name.driver);
  listen_for_interruption();  // from here on a signal leaves by way of the interface's destructor
  HeldInterface held;
  const InterfaceRescue rescue = rescue_of(driver, name.options);
  if (rescue.time != RescueTime::kNever) {
    // A core dump would keep the sockets open while it is written, and the device at its last force.
    prctl(PR_SET_DUMPABLE, 0);
    held.heart = std::make_unique<HeartbeatMemory>();
    held.guard = std::make_unique<KeptGuard>(GuardProgram{"/proc/self/exe", {"guard", text}, held.heart->descriptor()},
                                             interrupt);
  }
  fmt::print("tegotae: opening {}; {}.\n", text, driver.before_opening);
  std::fflush(stdout);
  held.device = driver.open(name.options);
  if (held.heart) held.guarded = std::make_unique<BeatingInterface>(*held.device, **held.heart);
  const InterfaceCapability capability = held.device->capability();
  const std::string limits = std::isfinite(capability.max_force)
                                 ? fmt::format("{:g} N, {:g} N m at most", capability.max_force, capability.max_torque)
                                 : "without limits of its own";
  fmt::print("tegotae: {} is in the hand: {}. After a crash: {}\n", capability.name, limits, rescue.after_a_crash);
  return held;
}

void tell_remarks(HapticInterface* device) {
  auto* told = dynamic_cast<InterfaceRemarks*>(device);
  const std::string remarks = told != nullptr ? told->remarks() : "";
  if (!remarks.empty()) log(NoticeLevel::kWarning, remarks);
}

void tell_safeguards(const SettingsRequest& settings) {
  if (settings.beyond_rating.value_or(0.0) != 0.0) {
    log(NoticeLevel::kWarning,
        "stiffness and damping are not held to what the interface is rated for (--beyond-rating on).");
  }
  if (settings.energy_bound.value_or(1.0) == 0.0) {
    log(NoticeLevel::kWarning, "the energy bound is off: a stiff contact may vibrate (--energy-bound off).");
  }
  if (settings.dead_man_button) {
    log(NoticeLevel::kInfo,
        fmt::format("nothing is felt but while button {:g} of the interface is held down.", *settings.dead_man_button));
  }
}

// The page brings the tool itself to where it is dragged, and has no buttons.
void refuse_for_page(const SettingsRequest& settings) {
  if (settings.dead_man_button || settings.clutch_button) {
    throw UsageError(fmt::format("the page has no buttons for {}; leave it out, or give --interface.",
                                 settings.dead_man_button ? "--dead-man-button" : "--clutch-button"));
  }
  if (settings.translation_scale || settings.rotation_scale || settings.force_scale) {
    throw UsageError(
        "the page moves the tool itself, without scales; leave --translation-scale, --rotation-scale and "
        "--force-scale out, or give --interface.");
  }
}

void serve(const ServeOptions& options) {
  if (options.interface != "page" && !options.experiment.empty()) {
    throw UsageError("an experiment plays a motion of its own; give either --experiment or --interface, not both.");
  }
  if (options.interface == "page") refuse_for_page(options.settings.checked());
  const HeldInterface held = hold_interface(options.interface);
  tell_safeguards(options.settings.checked());
  ViewerServer server(options.serving.server_options());
  LiveSessionOptions session_wanted = session_options(options);
  session_wanted.device = held.in_use();
  if (held.guard) session_wanted.news = [&guard = *held.guard] { return guard.take_news(); };
  LiveSession session(std::move(session_wanted), output_to(server), log);
  listen_for_interruption();
  serve_until_stopped(server, session.inbox(), [&] {
    options.serving.announce(server, session.scene_name());
    session.run(interrupted());
  });
  tell_remarks(held.device.get());
  if (held.guard && held.guard->has_failed()) {
    throw InterfaceError("the program ended, and the interface is at zero: no process can be kept that guards it.");
  }
}

}  // namespace

void add_serve_command(CLI::App& program) {
  auto options = std::make_shared<ServeOptions>();
  CLI::App* const command = program.add_subcommand(
      "serve", "Run a scene in real time and serve a page that shows it, steers it and is the hand.");
  command->add_option("SCENE", options->scene, "Scene: an MJCF or URDF file; default: a table with free boxes")
      ->type_name("");
  command->add_option("--tool", options->tool, "Body of SCENE that the hand moves; default: tool")
      ->type_name("BODY")
      ->check(not_empty("a body"));
  command->add_option("--experiment", options->experiment, "Experiment to play, in place of a scene")
      ->type_name("NAME");
  command
      ->add_option(
          "--interface", options->interface,
          "Interface in the hand: one that 'tegotae interfaces' lists (but simulated:NAME, which is for experiments); "
          "default: page, simulated and guided from the page")
      ->type_name("NAME[:OPTIONS]");
  command->add_option("--record", options->recording, "Recording (MCAP) to write from the beginning")
      ->type_name("FILE")
      ->check(not_empty("a file"));
  command
      ->add_option("--recordings", options->recordings,
                   "Folder of the recordings that are started from the page; default: this one")
      ->type_name("DIR")
      ->check(CLI::Validator(CLI::ExistingDirectory).description(""));
  options->serving.add(*command);
  options->settings.add_all(*command);
  options->settings.add_interface(*command);
  command->callback([options] { serve(*options); });
}

}  // namespace tegotae
