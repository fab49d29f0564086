#include "core/jobs.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <list>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace velarium {
namespace {

// One call of parallel_for. Threads take indices until none is left.
class Job {
 public:
  Job(std::size_t count, const std::function<void(std::size_t)>& body) : count_(count), body_(body) {}

  [[nodiscard]] bool open() const { return next_.load(std::memory_order_relaxed) < count_; }

  void work() noexcept {
    for (std::size_t i; (i = next_.fetch_add(1, std::memory_order_relaxed)) < count_;) {
      try {
        body_(i);
      } catch (...) {
        const std::lock_guard lock(error_mutex_);
        if (!error_) error_ = std::current_exception();
        next_.store(count_, std::memory_order_relaxed);
      }
    }
  }

  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

  int helpers = 0;  // guarded by the pool's mutex

 private:
  const std::size_t count_;
  const std::function<void(std::size_t)>& body_;
  std::atomic<std::size_t> next_{0};
  std::mutex error_mutex_;
  std::exception_ptr error_;
};

// Threads that help with any open job. The caller always works on its own job and waits only for helpers that are
// inside a body of it, so nested calls cannot wait for each other.
class Pool {
 public:
  Pool() {
    const unsigned helpers = std::max(1u, std::thread::hardware_concurrency()) - 1;
    try {
      for (unsigned i = 0; i < helpers; ++i) threads_.emplace_back([this] { help(); });
    } catch (const std::system_error&) {
      // The system gives no more threads: those that there are do the work.
    }
  }

  ~Pool() {
    {
      const std::lock_guard lock(mutex_);
      stopping_ = true;
    }
    job_opened_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  void run(Job& job) {
    std::unique_lock lock(mutex_);
    const auto place = jobs_.insert(jobs_.end(), &job);
    lock.unlock();
    job_opened_.notify_all();
    job.work();
    lock.lock();
    jobs_.erase(place);
    helper_left_.wait(lock, [&] { return job.helpers == 0; });
  }

 private:
  void help() {
    std::unique_lock lock(mutex_);
    while (true) {
      Job* job = nullptr;
      job_opened_.wait(lock, [&] { return stopping_ || (job = newest_open_job()) != nullptr; });
      if (stopping_) return;
      ++job->helpers;
      lock.unlock();
      job->work();
      lock.lock();
      if (--job->helpers == 0) helper_left_.notify_all();
    }
  }

  // The newest, because an older one may be waiting for it to end.
  [[nodiscard]] Job* newest_open_job() const {
    const auto found = std::find_if(jobs_.rbegin(), jobs_.rend(), [](const Job* job) { return job->open(); });
    return found == jobs_.rend() ? nullptr : *found;
  }

  std::mutex mutex_;
  std::condition_variable job_opened_, helper_left_;
  std::list<Job*> jobs_;
  bool stopping_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
  if (count == 1) return body(0);
  if (count == 0) return;
  static Pool pool;
  Job job(count, body);
  pool.run(job);
  job.rethrow();
}

}  // namespace velarium
