// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/scene_message.hpp>

#include <tegotae/stream/json_text.hpp>

#include <cmath>

namespace tegotae {
namespace {

constexpr int kProtocol = 1;

// A face is convex and runs counter-clockwise: a fan of triangles about its first vertex.
void add_triangles(JsonText& json, const Polytope& hull) {
  json.key("triangles").open_array();
  for (const Polytope::Face& face : hull.faces) {
    const std::span<const int> corners = hull.vertices_of(face);
    for (std::size_t i = 2; i < corners.size(); ++i) {
      for (const int corner : {corners[0], corners[i - 1], corners[i]}) json.count(static_cast<std::uint64_t>(corner));
    }
  }
  json.close_array();
}

void add_shapes(JsonText& json, std::span<const Shape> shapes) {
  json.key("shapes").open_array();
  for (const Shape& shape : shapes) {
    json.open_object().key("kind").text(name_of(shape.kind)).key("size").vector(shape.size);
    json.key("pose").pose(shape.X_BS).key("colour").open_array();
    for (const float part : {shape.colour.r, shape.colour.g, shape.colour.b, shape.colour.a}) {
      json.rounded(static_cast<double>(part));
    }
    json.close_array();
    if (shape.kind == ShapeKind::kHull && shape.polytope != nullptr) {
      json.key("vertices").open_array();
      for (const Vector3& p_S : shape.polytope->vertices) json.components(p_S);
      json.close_array();
      add_triangles(json, *shape.polytope);
    }
    json.close_object();
  }
  json.close_array();
}

void add_tool(JsonText& json, const Tool& tool) {
  json.key("tool").open_object().key("name").text(tool.name);
  json.key("centre_of_mass").vector(tool.mass.centre_of_mass);
  json.key("gyration_length").rounded(tool.mass.gyration_length());
  add_shapes(json, tool.pieces);
  json.close_object();
}

void add_bodies(JsonText& json, std::span<const Body> bodies) {
  json.key("bodies").open_array();
  for (const Body& body : bodies) {
    json.open_object().key("name").text(body.name).key("moving_index").number(body.moving_index);
    json.key("pose").pose(body.X_WB);
    add_shapes(json, body.pieces);
    json.close_object();
  }
  json.close_array();
}

void add_choices(JsonText& json, std::string_view key, std::span<const NamedChoice> choices) {
  json.key(key).open_array();
  for (const NamedChoice& choice : choices) {
    json.open_object().key("name").text(choice.name).key("summary").text(choice.summary).close_object();
  }
  json.close_array();
}

}  // namespace

Vector3 up_axis(const Vector3& gravity) noexcept {
  const bool is_y = -gravity.y() > std::abs(gravity.x()) && -gravity.y() > std::abs(gravity.z());
  return is_y ? Vector3::UnitY() : Vector3::UnitZ();
}

std::string encode_scene(const SceneGeometry& geometry, const SceneNames& names) {
  JsonText json;
  json.open_object().key("type").text("scene").key("protocol").count(kProtocol);
  json.key("mode").text(names.mode).key("name").text(names.name).key("program").text(names.program);
  json.key("z_up").vector(names.up);
  add_tool(json, geometry.tool);
  add_bodies(json, geometry.bodies);
  json.key("scenes").open_array();
  for (const std::string& scene : names.scenes) json.text(scene);
  json.close_array();
  add_choices(json, "experiments", names.experiments);
  add_choices(json, "motions", names.motions);
  add_choices(json, "methods", names.methods);
  json.key("interface").text(names.interface);
  if (names.duration) json.key("duration").number(*names.duration);
  return json.close_object().take();
}

std::string encode_settings(std::string_view method, std::span<const ShownSetting> settings) {
  JsonText json;
  json.open_object().key("type").text("settings").key("method").text(method).key("values").open_array();
  for (const ShownSetting& setting : settings) {
    json.open_object().key("name").text(setting.name).key("label").text(setting.label);
    json.key("unit").text(setting.unit).key("value");
    setting.value ? json.number(*setting.value) : json.null();
    json.key("least").number(setting.least).key("most").number(setting.most);
    json.key("zero_too").flag(setting.zero_too).key("is_switch").flag(setting.is_switch);
    json.key("available").flag(setting.available).close_object();
  }
  return json.close_array().close_object().take();
}

}  // namespace tegotae
