// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/json_text.hpp>

#include <tegotae/runtime/csv_writer.hpp>

#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>

namespace tegotae {

// Only a bracket or a colon that is not part of a text can be last: texts end with their quote.
void JsonText::separate() {
  if (text_.empty()) return;
  const char last = text_.back();
  if (last != '{' && last != '[' && last != ':') text_ += ',';
}

JsonText& JsonText::open(char bracket) {
  separate();
  text_ += bracket;
  return *this;
}

JsonText& JsonText::close(char bracket) {
  text_ += bracket;
  return *this;
}

JsonText& JsonText::key(std::string_view name) {
  separate();
  text_ += '"';
  text_ += name;
  text_ += "\":";
  return *this;
}

JsonText& JsonText::number(double value) {
  if (!std::isfinite(value)) return null();
  separate();
  append_number(text_, value + 0.0);  // adding zero turns a negative zero into zero
  return *this;
}

JsonText& JsonText::rounded(double value) {
  if (!std::isfinite(value)) return null();
  separate();
  constexpr int kDigits = 7;
  constexpr double kLeast = 1e-12;
  char digits[32];
  const std::to_chars_result end = std::to_chars(digits, digits + sizeof digits, std::abs(value) < kLeast ? 0.0 : value,
                                                 std::chars_format::general, kDigits);
  text_.append(digits, end.ptr);
  return *this;
}

JsonText& JsonText::count(std::uint64_t value) {
  separate();
  text_ += std::to_string(value);
  return *this;
}

JsonText& JsonText::flag(bool value) {
  separate();
  text_ += value ? "true" : "false";
  return *this;
}

JsonText& JsonText::null() {
  separate();
  text_ += "null";
  return *this;
}

JsonText& JsonText::text(std::string_view value) {
  separate();
  text_ += nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return *this;
}

JsonText& JsonText::vector(const PlainVector3& v) { return open_array().components(v).close_array(); }

JsonText& JsonText::pose(const PlainPose& X) {
  return open_array().components(X.p).rounded(X.w).rounded(X.x).rounded(X.y).rounded(X.z).close_array();
}

JsonText& JsonText::wrench(const PlainWrench& F) {
  return open_array().components(F.force).components(F.torque).close_array();
}

}  // namespace tegotae
