// worker_pool.hpp: tasks side by side, each in a process of its own.
//
// Processes, not threads: one that crashes takes no other along, and what Bullet keeps in globals belongs to one run. A
// worker whose starter is gone, however it ended, is told so by its next report.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace twiddle::sweeps
{

// What a worker says of its task.
struct TaskReport {
    std::uint32_t trials_done = 0;
    std::uint32_t trials_recalled = 0; // of them, made by an earlier start
    std::array<char, 500> sentence{};  // why the task failed; empty otherwise
    double result = 0;                 // of a task that comes to one number
};

// As a process's exit status; a library that ends its process does so with 1.
enum class TaskEnd { complete = 0, failed = 1, stopped = 2 };

// Sends a report to who started the worker; false if nobody is there any more.
using Reporter = std::function<bool(const TaskReport &report)>;

// Does a task, in the worker. What it throws is the sentence with which the task has failed.
using Work = std::function<TaskEnd(std::size_t task, const Reporter &report)>;

// What the starter learns of its workers, while it waits.
struct PoolListener {
    std::function<void(std::size_t task, const TaskReport &report)> report;
    std::function<void(std::size_t task, TaskEnd end, const std::string &sentence)> end;
    std::function<void()> tick; // about ten times a second
};

// Do all `tasks`, in their order, at most `jobs` at a time. After a stop signal (stop_request.hpp) no task is begun,
// and the workers get the signal too. Throws std::runtime_error if there can be no more processes.
void do_tasks(const std::vector<std::size_t> &tasks, std::size_t jobs, const Work &work, const PoolListener &listener);

} // namespace twiddle::sweeps
