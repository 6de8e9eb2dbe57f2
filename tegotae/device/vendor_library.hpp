// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tegotae {

/// Where a maker's library may be, and how to speak of it.
struct VendorLibraryNames {
  std::string driver;              ///< its name on the command line; begins every sentence
  std::string product;             ///< what has to be installed, as "the Force Dimension SDK"
  std::vector<std::string> files;  ///< in order of preference, as the dynamic loader takes them
  std::string folder_variable;     ///< environment variable with a folder to look into first; empty: there is none
  std::string mend;                ///< a sentence: what to do where no file was found
};

/// A maker's library, loaded at run time. It is loaded with all that it needs, its symbols visible to nobody else, and
/// stays loaded until the process ends: such libraries have threads that do not survive being unloaded.
class VendorLibrary {
 public:
  /// Tries the files in order, each in the folder (where the variable is set) and then by the loader's own search. Does
  /// not throw where none can be loaded: then `is_loaded` is false.
  explicit VendorLibrary(VendorLibraryNames names);

  bool is_loaded() const noexcept { return handle_ != nullptr; }
  /// File that was loaded, as the loader found it; empty: none.
  const std::string& file() const noexcept { return file_; }
  /// What was asked of the loader, in order, the loaded one last.
  const std::vector<std::string>& tried() const noexcept { return tried_; }
  /// Why each of those tried could not be loaded, in the loader's words.
  const std::vector<std::string>& complaints() const noexcept { return complaints_; }
  /// A sentence with its mend: why no file could be loaded; empty where one is.
  std::string trouble() const;
  /// Throws InterfaceError, with `trouble`, where no file is loaded.
  void require_loaded() const;

  /// The function of C linkage `symbol`, whose type is the caller's word. Throws InterfaceError where no file is loaded
  /// or the one loaded lacks it.
  template <class Function>
  Function* function(const char* symbol) const {
    return reinterpret_cast<Function*>(required(symbol));
  }
  /// The same, null where there is none: for what only some versions have.
  template <class Function>
  Function* optional_function(const char* symbol) const noexcept {
    return reinterpret_cast<Function*>(found(symbol));
  }
  /// Either, into a pointer of the function's type.
  template <class Function>
  void require(const char* symbol, Function*& into) const {
    into = function<Function>(symbol);
  }
  template <class Function>
  void look_for(const char* symbol, Function*& into) const noexcept {
    into = optional_function<Function>(symbol);
  }

 private:
  void try_file(const std::string& file);
  void* found(const char* symbol) const noexcept;
  void* required(const char* symbol) const;

  VendorLibraryNames names_;
  void* handle_ = nullptr;
  std::string file_, broken_;  // broken_: complaint about a file that is there, and cannot be loaded
  std::vector<std::string> tried_, complaints_;
};

}  // namespace tegotae
