// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/view_frame.hpp>

#include <tegotae/runtime/safety.hpp>
#include <tegotae/stream/json_text.hpp>

#include <cmath>

namespace tegotae {
namespace {

// Finer than any tick is long, and no longer than a person reads.
double to_microseconds(double seconds) { return std::round(seconds * 1e6) / 1e6; }

void add_contacts(JsonText& json, const ContactView& contacts) {
  json.key("planes").open_array();
  for (const ViewedPlane& plane : contacts.used_planes()) {
    json.open_array().components(plane.p_W).components(plane.n_W).rounded(plane.distance).close_array();
  }
  json.close_array().key("points").open_array();
  for (const ViewedPoint& point : contacts.used_points()) {
    json.open_array().components(point.p_W).rounded(point.gap).rounded(point.force).close_array();
  }
  json.close_array().key("anchors").open_array();
  for (const ViewedAnchor& anchor : contacts.used_anchors()) {
    json.open_array().components(anchor.p_W).components(anchor.stretch_W);
    json.count(anchor.slipping != 0 ? 1 : 0).close_array();
  }
  json.close_array();
}

void add_samples(JsonText& json, const std::vector<ViewedSample>& samples) {
  json.key("samples").open_array();
  for (const ViewedSample& sample : samples) {
    json.open_array().number(to_microseconds(sample.time));
    json.components(sample.displayed.force).components(sample.displayed.torque).close_array();
  }
  json.close_array();
}

void add_safety(JsonText& json, std::uint32_t events) {
  json.key("safety").open_array();
  for (std::size_t i = 0; i < kSafetyEvents; ++i) {
    if (((events >> i) & 1U) != 0) json.text(name_of(static_cast<SafetyEvent>(i)));
  }
  json.close_array();
}

JsonText& add_count(JsonText& json, const char* name, std::int64_t value) {
  return json.key(name).number(static_cast<double>(value));
}

void add_numbers(JsonText& json, const ViewedNumbers& numbers) {
  json.key("numbers").open_object();
  json.key("tick_median_us").rounded(numbers.tick_median_us).key("tick_p99_us").rounded(numbers.tick_p99_us);
  json.key("tick_p999_us").rounded(numbers.tick_p999_us).key("tick_max_us").rounded(numbers.tick_max_us);
  json.key("ticks").count(numbers.ticks);
  json.key("haptic_rate").rounded(numbers.haptic_rate).key("physics_rate").rounded(numbers.physics_rate);
  json.key("physics_step_ms").rounded(numbers.physics_step_ms).key("staleness_ms").rounded(numbers.staleness_ms);
  json.key("missed").count(numbers.missed);
  add_count(json, "near_objects", numbers.near_objects);
  add_count(json, "contacts", numbers.contacts);
  add_count(json, "active", numbers.active);
  add_count(json, "constraints", numbers.constraints);
  add_count(json, "dropped", numbers.dropped);
  add_count(json, "iterations", numbers.iterations);
  json.key("depth").rounded(numbers.depth).key("energy").rounded(numbers.energy);
  json.key("status").text(name_of(numbers.status));
  add_safety(json, numbers.safety_events);
  json.close_object();
}

void add_histogram(JsonText& json, const ViewedHistogram& histogram) {
  json.key("histogram").open_object().key("edges_us").open_array();
  for (const double edge : histogram.edges_us) json.rounded(edge);
  json.close_array().key("counts").open_array();
  for (const std::uint64_t count : histogram.counts) json.count(count);
  json.close_array().close_object();
}

void add_circumstances(JsonText& json, const ViewFrame& frame) {
  json.key("paused").flag(frame.paused).key("recording").flag(frame.recording.has_value());
  if (frame.recording) {
    json.key("recording_file").text(frame.recording->file).key("recording_ticks").count(frame.recording->ticks);
  }
  json.key("motion");
  frame.motion ? json.text(*frame.motion) : json.null();
  json.key("hand");
  frame.hand ? json.count(*frame.hand) : json.null();
  add_count(json, "viewers", frame.viewers);
}

}  // namespace

std::string encode(const ViewFrame& frame) {
  constexpr std::size_t kUsual = 16 * 1024;  // bytes; longer ones grow
  JsonText json;
  json.reserve(kUsual);
  json.open_object().key("type").text("state").key("n").count(frame.n);
  json.key("t").number(to_microseconds(frame.time)).key("made").number(std::round(frame.made_ms * 10.0) / 10.0);
  json.key("tool").pose(frame.X_WT).key("proxy").pose(frame.X_WP).key("target");
  frame.target ? json.pose(*frame.target) : json.null();
  json.key("wrench").wrench(frame.displayed).key("bodies").open_array();
  for (const PlainPose& X_WB : frame.bodies) json.pose(X_WB);
  json.close_array();
  add_contacts(json, frame.contacts);
  add_samples(json, frame.samples);
  add_numbers(json, frame.numbers);
  if (frame.histogram) add_histogram(json, *frame.histogram);
  add_circumstances(json, frame);
  return json.close_object().take();
}

}  // namespace tegotae
