// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/vendor_library.hpp>

#include <tegotae/device/interface_driver.hpp>

#include <dlfcn.h>
#include <link.h>

#include <cstdlib>
#include <string_view>
#include <utility>

namespace tegotae {
namespace {

// Of a file that is not there glibc says its name and these words; where a library that it needs is missing, the name
// is that one's.
bool says_absent(const std::string& complaint, const std::string& file) {
  return complaint == file + ": cannot open shared object file: No such file or directory";
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

VendorLibrary::VendorLibrary(VendorLibraryNames names) : names_(std::move(names)) {
  const char* folder = names_.folder_variable.empty() ? nullptr : std::getenv(names_.folder_variable.c_str());
  if (folder != nullptr && *folder != '\0') {
    for (const std::string& file : names_.files) try_file(std::string(folder) + '/' + file);
  }
  for (const std::string& file : names_.files) try_file(file);
}

void VendorLibrary::try_file(const std::string& file) {
  if (handle_ != nullptr) return;
  tried_.push_back(file);
  handle_ = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle_ == nullptr) {
    const char* complaint = dlerror();
    complaints_.emplace_back(complaint != nullptr ? complaint : file + ": the dynamic loader does not say why");
    if (broken_.empty() && !says_absent(complaints_.back(), file)) broken_ = file + " (" + complaints_.back() + ")";
    return;
  }
  file_ = file;
  link_map* map = nullptr;
  if (dlinfo(handle_, RTLD_DI_LINKMAP, &map) == 0 && map->l_name != nullptr && *map->l_name != '\0') {
    file_ = map->l_name;
  }
}

std::string VendorLibrary::trouble() const {
  if (is_loaded()) return {};
  if (!broken_.empty()) {
    return names_.driver + ": a file of " + names_.product + " is there but cannot be loaded: " + broken_ +
           "; install what it needs, for this machine's processor.";
  }
  return names_.driver + ": " + names_.product + " was not found (looked for " + listed(tried_) + "). " + names_.mend;
}

void VendorLibrary::require_loaded() const {
  if (!is_loaded()) throw InterfaceError(trouble());
}

void* VendorLibrary::found(const char* symbol) const noexcept {
  return handle_ == nullptr ? nullptr : dlsym(handle_, symbol);
}

void* VendorLibrary::required(const char* symbol) const {
  require_loaded();
  void* address = found(symbol);
  if (address == nullptr) {
    throw InterfaceError(names_.driver + ": " + file_ + " has no function '" + symbol +
                         "', so it is not the version that is known here; install a newer version of " +
                         names_.product + ", or remove the old one from where the dynamic loader looks.");
  }
  return address;
}

}  // namespace tegotae
