// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/experiment_run.hpp>
#include <tegotae/lab/samples_file.hpp>
#include <tegotae/lab/scene_file.hpp>
#include <tegotae/lab/summary_json.hpp>
#include <tegotae/lab/text_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace tegotae {
namespace {

std::filesystem::path samples_file_of(const std::filesystem::path& folder, const Variant& variant, bool is_first) {
  return folder / (is_first ? "samples.csv" : fmt::format("samples-{}.csv", variant.name));
}

std::vector<std::string> notes_of(const Experiment& experiment, const Variant& variant, const Session& session) {
  std::vector<std::string> notes = {fmt::format("experiment: {}, variant {}", experiment.name, variant.name)};
  for (std::string& note : session.notes()) notes.push_back(std::move(note));
  return notes;
}

void add_once(std::vector<std::string>& sentences, const std::string& sentence) {
  if (sentence.empty() || std::find(sentences.begin(), sentences.end(), sentence) != sentences.end()) return;
  sentences.push_back(sentence);
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

VariantResult run_variant(const Experiment& experiment, const Variant& variant, const ExperimentRequest& request,
                          std::filesystem::path samples_file, std::vector<std::string>& warnings,
                          const Progress& progress) {
  auto world = load_mujoco_world(find_scene(experiment.scene), experiment.tool);
  for (const std::string& warning : world->warnings()) add_once(warnings, warning);
  const Tool& tool = world->geometry().tool;
  const SettingsRequest wanted = request.settings.or_else(variant.settings)
                                     .or_else(experiment.settings)
                                     .or_else(settings_of(world->haptic_settings()));
  const SessionSettings settings = decide_settings(wanted, tool);
  Trajectory motion = experiment.motion(tool);
  Session session(std::move(world), std::move(motion), settings);

  VariantResult result{variant, settings, {}, {}, std::move(samples_file), std::nullopt};
  SamplesFile samples(result.samples_file, notes_of(experiment, variant, session), session.start());
  run_session(
      session, request,
      [&](const TickRecord& record) {
        samples.write(record);
        result.records.push_back(record);
        return true;
      },
      progress, result);
  samples.close();
  add_once(warnings, session.trouble());
  if (result.real_time) add_once(warnings, result.real_time->physics_error);
  result.summary = summarise(experiment, result.records, settings.haptic_rate);
  return result;
}

}  // namespace

ExperimentResult run_experiment(const Experiment& experiment, const ExperimentRequest& request,
                                const Progress& progress) {
  make_folder(request.folder);
  ExperimentResult result;
  const auto count = static_cast<double>(experiment.variants.size());
  for (const Variant& variant : experiment.variants) {
    const auto done = static_cast<double>(result.variants.size());
    result.variants.push_back(run_variant(experiment, variant, request,
                                          samples_file_of(request.folder, variant, result.variants.empty()),
                                          result.warnings, [&](double part) { progress((done + part) / count); }));
  }
  result.summary_file = request.folder / "summary.json";
  write_text(result.summary_file, summary_json(experiment, result));
  return result;
}

std::filesystem::path draw_figures(const Experiment& experiment, const ExperimentResult& result,
                                   const std::filesystem::path& folder) {
  std::vector<RunSamples> runs;
  for (const VariantResult& variant : result.variants) runs.push_back({variant.records, variant.settings});
  std::filesystem::path figures = folder / "figures";
  for (const Figure& figure : experiment.figures) draw(figure, runs, figures);
  return figures;
}

}  // namespace tegotae
