// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace tegotae::test {

struct HttpReply {
  unsigned status = 0;                         ///< 0: the connection was closed without a reply
  std::map<std::string, std::string> headers;  ///< names in lower case
  std::string body;
};

/// A TCP connection to a port of this machine. What does not happen within a minute throws std::runtime_error: the
/// test hangs.
class RawClient {
 public:
  explicit RawClient(std::uint16_t port);
  ~RawClient();
  RawClient(RawClient&&) noexcept;

  bool write(std::string_view bytes);  ///< false: the other end has closed
  void end_writing();                  ///< nothing more comes, says TCP; reading goes on
  void reset();                        ///< breaks the connection off
  std::string read_all();              ///< until the other end closes

  /// One request with the headers given, and what is answered.
  HttpReply request(const std::string& method, const std::string& target,
                    const std::map<std::string, std::string>& headers = {{"Host", "localhost"}});

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

struct WebSocketRequest {
  std::string target = "/live";
  std::map<std::string, std::string> headers = {{"Host", "localhost"}};
  int receive_buffer = 0;  ///< bytes that the system takes for one who does not read; 0: as it likes
};

/// A WebSocket to a port of this machine; times as above.
class WebSocketClient {
 public:
  explicit WebSocketClient(std::uint16_t port, const WebSocketRequest& request = {});
  ~WebSocketClient();
  WebSocketClient(WebSocketClient&&) noexcept;

  unsigned status() const noexcept;             ///< 101: it is open
  const std::string& refusal() const noexcept;  ///< body of the reply where it is not
  bool send(std::string_view text);
  bool send_binary(std::string_view bytes);
  bool ping();
  /// Beside all rules of WebSockets.
  bool write_raw(std::string_view bytes);
  std::optional<std::string> read();  ///< none: the connection has ended
  /// Reads to the end of the connection; the code with which it was closed, 0 where it was without.
  unsigned read_close();
  const std::string& close_reason() const noexcept;
  void close();  ///< as is proper
  void reset();  ///< breaks the connection off

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace tegotae::test
