// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/doctor_system.hpp>
#include <tests/lab/temporary_folder.hpp>

#include <memory>
#include <string>

namespace tegotae {

/// The files in which a machine tells of itself, in a folder.
class MadeUpMachine {
 public:
  void write(const std::string& path, const std::string& text) const {
    std::filesystem::create_directories((folder_->path() / path).parent_path());
    folder_->write(path, text);
  }
  SystemRoots roots() const { return {folder_->path() / "proc", folder_->path() / "sys", folder_->path() / "dev"}; }

 private:
  std::shared_ptr<TemporaryFolder> folder_ = std::make_shared<TemporaryFolder>();
};

}  // namespace tegotae
