// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/render_types.hpp>

namespace tegotae {

const char* name_of(RenderStatus status) noexcept {
  switch (status) {
    case RenderStatus::kOk:
      return "ok";
    case RenderStatus::kNoModel:
      return "no-model";
    case RenderStatus::kIterationLimit:
      return "iteration-limit";
    case RenderStatus::kInfeasible:
      return "infeasible";
    case RenderStatus::kInvalidInput:
      return "invalid-input";
  }
  return "unknown";
}

}  // namespace tegotae
