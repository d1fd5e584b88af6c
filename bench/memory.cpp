#include "memory.hpp"

#include "experiment/training.hpp"
#include "work.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <vector>

namespace twiddle::bench
{

namespace
{

double resident_mb()
{
    std::ifstream file("/proc/self/statm");
    double pages = 0;
    file >> pages >> pages; // all, resident
    return pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

// Never returns: the child must not go on with what its parent was doing.
[[noreturn]] void answer(int pipe, const std::function<double()> &measure)
{
    try {
        const double mb = measure();
        _exit(write(pipe, &mb, sizeof mb) == sizeof mb ? 0 : 1);
    } catch (const std::exception &error) {
        std::cerr << "bench_growth: " << error.what() << '\n';
        _exit(1);
    }
}

double in_child(const std::function<double()> &measure)
{
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) throw std::runtime_error("a process for a measurement of memory has no pipe");
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("a process for a measurement of memory could not be started");
    if (child == 0) answer(ends[1], measure);
    close(ends[1]);
    double mb = 0;
    const bool answered = read(ends[0], &mb, sizeof mb) == sizeof mb;
    close(ends[0]);
    waitpid(child, nullptr, 0);
    if (!answered) throw std::runtime_error("a process for a measurement of memory failed");
    return mb;
}

} // namespace

double training_peak_mb(sim::Stepper stepper, const std::string &object, std::uint32_t trials)
{
    return in_child([&] {
        experiment::Training run(training_run(stepper, object, trials), models_dir);
        for (std::uint32_t trial = 0; trial < trials; ++trial)
            run.run_trial();
        return peak_resident_mb();
    });
}

double further_worker_mb(sim::Stepper stepper, const std::string &object)
{
    constexpr int further = 16;
    return in_child([&] {
        const auto set = random_parameters("cpg-c", 1, 1).front();
        std::vector<experiment::TrialRunner> runners;
        runners.reserve(1 + further);
        double before_mb = 0;
        for (int worker = 0; worker <= further; ++worker) {
            runners.push_back(make_runner(stepper, object, load_setup(speed_setup)));
            runners.back().run(set);
            if (worker == 0) before_mb = resident_mb();
        }
        return (resident_mb() - before_mb) / further;
    });
}

} // namespace twiddle::bench
