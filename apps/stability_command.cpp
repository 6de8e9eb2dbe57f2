// SPDX-License-Identifier: Apache-2.0
#include <apps/commands.hpp>
#include <apps/interruption.hpp>
#include <apps/progress_line.hpp>
#include <apps/validators.hpp>
#include <tegotae/device/simulated_presets.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/stability_json.hpp>
#include <tegotae/lab/text_file.hpp>
#include <tegotae/render/rendering_method.hpp>

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace tegotae {
namespace {

struct StabilityOptions {
  std::string method, contact, folder = "out/stability";
  std::string device = "laboratory", hand = "moderate";
  std::optional<double> metric_length;
  double delay = 1.0;         // haptic periods
  double stiffness = 1000.0;  // N/m, for the energy
  double physics_rate = 20.0, haptic_rate = 1000.0;
  bool all = false;
};

std::vector<std::string> chosen_methods(const StabilityOptions& options) {
  if (options.all && !options.method.empty()) throw UsageError("give either --method or --all, not both.");
  if (!options.all) return {options.method.empty() ? SessionSettings{}.method : options.method};
  std::vector<std::string> names;
  for (const MethodName& method : method_names()) names.emplace_back(method.name);
  return names;
}

std::vector<TouchedFeature> chosen_features(const StabilityOptions& options) {
  if (!options.contact.empty()) return {touched_feature(options.contact)};
  return {touched_features().begin(), touched_features().end()};
}

// The metric lengths that a method is measured with: what was asked for, else its own, and the cube's gyration length
// besides where that differs.
std::vector<SessionSettings> settings_of_method(const StabilityOptions& options, const std::string& method) {
  SettingsRequest request;
  request.method = method;
  request.stiffness = options.stiffness;
  request.physics_rate = options.physics_rate;
  request.haptic_rate = options.haptic_rate;
  request.metric_length = options.metric_length;
  const Tool tool = cube_over_floor().tool;
  std::vector<SessionSettings> result{decide_settings(request, tool)};
  request.metric_length = tool.mass.gyration_length();
  if (!options.metric_length && result[0].metric_length != request.metric_length) {
    result.push_back(decide_settings(request, tool));
  }
  return result;
}

std::vector<SessionSettings> all_settings(const StabilityOptions& options) {
  std::vector<SessionSettings> result;
  for (const std::string& method : chosen_methods(options)) {
    for (SessionSettings& settings : settings_of_method(options, method)) result.push_back(std::move(settings));
  }
  return result;
}

// Leaves a measurement in its midst.
struct MeasurementStopped {};

// Fills in a row after the other, until it is done or MeasurementStopped is thrown.
void measure(const std::vector<SessionSettings>& all, const std::vector<TouchedFeature>& features,
             StabilityReport& report) {
  const double works = static_cast<double>(all.size() * (features.size() + 1));
  ProgressLine line("stability");
  const Progress progress = [&](double part) {
    if (interrupted()) throw MeasurementStopped{};
    line.show((static_cast<double>(report.limits.size() + report.energies.size()) + part) / works);
  };
  StabilitySetup present = report.setup;
  for (const SessionSettings& settings : all) {
    present.settings = settings;
    for (const TouchedFeature& feature : features) {
      report.limits.push_back(measure_stability(present, feature, progress));
    }
    report.energies.push_back(measure_energy(present, kEnergyDuration, kEnergySeed, progress));
  }
}

StabilityReport measured(const StabilityOptions& options, const StabilitySetup& setup,
                         const std::vector<SessionSettings>& all, const std::vector<TouchedFeature>& features) {
  StabilityReport report;
  report.setup = setup;
  report.hand = options.hand;
  try {
    measure(all, features, report);
  } catch (const MeasurementStopped&) {
    report.interrupted = true;
  }
  return report;
}

void print_setup(const StabilityReport& report) {
  const SimulatedDevice& device = report.setup.device;
  const HandImpedance& hand = report.setup.hand;
  fmt::print(
      "device {}: {:g} kg, {:g} N s/m, {:g} N m s/rad, friction {:g} N, encoder {:g} um, delay {:g} ms\n"
      "hand {}: {:g} kg, {:g} N s/m, {:g} N m s/rad, {:g} N/m, {:g} N m/rad\n"
      "haptics {:g} Hz, physics {:g} Hz; stable: the touch of 1 mm/s decays within 5 s\n\n",
      device.capability.name, device.mechanics.mass, device.mechanics.damping, device.mechanics.rotational_damping,
      device.mechanics.friction_force, device.capability.encoder_step * 1e6, device.delay * 1e3, report.hand, hand.mass,
      hand.damping, hand.rotational_damping, hand.stiffness, hand.rotational_stiffness,
      report.setup.settings.haptic_rate, report.setup.settings.physics_rate);
}

// Marked where nothing unstable was found.
std::string largest_text(const StabilityLimit& limit) {
  return fmt::format("{}{:.4g}", std::isfinite(limit.smallest_unstable) ? "" : "> ", limit.largest_stable);
}

void print_report(const StabilityReport& report) {
  print_setup(report);
  fmt::print("{:<14}{:>9}  {:<9}{:>14}{:>14}{:>9}{:>14}{:>10}{:>14}{:>10}\n", "method", "l [m]", "contact",
             "largest [N/m]", "linear [N/m]", "ratio", "C-S [N/m]", "ratio", "A-O [N/m]", "ratio");
  for (const StabilityRow& row : report.limits) {
    const StiffnessBounds& bounds = row.bounds;
    const double largest = row.limit.largest_stable;
    fmt::print("{:<14}{:>9.4g}  {:<9}{:>14}{:>14.4g}{:>9.3f}{:>14.4g}{:>10.3g}{:>14.4g}{:>10.3g}\n", row.method,
               row.metric_length, row.contact, largest_text(row.limit), bounds.linear, row.ratio_to_linear(),
               bounds.colgate_schenkel, largest / bounds.colgate_schenkel, bounds.abbott_okamura,
               largest / bounds.abbott_okamura);
  }
  fmt::print(
      "linear: (b + B)/(T/2 + t_d) of interface and hand, the least of translation and rotation;\n"
      "C-S: Colgate and Schenkel, A-O: Abbott and Okamura, both of the interface alone and without delay\n\n");
  fmt::print("{:<14}{:>9}{:>13}{:>10}{:>15}{:>11}{:>17}{:>13}{:>18}\n", "method", "l [m]", "k [N/m]", "contacts",
             "in contact [s]", "given [J]", "spring's own [J]", "excess [J]", "worst contact [J]");
  for (const EnergyRow& row : report.energies) {
    fmt::print("{:<14}{:>9.4g}{:>13.4g}{:>10}{:>15.1f}{:>11.3g}{:>17.3g}{:>13.3g}{:>18.3g}\n", row.method,
               row.metric_length, row.stiffness, row.contacts, row.time_in_contact, row.given, row.allowed, row.excess,
               row.worst_contact);
  }
  fmt::print("energy given to the hand in {:g} s of random contact, and beyond the sampled spring's own\n",
             kEnergyDuration);
}

StabilitySetup setup_of(const StabilityOptions& options) {
  StabilitySetup setup;
  setup.device = simulated_device(options.device);
  setup.hand = simulated_hand(options.hand);
  setup.device.delay = options.delay / options.haptic_rate;
  return setup;
}

void run(const StabilityOptions& options) {
  StabilitySetup setup;
  std::vector<SessionSettings> all;
  std::vector<TouchedFeature> features;
  try {
    all = all_settings(options);
    features = chosen_features(options);
    setup = setup_of(options);
  } catch (const InputError& error) {
    throw UsageError(error.what());
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  setup.settings = all.front();
  make_folder(options.folder);
  const std::filesystem::path file = std::filesystem::path(options.folder) / "stability.json";
  std::error_code ignored;
  std::filesystem::remove(file, ignored);  // an earlier one is not taken for this one's, whatever becomes of it
  listen_for_interruption();
  const StabilityReport report = measured(options, setup, all, features);
  write_text(file, stability_json(report));
  print_report(report);
  if (report.interrupted) {
    throw Interruption(fmt::format("interrupted; the rows until then stand in {}.", file.string()));
  }
  fmt::print("\nreport: {}\n", file.string());
}

}  // namespace

void add_stability_command(CLI::App& program) {
  auto options = std::make_shared<StabilityOptions>();
  CLI::App* const command = program.add_subcommand(
      "stability",
      "Measure, with a simulated hand and interface in closed loop, how stiff a method may be and what energy it "
      "injects; repeats bit for bit.");
  command->add_option("--method", options->method, "Rendering method (see 'tegotae methods'); default: proxy")
      ->type_name("NAME");
  command->add_flag("--all", options->all, "Measure every method");
  command->add_option("--contact", options->contact, "Only 'vertex', 'edge' or 'face' of the cube; default: all three")
      ->type_name("NAME");
  command
      ->add_option("--metric-length", options->metric_length,
                   "Length l that weighs rotation against translation; default: the method's own and, where it "
                   "differs, the cube's gyration length")
      ->type_name("m");
  command->add_option("--device", options->device, "Simulated device: laboratory, page, stylus or parallel")
      ->type_name("NAME")
      ->capture_default_str();
  command->add_option("--hand", options->hand, "Simulated hand: relaxed, moderate or firm")
      ->type_name("NAME")
      ->capture_default_str();
  command->add_option("--delay", options->delay, "Haptic periods from a command to its being displayed")
      ->check(CLI::Range(0.0, 10.0))
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--stiffness", options->stiffness, "Stiffness for the energy measurement")
      ->type_name("N/m")
      ->capture_default_str();
  command->add_option("--physics-rate", options->physics_rate, "Rate of the physics steps")
      ->type_name("Hz")
      ->capture_default_str();
  command->add_option("--haptic-rate", options->haptic_rate, "Rate of the haptic ticks")
      ->type_name("Hz")
      ->capture_default_str();
  command->add_option("--out", options->folder, "Folder for stability.json")
      ->type_name("DIR")
      ->check(not_empty("a folder"))
      ->capture_default_str();
  command->callback([options] { run(*options); });
}

}  // namespace tegotae
