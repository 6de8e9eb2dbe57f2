// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/plain.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace tegotae {

/// Puts a JSON text together, value by value, with the commas between them. What is opened must be closed, and a key
/// stands before each value of an object: nothing checks it.
class JsonText {
 public:
  JsonText& open_object() { return open('{'); }
  JsonText& open_array() { return open('['); }
  JsonText& close_object() { return close('}'); }
  JsonText& close_array() { return close(']'); }

  /// `name` as it is: for names that need no escape.
  JsonText& key(std::string_view name);

  /// In the shortest form that reads back to the same double. JSON has no number that is not finite: null.
  JsonText& number(double value);
  /// To 7 significant digits, a micrometre in ten metres, finer than any screen; below 1e-12 in magnitude, where there
  /// is only rounding, 0. Not finite: null.
  JsonText& rounded(double value);
  JsonText& count(std::uint64_t value);
  JsonText& flag(bool value);
  JsonText& null();
  /// With escapes; what is no UTF-8 is replaced.
  JsonText& text(std::string_view value);

  // Arrays, each number rounded.

  JsonText& vector(const PlainVector3& v);
  /// [x, y, z, qw, qx, qy, qz]
  JsonText& pose(const PlainPose& X);
  /// [fx, fy, fz, tx, ty, tz]
  JsonText& wrench(const PlainWrench& F);
  /// The numbers of a vector in an array that is open.
  JsonText& components(const PlainVector3& v) { return rounded(v.x).rounded(v.y).rounded(v.z); }

  void reserve(std::size_t bytes) { text_.reserve(bytes); }
  std::string take() { return std::move(text_); }

 private:
  JsonText& open(char bracket);
  JsonText& close(char bracket);
  void separate();

  std::string text_;
};

}  // namespace tegotae
