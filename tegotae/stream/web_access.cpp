// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/web_access.hpp>

#include <tegotae/stream/viewer_options.hpp>

#include <arpa/inet.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <utility>

namespace tegotae {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool stands_in_name(char c) { return is_letter(c) || is_digit(c) || c == '-' || c == '.' || c == '_'; }
bool stands_in_brackets(char c) { return is_letter(c) || is_digit(c) || c == ':' || c == '.'; }
bool stands_in_token(char c) { return stands_in_name(c) || c == '~'; }

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return lower;
}

bool is_port(std::string_view text) { return text.size() <= 5 && std::all_of(text.begin(), text.end(), is_digit); }

// Whether a host without port is an address in figures.
bool in_figures(const std::string& host) {
  std::array<unsigned char, sizeof(in6_addr)> address{};
  if (!host.empty() && host.front() == '[') {
    return inet_pton(AF_INET6, host.substr(1, host.size() - 2).c_str(), address.data()) == 1;
  }
  return inet_pton(AF_INET, host.c_str(), address.data()) == 1;
}

std::string machine_name() {
  std::array<char, 256> name{};
  if (gethostname(name.data(), name.size() - 1) != 0) return {};
  return lower_case(name.data());
}

bool equal_in_constant_time(std::string_view a, std::string_view b) {
  unsigned difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b.empty() ? '\0' : b[i % b.size()]);
  }
  return difference == 0;
}

// Value of the first parameter `token` of the target's query.
std::string_view token_in(std::string_view target) {
  constexpr std::string_view kName = "token=";
  const std::size_t question = target.find('?');
  std::string_view query = question == std::string_view::npos ? std::string_view() : target.substr(question + 1);
  while (!query.empty()) {
    const std::size_t length = std::min(query.find('&'), query.size());
    if (query.substr(0, std::min(kName.size(), length)) == kName) return query.substr(0, length).substr(kName.size());
    query.remove_prefix(std::min(length + 1, query.size()));
  }
  return {};
}

}  // namespace

std::string host_of(std::string_view host_header) {
  const bool brackets = !host_header.empty() && host_header.front() == '[';
  std::size_t end = host_header.find(brackets ? ']' : ':');
  if (brackets) {
    if (end == std::string_view::npos) return {};
    ++end;
  }
  const std::string_view host = host_header.substr(0, std::min(end, host_header.size()));
  const std::string_view rest = host_header.substr(host.size());
  if (!rest.empty() && (rest.front() != ':' || !is_port(rest.substr(1)))) return {};
  const std::string_view inside = brackets ? host.substr(1, host.size() - 2) : host;
  if (!std::all_of(inside.begin(), inside.end(), brackets ? stands_in_brackets : stands_in_name)) return {};
  return inside.empty() ? std::string() : lower_case(host);
}

WebAccess::WebAccess(std::string_view host, std::string token)
    : host_(lower_case(host)), machine_(machine_name()), token_(std::move(token)) {
  if (host_.find(':') != std::string::npos && host_.front() != '[') host_ = "[" + host_ + "]";
  wildcard_ = host_ == "0.0.0.0" || host_ == "[::]";
  if (!std::all_of(token_.begin(), token_.end(), stands_in_token)) {
    throw WebServerError("A token holds letters, digits and - . _ ~ alone, so that it can stand in an address.");
  }
}

bool WebAccess::serves(std::string_view host_header) const {
  const std::string host = host_of(host_header);
  if (host.empty()) return false;
  if (host == "localhost" || host == "127.0.0.1" || host == "[::1]" || host == host_) return true;
  return wildcard_ && (in_figures(host) || host == machine_ || host == machine_ + ".local");
}

bool WebAccess::same_origin(std::string_view origin, std::string_view host_header) {
  for (const std::string_view scheme : {std::string_view("http://"), std::string_view("https://")}) {
    if (origin.substr(0, scheme.size()) == scheme) {
      return lower_case(origin.substr(scheme.size())) == lower_case(host_header);
    }
  }
  return false;
}

bool WebAccess::shows_token(std::string_view target) const {
  return !asks_token() || equal_in_constant_time(token_in(target), token_);
}

std::string WebAccess::address(std::uint16_t port) const {
  const std::string& host = wildcard_ && !machine_.empty() ? machine_ : host_;
  return "http://" + host + ":" + std::to_string(port) + "/" + (asks_token() ? "?token=" + token_ : "");
}

}  // namespace tegotae
