// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/works.hpp>

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tegotae {
namespace {

class Performance {
 public:
  Performance(std::span<const Work> works, const std::atomic<bool>* stop, const Progress& progress)
      : works_(works), stop_(stop), progress_(progress), parts_(works.size(), 0.0) {
    for (const Work& work : works) total_ += work.weight;
  }

  void perform_until_none_is_left() {
    for (size_t i = next_++; i < works_.size() && !is_stopped(); i = next_++) perform(i);
  }

 private:
  bool is_stopped() const { return stop_ != nullptr && *stop_; }

  void perform(size_t i) {
    const Work& work = works_[i];
    try {
      work.perform([this, i](double part) {
        if (is_stopped()) throw WorkStopped();
        tell(i, part);
      });
    } catch (const WorkStopped&) {
      return;
    } catch (const std::exception& error) {
      if (work.failed) work.failed(error.what());
    }
    tell(i, 1.0);
  }

  void tell(size_t i, double part) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const double before = parts_[i];
    parts_[i] = std::clamp(part, before, 1.0);
    done_ += works_[i].weight * (parts_[i] - before);
    progress_(std::min(done_ / total_, 1.0));
  }

  std::span<const Work> works_;
  const std::atomic<bool>* stop_;
  const Progress& progress_;
  std::atomic<size_t> next_{0};
  std::mutex mutex_;  // guards what follows
  std::vector<double> parts_;
  double done_ = 0.0, total_ = 0.0;
};

}  // namespace

void perform_works(std::span<const Work> works, unsigned threads, const std::atomic<bool>* stop,
                   const Progress& progress) {
  Performance performance(works, stop, progress);
  std::vector<std::thread> workers;
  const size_t count = std::clamp<size_t>(threads, 1, std::max<size_t>(works.size(), 1));
  for (size_t i = 0; i < count; ++i) {
    workers.emplace_back([&performance] { performance.perform_until_none_is_left(); });
  }
  for (std::thread& worker : workers) worker.join();
}

}  // namespace tegotae
