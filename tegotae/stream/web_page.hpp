// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/stream/web_asset.hpp>

#include <span>

namespace tegotae {

/// The page of the live view, built from viewer/ and carried inside the program: "/" (HTML), "/app.js", "/app.css" and
/// "/licenses.txt" (of the packages that the page contains). They refer to each other, and to nothing else.
std::span<const WebAsset> web_page() noexcept;

}  // namespace tegotae
