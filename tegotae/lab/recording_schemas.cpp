// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/recording_schemas.hpp>

#include <nlohmann/json.hpp>

namespace tegotae {
namespace {

constexpr std::string_view kSessionSchema = R"({
"title": "tegotae.Session.v1", "type": "object", "description": "What the run was.",
"properties": {
  "format": {"type": "integer", "description": "version of the recording's format"},
  "notes": {"type": "array", "items": {"type": "string"}, "description": "settings and the like, a line each"}
}})";

constexpr std::string_view kSceneSchema = R"({
"title": "tegotae.Scene.v1", "type": "object",
"description": "What the live view shows: bodies and tool with their shapes (SI units; a pose is x, y, z in m and a unit quaternion, w first; colours 0 to 1). All of it stands from here to the next message of this topic.",
"properties": {
  "type": {"type": "string", "description": "scene"},
  "protocol": {"type": "integer", "description": "version of the live view's protocol"},
  "mode": {"type": "string"},
  "name": {"type": "string"},
  "program": {"type": "string", "description": "name and version of what wrote it"},
  "z_up": {"type": "array", "items": {"type": "number"}, "description": "the world's up axis, unit vector"},
  "interface": {"type": "string"},
  "scenes": {"type": "array", "items": {"type": "string"}}
}})";

constexpr std::string_view kSettingsSchema = R"({
"title": "tegotae.Settings.v1", "type": "object",
"description": "The settings from here to the next message of this topic.",
"properties": {
  "type": {"type": "string", "description": "settings"},
  "method": {"type": "string"},
  "values": {"type": "array", "items": {"type": "object", "properties": {
    "name": {"type": "string"},
    "label": {"type": "string"},
    "unit": {"type": "string", "description": "of value, least and most"},
    "value": {"type": "number", "description": "null: the scene's own"},
    "least": {"type": "number"},
    "most": {"type": "number"},
    "zero_too": {"type": "boolean", "description": "0 is permitted, though below least"},
    "is_switch": {"type": "boolean", "description": "0 or 1"},
    "available": {"type": "boolean", "description": "the method has it"}
  }}}
}})";

constexpr std::string_view kStateSchema = R"({
"title": "tegotae.State.v1", "type": "object",
"description": "What the live view shows of one moment, 60 a second. World axes, SI units; a number that is not finite or not known is null. Also, as arrays of arrays: bodies [x, y, z (m), qw, qx, qy, qz] of the moving bodies; planes [px, py, pz (m), nx, ny, nz, distance (m)] of the near objects; points [x, y, z (m), gap (m), force (N)], the contact points; anchors [x, y, z (m), sx, sy, sz (m), slipping (0 or 1)], the frictional contacts; samples [t (s), fx, fy, fz (N), tx, ty, tz (N m)], the wrenches displayed in the last 50 ms.",
"properties": {
  "type": {"type": "string", "description": "state"},
  "n": {"type": "number", "description": "count of states"},
  "t": {"type": "number", "description": "time of the session, s"},
  "made": {"type": "number", "description": "when it was put together, ms since the Unix epoch"},
  "tool": {"type": "array", "items": {"type": "number"}, "description": "pose of the tool's frame as it is held: x, y, z in m, unit quaternion w first"},
  "proxy": {"type": "array", "items": {"type": "number"}, "description": "pose of the tool's frame as the world allows it, likewise"},
  "target": {"type": "array", "items": {"type": "number"}, "description": "pose that the hand means, likewise, or null"},
  "wrench": {"type": "array", "items": {"type": "number"}, "description": "displayed: force in N, torque about the tool's centre of mass in N m"},
  "numbers": {"type": "object", "properties": {
    "tick_median_us": {"type": "number", "description": "computation of a tick, us"},
    "tick_p99_us": {"type": "number", "description": "us"},
    "tick_p999_us": {"type": "number", "description": "us"},
    "tick_max_us": {"type": "number", "description": "us"},
    "ticks": {"type": "number"},
    "haptic_rate": {"type": "number", "description": "Hz"},
    "physics_rate": {"type": "number", "description": "Hz"},
    "physics_step_ms": {"type": "number", "description": "median, ms"},
    "staleness_ms": {"type": "number", "description": "age of the model, ms"},
    "missed": {"type": "number", "description": "haptic deadlines"},
    "near_objects": {"type": "number"},
    "contacts": {"type": "number", "description": "contact points"},
    "active": {"type": "number", "description": "contact points that push"},
    "constraints": {"type": "number"},
    "dropped": {"type": "number"},
    "iterations": {"type": "number"},
    "depth": {"type": "number", "description": "greatest penetration where the hand holds the tool, m"},
    "energy": {"type": "number", "description": "injected beyond a sampled spring's, J"},
    "status": {"type": "string"},
    "safety": {"type": "array", "items": {"type": "string"}, "description": "what the safety stage did in the last 50 ms"}
  }},
  "histogram": {"type": "object", "description": "of tick times", "properties": {
    "edges_us": {"type": "array", "items": {"type": "number"}, "description": "us"},
    "counts": {"type": "array", "items": {"type": "number"}}
  }},
  "paused": {"type": "boolean"},
  "recording": {"type": "boolean"},
  "recording_file": {"type": "string"},
  "recording_ticks": {"type": "number"},
  "motion": {"type": "string", "description": "scripted motion or experiment that plays, or null"},
  "hand": {"type": "number", "description": "number of the viewer that moves the tool, or null"},
  "viewers": {"type": "number"}
}})";

}  // namespace

std::string_view schema_of_session() noexcept { return kSessionSchema; }
std::string_view schema_of_scene() noexcept { return kSceneSchema; }
std::string_view schema_of_settings() noexcept { return kSettingsSchema; }
std::string_view schema_of_state() noexcept { return kStateSchema; }

std::string schema_of_tick(SampleKind kind) {
  nlohmann::ordered_json properties;
  for (const auto& column : sample_columns(0.0, kind)) {
    properties[column.name] = {{"type", "number"}};
    if (!column.unit.empty()) properties[column.name]["description"] = "in " + column.unit;
  }
  return nlohmann::ordered_json{{"title", kTickTopic.schema}, {"type", "object"}, {"properties", properties}}.dump();
}

}  // namespace tegotae
