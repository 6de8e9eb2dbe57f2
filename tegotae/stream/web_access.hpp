// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tegotae {

/// Who is let in to a server: by the name that it is asked for by, the page that asks, and the token.
class WebAccess {
 public:
  /// `host` as the server was told to serve it: a name, an address, or a wildcard (0.0.0.0, ::). Throws WebServerError
  /// where the token holds what cannot stand in an address as it is.
  WebAccess(std::string_view host, std::string token);

  /// Whether the Host header is one of this server's: localhost, 127.0.0.1, [::1] or its host; of a wildcard, any
  /// address in figures (a name of someone else's that resolves to this machine is what must be refused) and the
  /// machine's name. Ports are not compared: a tunnel changes them.
  bool serves(std::string_view host_header) const;

  /// Whether the Origin header is that of a page of the host asked for.
  static bool same_origin(std::string_view origin, std::string_view host_header);

  /// Whether the request's target shows the token (or none is asked for), found in a time that does not tell how much
  /// of it is right.
  bool shows_token(std::string_view target) const;
  bool asks_token() const noexcept { return !token_.empty(); }

  /// "http://127.0.0.1:8700/", with the token.
  std::string address(std::uint16_t port) const;

 private:
  std::string host_;  ///< as it stands in an address: in brackets where it is IPv6's
  bool wildcard_;
  std::string machine_;  ///< this machine's name
  std::string token_;
};

/// Host and port of a Host header without the port, lower case: "localhost", "[::1]"; empty where it is none.
std::string host_of(std::string_view host_header);

}  // namespace tegotae
