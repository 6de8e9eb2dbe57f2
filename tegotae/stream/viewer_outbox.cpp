// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/viewer_outbox.hpp>

#include <algorithm>
#include <utility>

namespace tegotae {

void ViewerOutbox::drop_state() {
  const auto state = std::find_if(items_.begin(), items_.end(), [](const Item& item) { return item.is_state; });
  if (state != items_.end()) items_.erase(state);
}

void ViewerOutbox::publish(SharedText state) {
  if (closing()) return;
  drop_state();
  items_.push_back({std::move(state), true});
}

bool ViewerOutbox::send(SharedText message) {
  if (closing()) return true;
  if (messages_ >= max_messages_ || bytes_ >= max_bytes_) return false;
  ++messages_;
  bytes_ += message->size();
  items_.push_back({std::move(message), false});
  return true;
}

void ViewerOutbox::close(CloseOrder order) {
  if (closing()) return;
  items_.clear();
  messages_ = bytes_ = 0;
  close_ = std::move(order);
}

void ViewerOutbox::finish(SharedText last, CloseOrder order) {
  if (closing()) return;
  drop_state();
  if (last) {
    ++messages_;
    bytes_ += last->size();
    items_.push_back({std::move(last), false});
  }
  close_ = std::move(order);
}

ViewerOutbox::Next ViewerOutbox::next() {
  if (items_.empty()) return close_ ? Next(*close_) : Next();
  Item item = std::move(items_.front());
  items_.pop_front();
  if (!item.is_state) {
    --messages_;
    bytes_ -= item.text->size();
  }
  return std::move(item.text);
}

}  // namespace tegotae
