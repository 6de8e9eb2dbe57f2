// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/experiment_run.hpp>

#include <tegotae/lab/closed_loop_figures.hpp>
#include <tegotae/lab/gnuplot.hpp>
#include <tegotae/lab/physics_rate.hpp>
#include <tegotae/lab/run_recording.hpp>
#include <tegotae/lab/samples_file.hpp>
#include <tegotae/lab/scene_file.hpp>
#include <tegotae/lab/summary_json.hpp>
#include <tegotae/lab/text_file.hpp>
#include <tegotae/runtime/safety.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace tegotae {
namespace {

std::filesystem::path samples_file_of(const std::filesystem::path& folder, const Variant& variant, bool is_first) {
  return folder / (is_first ? "samples.csv" : fmt::format("samples-{}.csv", variant.name));
}

std::vector<std::string> notes_of(const Experiment& experiment, const VariantResult& result, const Session& session) {
  std::vector<std::string> notes = {fmt::format("experiment: {}, variant {}", experiment.name, result.variant.name)};
  if (!result.physics_rate_choice.empty()) notes.push_back(result.physics_rate_choice);
  for (std::string& note : session.notes()) notes.push_back(std::move(note));
  return notes;
}

void add_once(std::vector<std::string>& sentences, const std::string& sentence) {
  if (sentence.empty() || std::find(sentences.begin(), sentences.end(), sentence) != sentences.end()) return;
  sentences.push_back(sentence);
}

bool is_stopped(const ExperimentRequest& request) { return request.stop != nullptr && *request.stop; }

// So that nothing of an earlier run is taken for this one's, whatever becomes of it. Nothing else is touched.
void remove_earlier_results(const Experiment& experiment, const std::filesystem::path& folder) {
  std::error_code ignored;
  std::filesystem::remove(folder / "summary.json", ignored);
  for (size_t i = 0; i < experiment.variants.size(); ++i) {
    std::filesystem::remove(samples_file_of(folder, experiment.variants[i], i == 0), ignored);
  }
  std::vector<Figure> figures = closed_loop_figures(experiment, "");
  figures.insert(figures.end(), experiment.figures.begin(), experiment.figures.end());
  for (const Figure& figure : figures) {
    for (const char* ending : {".svg", ".png", ".gnuplot", ".dat"}) {
      std::filesystem::remove(folder / "figures" / (figure.name + ending), ignored);
    }
  }
}

// Runs to the end, in the kind of time that is asked for, and says so in the result.
void run_session(Session& session, const ExperimentRequest& request, const TickObserver& observer,
                 const Progress& progress, VariantResult& result) {
  if (!request.real_time) {
    session.run_simulated(observer, progress);
    return;
  }
  static const std::atomic<bool> never{false};
  result.real_time = session.run_realtime(observer, progress, request.stop != nullptr ? *request.stop : never);
}

SettingsRequest with_measured_rate(SettingsRequest wanted, const MujocoWorld& world, std::string& choice) {
  check_ranges(wanted);
  PhysicsRateChoice measured = measured_physics_rate(world, wanted.haptic_rate.value_or(SessionSettings{}.haptic_rate));
  wanted.physics_rate = measured.rate;
  choice = std::move(measured.reason);
  return wanted;
}

// The exact playback of a motion, in simulated time.
std::vector<TickRecord> played(const Experiment& experiment, const SessionSettings& settings, const Trajectory& motion,
                               const ExperimentRequest& request) {
  Session session(load_mujoco_world(find_scene(experiment.scene), experiment.tool), motion, settings);
  std::vector<TickRecord> records;
  session.run_simulated(
      [&](const TickRecord& record) {
        records.push_back(record);
        return !is_stopped(request);
      },
      [](double) {});
  return records;
}

ExperimentInterface interface_of(const Experiment& experiment, const SessionSettings& settings,
                                 const Trajectory& motion, const Tool& tool, const ExperimentRequest& request) {
  if (!request.interface) return {};
  const Vector3 up_W = settings.gravity.norm() > 0.0 ? Vector3(-settings.gravity.normalized()) : Vector3::UnitZ();
  return interface_for(*request.interface, motion, up_W, played(experiment, settings, motion, request), tool);
}

// What the interface kept from the hand.
void warn_of_limits(const VariantResult& result, const InterfaceRequest& interface,
                    std::vector<std::string>& warnings) {
  const auto saturated = [&](SafetyEvent event) { return result.summary.safety_events.at(name_of(event)); };
  const std::uint64_t force = saturated(SafetyEvent::kForceSaturated),
                      torque = saturated(SafetyEvent::kTorqueSaturated);
  if (force + torque > 0) {
    add_once(warnings, fmt::format("{}: the force that {} has was not enough in {} of {} ticks, its torque in {}.",
                                   result.variant.name, interface.choice.name, force, result.records.size(), torque));
  }
  if (result.display->shortfalls > 0) {
    add_once(
        warnings,
        fmt::format("{}: where its grip was, the motors of {} could not display what was commanded in {} of {} ticks.",
                    result.variant.name, interface.choice.name, result.display->shortfalls, result.records.size()));
  }
}

// To what the interface is rated for. What the result says of the metric length is said anew where that is lowered.
void hold_in_hand(SessionSettings& settings, const InterfaceRequest& interface, VariantResult& result,
                  std::vector<std::string>& warnings) {
  std::string warning;
  const SessionSettings held = held_in_hand(settings, interface, warning);
  if (!warning.empty()) add_once(warnings, fmt::format("{}: {}", result.variant.name, warning));
  if (held.metric_length < settings.metric_length) {
    result.metric_length = fmt::format("{:.3g} m", held.metric_length);
    result.variant.summary += fmt::format("; held to {}", result.metric_length);
  }
  settings = held;
}

VariantResult run_variant(const Experiment& experiment, const Variant& variant, const ExperimentRequest& request,
                          std::filesystem::path samples_file, const std::filesystem::path& recording_file,
                          std::vector<std::string>& warnings, const Progress& progress) {
  const std::filesystem::path scene = find_scene(experiment.scene);
  auto world = load_mujoco_world(scene, experiment.tool);
  for (const std::string& warning : scene_warnings(*world, scene)) add_once(warnings, warning);
  const Tool& tool = world->geometry().tool;
  VariantResult result{variant, {}, {}, {}, std::move(samples_file), std::nullopt};
  SettingsRequest wanted = request.settings.or_else(variant.settings)
                               .or_else(experiment.settings)
                               .or_else(settings_of(world->haptic_settings(), scene));
  if (request.real_time && !wanted.physics_rate)
    wanted = with_measured_rate(wanted, *world, result.physics_rate_choice);
  SessionSettings settings = decide_settings(wanted, tool);
  settings.gravity = world->gravity();
  result.metric_length =
      wanted.metric_length == 0.0 ? "gyration length" : fmt::format("{:.3g} m", settings.metric_length);
  if (request.interface) hold_in_hand(settings, *request.interface, result, warnings);
  result.settings = settings;
  Trajectory motion = experiment.motion(tool);
  ExperimentInterface interface = interface_of(experiment, settings, motion, tool, request);
  Session session(std::move(world), std::move(motion), settings, std::move(interface.interface));

  std::vector<std::string> notes = notes_of(experiment, result, session);
  notes.insert(notes.end(), interface.notes.begin(), interface.notes.end());
  SamplesFile samples(result.samples_file, notes, session.start(), session.sample_kind());
  std::optional<RunRecording> recording;
  if (!recording_file.empty()) {
    session.watch();
    recording.emplace(recording_file, session, notes, experiment.scene, experiment.name);
  }
  run_session(
      session, request,
      [&](const TickRecord& record) {
        samples.write(record);
        if (recording) recording->write(record);
        result.records.push_back(record);
        return !is_stopped(request);
      },
      progress, result);
  samples.close();
  if (recording) {
    recording->close();
    add_once(warnings, recording->error());
  }
  add_once(warnings, session.trouble());
  if (result.real_time) add_once(warnings, result.real_time->physics_error);
  result.summary = summarise(experiment, result.records, settings.haptic_rate);
  if (session.is_closed_loop()) {
    result.display = display_summary(result.records);
    warn_of_limits(result, *request.interface, warnings);
  }
  return result;
}

void describe_on(const std::string& interface, Experiment& experiment) {
  const std::string name = gnuplot_text(interface);
  for (Figure& figure : experiment.figures) figure.title += fmt::format(" (on {})", name);
  for (Figure& figure : closed_loop_figures(experiment, name)) experiment.figures.push_back(std::move(figure));
}

void name_metric_length(std::string& text, const VariantResult& variant) {
  const size_t place = text.find(kMetricLengthText);
  if (place != std::string::npos) text.replace(place, kMetricLengthText.size(), variant.metric_length);
}

Figure with_metric_lengths(Figure figure, const std::vector<VariantResult>& variants) {
  size_t first = 0;
  for (auto panel = figure.panels.rbegin(); panel != figure.panels.rend(); ++panel) {
    for (Curve& curve : panel->curves) name_metric_length(curve.label, variants.at(curve.variant));
    if (!panel->curves.empty()) first = panel->curves.front().variant;
  }
  name_metric_length(figure.title, variants.at(first));
  return figure;
}

}  // namespace

ExperimentResult run_experiment(const Experiment& chosen, const ExperimentRequest& request, const Progress& progress) {
  make_folder(request.folder);
  if (!request.recording.empty()) check_writable_place(request.recording);
  remove_earlier_results(chosen, request.folder);
  ExperimentResult result;
  const std::string method = request.settings.or_else(chosen.settings).method.value_or(SessionSettings{}.method);
  result.experiment = described_for(chosen, method);
  result.interface = request.interface;
  if (request.interface) describe_on(request.interface->choice.name, result.experiment);
  const Experiment& experiment = result.experiment;
  const auto count = static_cast<double>(experiment.variants.size());
  for (const Variant& variant : experiment.variants) {
    const auto done = static_cast<double>(result.variants.size());
    const bool is_first = result.variants.empty();
    result.variants.push_back(run_variant(experiment, variant, request,
                                          samples_file_of(request.folder, variant, is_first),
                                          is_first ? request.recording : std::filesystem::path(), result.warnings,
                                          [&](double part) { progress((done + part) / count); }));
    result.interrupted = is_stopped(request);
    if (result.interrupted) break;
  }
  result.summary_file = request.folder / "summary.json";
  write_text(result.summary_file, summary_json(result));
  return result;
}

std::filesystem::path draw_figures(const ExperimentResult& result, const std::filesystem::path& folder) {
  std::vector<RunSamples> runs;
  for (const VariantResult& variant : result.variants) runs.push_back({variant.records, variant.settings});
  std::filesystem::path figures = folder / "figures";
  for (const Figure& figure : result.experiment.figures) {
    draw(with_metric_lengths(figure, result.variants), runs, figures);
  }
  return figures;
}

}  // namespace tegotae
