// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/short_messages.hpp>

#include <tegotae/stream/json_text.hpp>

namespace tegotae {
namespace {

const char* name_of(NoticeLevel level) noexcept {
  switch (level) {
    case NoticeLevel::kInfo:
      return "info";
    case NoticeLevel::kWarning:
      return "warning";
    case NoticeLevel::kError:
      return "error";
  }
  return "error";
}

}  // namespace

std::string encode_welcome(std::uint64_t viewer) {
  return JsonText().open_object().key("type").text("welcome").key("viewer").count(viewer).close_object().take();
}

std::string encode_notice(NoticeLevel level, std::string_view text) {
  JsonText json;
  json.open_object().key("type").text("notice").key("level").text(name_of(level)).key("text").text(text);
  return json.close_object().take();
}

std::string encode_end(std::string_view text) {
  return JsonText().open_object().key("type").text("end").key("text").text(text).close_object().take();
}

}  // namespace tegotae
