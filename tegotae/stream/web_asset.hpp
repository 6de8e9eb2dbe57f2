// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace tegotae {

/// One file that a web server gives out. It refers to bytes that outlive it, as those inside the program do.
struct WebAsset {
  std::string_view path;          ///< of the request: "/", "/app.js"
  std::string_view content_type;  ///< media type, with the character set where it is text
  std::string_view bytes;
};

}  // namespace tegotae
