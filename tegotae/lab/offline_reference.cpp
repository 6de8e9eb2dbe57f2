// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/offline_reference.hpp>

namespace tegotae {

Reference offline_reference(double /*hand_step*/) {
  return [](const ReferenceTask& task, const Progress& /*progress*/) {
    return std::vector<ReferenceSample>(task.X_WT.size(), ReferenceSample{.wrench = {}, .defined = false});
  };
}

}  // namespace tegotae
