// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/stream/viewer_options.hpp>
#include <tegotae/stream/web_access.hpp>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tegotae {

/// What of an HTTP request decides on its answer. A header that is absent is empty; one that came twice is "?".
struct WebQuestion {
  std::string_view method, target, host, origin;
  bool has_origin = false;     ///< browsers send it with every WebSocket
  bool is_upgrade = false;     ///< asks for a WebSocket
  bool from_loopback = false;  ///< comes from this machine
};

struct WebAnswer {
  unsigned status = 200;  ///< 101: a WebSocket is granted
  std::string_view content_type = "text/plain; charset=utf-8";
  std::string_view bytes;                                         ///< of an asset or of a sentence in static memory
  std::vector<std::pair<std::string_view, std::string>> headers;  ///< beside Content-Type and -Length
};

/// Where viewers find the WebSocket.
inline constexpr std::string_view kLivePath = "/live";

/// What the server says to a request, whatever it holds.
WebAnswer answer_of(const WebQuestion& question, const WebAccess& access, const std::vector<WebAsset>& assets);

/// A refusal with a sentence (static memory) that a person can read.
WebAnswer refusal(unsigned status, std::string_view sentence);

}  // namespace tegotae
