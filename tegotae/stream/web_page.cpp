// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/web_page.hpp>

#include <array>

// Labels of cmake/web_page.S.in: first byte of a file, and the byte after its last.
extern "C" {
extern const char tegotae_page_index_html[], tegotae_page_index_html_end[];
extern const char tegotae_page_app_js[], tegotae_page_app_js_end[];
extern const char tegotae_page_app_css[], tegotae_page_app_css_end[];
extern const char tegotae_page_licenses_txt[], tegotae_page_licenses_txt_end[];
}

namespace tegotae {
namespace {

std::string_view between(const char* first, const char* end) noexcept {
  return {first, static_cast<std::size_t>(end - first)};
}

}  // namespace

std::span<const WebAsset> web_page() noexcept {
  static const std::array<WebAsset, 4> page = {{
      {"/", "text/html; charset=utf-8", between(tegotae_page_index_html, tegotae_page_index_html_end)},
      {"/app.js", "text/javascript; charset=utf-8", between(tegotae_page_app_js, tegotae_page_app_js_end)},
      {"/app.css", "text/css; charset=utf-8", between(tegotae_page_app_css, tegotae_page_app_css_end)},
      {"/licenses.txt", "text/plain; charset=utf-8", between(tegotae_page_licenses_txt, tegotae_page_licenses_txt_end)},
  }};
  return page;
}

}  // namespace tegotae
