// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/web_answer.hpp>

#include <algorithm>

namespace tegotae {
namespace {

constexpr std::string_view kAskToken =
    "This page asks for a token: open the whole address that the program has printed, with ?token= at its end.\n";

// Only the page's own scripts run and only this server is spoken to. Not all browsers take a WebSocket for 'self', so
// it is named too; `host` is the Host header, known to be one of the server's.
std::string content_policy(std::string_view host) {
  return "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
         "connect-src 'self' ws://" +
         std::string(host) + "; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
}

void add_common_headers(WebAnswer& answer) {
  for (const auto& [name, value] : {std::pair<std::string_view, std::string_view>{"Cache-Control", "no-store"},
                                    {"X-Content-Type-Options", "nosniff"},
                                    {"Referrer-Policy", "no-referrer"},
                                    {"Cross-Origin-Resource-Policy", "same-origin"}}) {
    answer.headers.emplace_back(name, value);
  }
}

WebAnswer answer_to_live(const WebQuestion& question, const WebAccess& access) {
  if (!question.is_upgrade) {
    WebAnswer answer = refusal(426, "At this address there is a WebSocket.\n");
    answer.headers.emplace_back("Upgrade", "websocket");
    return answer;
  }
  if (question.has_origin && !WebAccess::same_origin(question.origin, question.host)) {
    return refusal(403, "Only pages of this server may open its WebSocket.\n");
  }
  if (!access.shows_token(question.target)) return refusal(401, kAskToken);
  if (!question.has_origin && !question.from_loopback && !access.asks_token()) {
    return refusal(403, "From another machine, the WebSocket is open to pages of this server alone.\n");
  }
  WebAnswer granted;
  granted.status = 101;
  return granted;
}

}  // namespace

WebAnswer refusal(unsigned status, std::string_view sentence) {
  WebAnswer answer;
  answer.status = status;
  answer.bytes = sentence;
  add_common_headers(answer);
  // RFC 9110, 11.6.1; a scheme that browsers do not know, so that they show the sentence instead of asking.
  if (status == 401) answer.headers.emplace_back("WWW-Authenticate", "Token");
  return answer;
}

WebAnswer answer_of(const WebQuestion& question, const WebAccess& access, const std::vector<WebAsset>& assets) {
  if (!access.serves(question.host)) {
    return refusal(403, "This server goes by another name: open the address that the program has printed.\n");
  }
  const std::string_view path = question.target.substr(0, question.target.find('?'));
  if (path == kLivePath) return answer_to_live(question, access);
  const auto asset = std::find_if(assets.begin(), assets.end(), [path](const WebAsset& a) { return a.path == path; });
  if (asset == assets.end()) return refusal(404, "There is nothing at this address.\n");
  if (question.method != "GET" && question.method != "HEAD") {
    WebAnswer answer = refusal(405, "Here one can only read.\n");
    answer.headers.emplace_back("Allow", "GET, HEAD");
    return answer;
  }
  const bool is_page = asset->content_type.substr(0, 9) == "text/html";
  if (is_page && !access.shows_token(question.target)) return refusal(401, kAskToken);
  WebAnswer answer;
  answer.content_type = asset->content_type;
  answer.bytes = asset->bytes;
  add_common_headers(answer);
  answer.headers.emplace_back("Content-Security-Policy", content_policy(question.host));
  return answer;
}

}  // namespace tegotae
