// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/viewer_command.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace tegotae {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kLongestMessage = 64 * 1024;    // bytes, as the protocol says
constexpr int kDeepest = 4;                           // brackets within brackets; a pose needs two
constexpr std::size_t kLongestName = 200;             // bytes; no name that there is comes near
constexpr double kFarthest = 100.0;                   // m: no scene is that large, and no slip of the mouse goes on
constexpr double kLeastNorm = 1e-3, kMostNorm = 1e3;  // of a quaternion: beyond, its direction is not meant
constexpr double kLatest = 1e9;                       // s: thirty years
constexpr double kSlowest = 0.01, kFastest = 100.0;

/// Why a message is refused, one sentence.
struct Refusal {
  std::string sentence;
};

// Counted before parsing, so that no parser meets a nest that it could choke on.
bool is_too_deep(std::string_view message) noexcept {
  int depth = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < message.size(); ++i) {
    const char c = message[i];
    if (in_text && c == '\\') {
      ++i;
    } else if (c == '"') {
      in_text = !in_text;
    } else if (!in_text && (c == '{' || c == '[')) {
      if (++depth > kDeepest) return true;
    } else if (!in_text && (c == '}' || c == ']')) {
      --depth;
    }
  }
  return false;
}

Json object_of(std::string_view message) {
  if (message.size() > kLongestMessage) {
    throw Refusal{fmt::format("A message has {} bytes at most, this one {}.", kLongestMessage, message.size())};
  }
  if (is_too_deep(message)) throw Refusal{"The message nests its brackets too deeply."};
  Json json = Json::parse(message, nullptr, false);
  if (!json.is_object()) throw Refusal{"A message must be one JSON object."};
  return json;
}

bool is_name(const std::string& text) {
  return !text.empty() && text.size() <= kLongestName && std::none_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
  });
}

/// The members of one message, which must all be asked for.
class Members {
 public:
  explicit Members(const Json& json) : json_(json) { type_ = name("type"); }

  const std::string& type() const noexcept { return type_; }

  std::string name(const char* member) {
    const Json& value = at(member);
    if (!value.is_string() || !is_name(value.get_ref<const std::string&>())) {
      throw Refusal{fmt::format("{}'{}' must be a name, up to {} bytes of text without control characters.", of_type(),
                                member, kLongestName)};
    }
    return value.get<std::string>();
  }

  double number(const char* member, double least, double most) { return number(at(member), member, least, most); }

  std::optional<double> number_or_null(const char* member) {
    if (at(member).is_null()) return std::nullopt;
    constexpr double kAny = 1e300;  // a setting's own range is checked where it is known
    return number(member, -kAny, kAny);
  }

  bool flag(const char* member) {
    const Json& value = at(member);
    if (!value.is_boolean()) throw Refusal{fmt::format("{}'{}' must be true or false.", of_type(), member)};
    return value.get<bool>();
  }

  Pose pose(const char* member) {
    const Json& value = at(member);
    if (!value.is_array() || value.size() != 7) {
      throw Refusal{fmt::format("{}'{}' must be seven numbers: x, y, z, qw, qx, qy, qz.", of_type(), member)};
    }
    std::array<double, 7> v{};
    for (std::size_t i = 0; i < 7; ++i) {
      v[i] = number(value[i], member, i < 3 ? -kFarthest : -kMostNorm, i < 3 ? kFarthest : kMostNorm);
    }
    const Quaternion q(v[3], v[4], v[5], v[6]);
    if (!(q.norm() >= kLeastNorm && q.norm() <= kMostNorm)) {
      throw Refusal{fmt::format("{}the quaternion of '{}' must be a unit one, and has norm {:.3g}.", of_type(), member,
                                q.norm())};
    }
    return {{v[0], v[1], v[2]}, q.normalized()};
  }

  void refuse_others() const {
    for (const auto& item : json_.items()) {
      if (std::find(asked_.begin(), asked_.end(), item.key()) != asked_.end()) continue;
      throw Refusal{fmt::format("{}it has no member '{}'.", of_type(), is_name(item.key()) ? item.key() : "?")};
    }
  }

 private:
  std::string of_type() const { return type_.empty() ? std::string() : fmt::format("In a message '{}', ", type_); }

  const Json& at(const char* member) {
    const auto found = json_.find(member);
    if (found == json_.end()) throw Refusal{fmt::format("{}'{}' is missing.", of_type(), member)};
    asked_.emplace_back(member);
    return *found;
  }

  double number(const Json& value, const char* member, double least, double most) const {
    const double number = value.is_number() ? value.get<double>() : std::nan("");
    if (number >= least && number <= most) return number;
    throw Refusal{fmt::format("{}'{}' must be a number from {:g} to {:g}.", of_type(), member, least, most)};
  }

  const Json& json_;
  std::vector<std::string> asked_;
  std::string type_;
};

using Reader = ViewerCommand (*)(Members&);

template <class Command>
ViewerCommand bare(Members&) {
  return Command{};
}
template <class Command>
ViewerCommand named(Members& members) {
  return Command{members.name("name")};
}

constexpr std::pair<std::string_view, Reader> kReaders[] = {
    {"hand", [](Members& m) -> ViewerCommand { return viewer_command::Hand{m.pose("pose")}; }},
    {"release", bare<viewer_command::Release>},
    {"set",
     [](Members& m) -> ViewerCommand {
       std::string name = m.name("name");
       return viewer_command::Set{std::move(name), m.number_or_null("value")};
     }},
    {"method", named<viewer_command::Method>},
    {"pause", bare<viewer_command::Pause>},
    {"resume", bare<viewer_command::Resume>},
    {"step", bare<viewer_command::Step>},
    {"reset", bare<viewer_command::Reset>},
    {"motion", named<viewer_command::Motion>},
    {"stop", bare<viewer_command::Stop>},
    {"scene", named<viewer_command::SceneChoice>},
    {"experiment", named<viewer_command::ExperimentChoice>},
    {"record", [](Members& m) -> ViewerCommand { return viewer_command::Record{m.flag("on")}; }},
    {"seek", [](Members& m) -> ViewerCommand { return viewer_command::Seek{m.number("t", -kLatest, kLatest)}; }},
    {"play", [](Members& m) -> ViewerCommand { return viewer_command::Play{m.number("speed", kSlowest, kFastest)}; }},
};

ViewerCommand read(std::string_view message) {
  const Json json = object_of(message);
  Members members(json);
  for (const auto& [type, reader] : kReaders) {
    if (type != members.type()) continue;
    ViewerCommand command = reader(members);
    members.refuse_others();
    return command;
  }
  throw Refusal{fmt::format("There is no message of type '{}'.", members.type())};
}

}  // namespace

ParsedCommand parse_viewer_command(std::string_view message) {
  try {
    return {read(message), {}};
  } catch (const Refusal& refusal) {
    return {std::nullopt, refusal.sentence};
  }
}

}  // namespace tegotae
