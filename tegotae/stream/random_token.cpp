// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/random_token.hpp>

#include <random>
#include <string_view>

namespace tegotae {

std::string random_token() {
  constexpr std::string_view kFigures = "0123456789abcdef";
  constexpr std::size_t kLength = 32;
  std::random_device source("/dev/urandom");
  std::string token;
  while (token.size() < kLength) {
    const unsigned number = source();
    for (unsigned shift = 0; shift < 32; shift += 4) token += kFigures[number >> shift & 0xf];
  }
  return token;
}

}  // namespace tegotae
