#include "worker_pool.hpp"

#include "record/descriptor.hpp"
#include "runs/stop_request.hpp"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <deque>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace twiddle::sweeps
{

namespace
{

using record::Descriptor;

constexpr int tick_ms = 100;

static_assert(sizeof(TaskReport) <= PIPE_BUF, "a report must go through a pipe in one piece");

struct Worker {
    std::size_t task = 0;
    pid_t process = 0;
    Descriptor reports; // to read from; at its end, the worker has ended
    std::string sentence;
};

[[noreturn]] void fail(const std::string &what)
{
    throw std::runtime_error(what + ": " + std::strerror(errno));
}

TaskReport failure(const char *sentence)
{
    TaskReport report;
    std::strncpy(report.sentence.data(), sentence, report.sentence.size() - 1);
    return report;
}

// The worker's whole life. It ends without the starter's destructors and buffers.
[[noreturn]] void live(std::size_t task, const Work &work, int reports)
{
    std::signal(SIGPIPE, SIG_IGN);
    const Reporter report = [reports](const TaskReport &each) {
        return ::write(reports, &each, sizeof each) == static_cast<ssize_t>(sizeof each);
    };
    TaskEnd end = TaskEnd::failed;
    try {
        end = work(task, report);
    } catch (const std::exception &error) {
        report(failure(error.what()));
    }
    ::_exit(static_cast<int>(end));
}

class Pool
{
  public:
    Pool(const std::vector<std::size_t> &tasks, std::size_t jobs, const Work &work, const PoolListener &listener)
        : waiting_(tasks.begin(), tasks.end()), jobs_(jobs), work_(work), listener_(listener)
    {
    }

    void run()
    {
        while (!waiting_.empty() || !workers_.empty()) {
            if (runs::stop_signal() != 0) stop();
            while (!waiting_.empty() && workers_.size() < jobs_) {
                start(waiting_.front());
                waiting_.pop_front();
            }
            listen();
            listener_.tick();
        }
    }

  private:
    // The terminal signals all processes, but others signal the starter alone.
    void stop()
    {
        waiting_.clear();
        for (const Worker &worker : workers_) {
            ::kill(worker.process, runs::stop_signal());
        }
    }

    void start(std::size_t task)
    {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail("cannot make a pipe to a worker");
        Descriptor reading(ends[0]);
        Descriptor writing(ends[1]);
        std::cout << std::flush; // or the worker would have the same text to print
        std::cerr << std::flush;
        const pid_t process = ::fork();
        if (process < 0) fail("cannot start a worker");
        if (process == 0) {
            reading = Descriptor(); // nobody but the starter may hold a reading end
            workers_.clear();
            live(task, work_, writing.number());
        }
        workers_.push_back({task, process, std::move(reading), ""});
    }

    // Wait for reports, and take them.
    void listen()
    {
        std::vector<pollfd> sources;
        for (const Worker &worker : workers_) {
            sources.push_back({worker.reports.number(), POLLIN, 0});
        }
        if (::poll(sources.data(), sources.size(), tick_ms) <= 0) return; // nothing yet, or a signal
        for (std::size_t i = sources.size(); i-- > 0;) {
            if (sources[i].revents != 0 && !take_report(workers_[i])) bury(i);
        }
    }

    // False if the worker has ended.
    bool take_report(Worker &worker)
    {
        TaskReport report;
        const ssize_t size = ::read(worker.reports.number(), &report, sizeof report);
        if (size != static_cast<ssize_t>(sizeof report)) return size < 0 && errno == EINTR;
        report.sentence.back() = '\0';
        worker.sentence = report.sentence.data();
        if (worker.sentence.empty()) listener_.report(worker.task, report);
        return true;
    }

    void bury(std::size_t index)
    {
        const Worker worker = std::move(workers_[index]);
        workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(index));
        int status = 0;
        while (::waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {
        }
        const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        if (code == static_cast<int>(TaskEnd::complete) || code == static_cast<int>(TaskEnd::stopped)) {
            listener_.end(worker.task, static_cast<TaskEnd>(code), "");
        } else {
            listener_.end(worker.task, TaskEnd::failed, worker.sentence.empty() ? sudden_end(status) : worker.sentence);
        }
    }

    static std::string sudden_end(int status)
    {
        if (WIFSIGNALED(status))
            return std::string("its process was ended by the signal ") + ::strsignal(WTERMSIG(status));
        return "its process ended with status " + std::to_string(WEXITSTATUS(status));
    }

    std::deque<std::size_t> waiting_;
    std::size_t jobs_;
    const Work &work_;
    const PoolListener &listener_;
    std::vector<Worker> workers_;
};

} // namespace

void do_tasks(const std::vector<std::size_t> &tasks, std::size_t jobs, const Work &work, const PoolListener &listener)
{
    Pool(tasks, jobs, work, listener).run();
}

} // namespace twiddle::sweeps
