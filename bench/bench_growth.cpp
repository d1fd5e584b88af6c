// How the cost of the full loop (controller, torques at every substep, world) grows with substeps, fingers in contact,
// objects and workers, and what memory a worker takes. Writes a CSV; its `#` lines say how to read it.
#include "memory.hpp"
#include "press.hpp"
#include "work.hpp"

#include "record/csv.hpp"
#include "record/number_text.hpp"
#include "record/part_file.hpp"
#include "record/versions.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace
{

using namespace twiddle;
using namespace twiddle::bench;
using engine::Parameters;
using experiment::TrialRunner;

constexpr int default_substeps = 5; // of the speed figures' set-up

struct Options {
    std::filesystem::path file;
    int sets = 50;
    int repeats = 5;
    double seconds = 0.4;
    std::uint32_t seed = 1;
    std::uint32_t memory_trials = 500;
};

// What a number belongs to. `fingers` is empty where it varies within the work.
struct Place {
    std::string series;
    sim::Stepper stepper = sim::Stepper::fast;
    std::string object;
    int substeps = default_substeps;
    std::string fingers = {};
    unsigned workers = 1;
};

// One piece of work: control steps a second of it, when asked, and what the repeats have found.
struct Timing {
    Place place;
    std::function<double()> measure_steps_per_s;
    std::vector<double> steps_per_s;
};

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

std::vector<settings::Override> with_substeps(int substeps)
{
    return {{"physics.substeps", std::to_string(substeps)}};
}

TrialRunner make_runner_of(const Place &place)
{
    return make_runner(place.stepper, place.object, load_setup(speed_setup, with_substeps(place.substeps)));
}

// All timings, in the order in which the file has them.
class Plan
{
  public:
    explicit Plan(const Options &options)
        : options_(options), sets_(random_parameters("cpg-c", options.sets, options.seed))
    {
        for (const char *object : objects)
            for (const int substeps : {2, 3, 5, 10, 20, 50, 100})
                add_trials({"substeps", sim::Stepper::fast, object, substeps});
        for (const char *object : objects)
            for (const int substeps : {5, 10, 20, 50})
                add_trials({"substeps", sim::Stepper::reference, object, substeps});
        for (const char *object : objects)
            for (const int fingers : {0, 1, 2})
                add_press(object, fingers);
        for (const std::string &object : sim::object_names(models_dir))
            add_trials({"objects", sim::Stepper::fast, object});
        for (const char *object : objects)
            for (const unsigned workers : worker_counts())
                add_workers(object, workers);
    }

    // The repeats go through all timings in turn, so that what disturbs the machine for a while does not fall on one of
    // them.
    std::vector<Timing> run()
    {
        for (int repeat = 1; repeat <= options_.repeats; ++repeat) {
            std::fprintf(stderr, "bench_growth: repeat %d of %d\n", repeat, options_.repeats);
            for (Timing &timing : timings_)
                timing.steps_per_s.push_back(timing.measure_steps_per_s());
        }
        return timings_;
    }

  private:
    // 1, 2, 4, ... and the number of cores; 1 and 2 on one core.
    static std::vector<unsigned> worker_counts()
    {
        const unsigned cores = std::max(2U, std::thread::hardware_concurrency());
        std::vector<unsigned> counts;
        for (unsigned count = 1; count < cores; count *= 2)
            counts.push_back(count);
        counts.push_back(cores);
        return counts;
    }

    void add_trials(const Place &place)
    {
        const auto runner = std::make_shared<TrialRunner>(make_runner_of(place));
        timings_.push_back(
            {place, [this, runner] { return trials_steps_per_s(*runner, sets_, options_.seconds); }, {}});
    }

    void add_press(const std::string &object, int fingers)
    {
        Place place{"fingers", sim::Stepper::fast, object};
        place.fingers = std::to_string(fingers);
        const auto press = std::make_shared<Press>(object, fingers, with_substeps(place.substeps), options_.seed);
        std::fprintf(stderr, "bench_growth: %s, fingers in contact %d: %zu of %zu postures count\n", object.c_str(),
                     fingers, press->counted(), press->tried());
        timings_.push_back({place, [this, press] { return press->steps_per_s(options_.seconds); }, {}});
    }

    void add_workers(const std::string &object, unsigned workers)
    {
        Place place{"workers", sim::Stepper::fast, object};
        place.workers = workers;
        const auto runners = std::make_shared<std::vector<TrialRunner>>();
        for (unsigned w = 0; w < workers; ++w)
            runners->push_back(make_runner_of(place));
        timings_.push_back(
            {place, [this, runners] { return workers_steps_per_s(*runners, sets_, options_.seconds); }, {}});
    }

    const Options options_;
    const std::vector<Parameters> sets_;
    std::vector<Timing> timings_;
};

std::vector<std::string> comments(const Options &options)
{
    return {
        "Cost of the full loop (controller, torques at every substep, world) as the work grows. Set-up paper-negated.",
        "control_steps_per_s: control steps of 10 ms a second, all workers together. ratio_to_one_worker: of the same "
        "repeat.",
        "peak_resident_mb: of a process that does one training of " + std::to_string(options.memory_trials) +
            " trials of CPG-H. further_worker_mb: what each more world and controller in a process adds.",
        "series substeps, objects, workers: " + std::to_string(options.sets) +
            " random CPG-C parameter vectors, seed " + std::to_string(options.seed) +
            ". series fingers: 20 random postures in which so many fingers rest against the object; 0: it is out of "
            "reach.",
        "One core a worker; medians, least and most of " + std::to_string(options.repeats) +
            " repeats that go through all timings in turn, each of at least " + record::number_text(options.seconds) +
            " s.",
        std::to_string(std::thread::hardware_concurrency()) + " cores; " + record::compiler() + "; Bullet " +
            record::bullet_version(),
        record::version_line(),
    };
}

class Table
{
  public:
    explicit Table(const Options &options) : file_(options.file)
    {
        for (const std::string &comment : comments(options))
            file_.write("# " + comment + "\n");
        write_cells({"series", "stepper", "object", "substeps", "fingers", "workers", "quantity", "median", "least",
                     "most", "repeats"});
    }

    void write(const Place &place, const std::string &quantity, const std::vector<double> &found)
    {
        const auto [least, most] = std::minmax_element(found.begin(), found.end());
        write_cells({place.series, name_of(place.stepper), place.object, std::to_string(place.substeps), place.fingers,
                     std::to_string(place.workers), quantity, rounded(median(found)), rounded(*least), rounded(*most),
                     std::to_string(found.size())});
    }

    void finish()
    {
        file_.finish();
    }

  private:
    // Four digits: more than a repeat keeps.
    static std::string rounded(double value)
    {
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "%.4g", value);
        return record::number_text(std::stod(text.data()));
    }

    void write_cells(const std::vector<std::string> &cells)
    {
        file_.write(record::csv_header(cells) + "\n");
    }

    record::PartFile file_;
};

// Each repeat of `timing` against the one of the same object with one worker.
std::vector<double> ratios_to_one_worker(const std::vector<Timing> &timings, const Timing &timing)
{
    const auto one = std::find_if(timings.begin(), timings.end(), [&](const Timing &other) {
        return other.place.series == "workers" && other.place.workers == 1 && other.place.object == timing.place.object;
    });
    std::vector<double> ratios;
    for (std::size_t repeat = 0; repeat < timing.steps_per_s.size(); ++repeat)
        ratios.push_back(timing.steps_per_s[repeat] / one->steps_per_s[repeat]);
    return ratios;
}

void run(const Options &options)
{
    Table table(options);
    for (const sim::Stepper stepper : {sim::Stepper::fast, sim::Stepper::reference}) {
        const Place place{"memory", stepper, "small-sphere"};
        table.write(place, "peak_resident_mb", {training_peak_mb(stepper, place.object, options.memory_trials)});
        table.write(place, "further_worker_mb", {further_worker_mb(stepper, place.object)});
    }
    Plan plan(options);
    const std::vector<Timing> timings = plan.run();
    for (const Timing &timing : timings) {
        table.write(timing.place, "control_steps_per_s", timing.steps_per_s);
        if (timing.place.series == "workers")
            table.write(timing.place, "ratio_to_one_worker", ratios_to_one_worker(timings, timing));
    }
    table.finish();
    std::printf("%s\n", options.file.c_str());
}

} // namespace

int main(int argc, char **argv)
{
    Options options;
    CLI::App app("How the cost of a control step grows with the work.", "bench_growth");
    app.add_option("file", options.file, "the CSV to write")->required();
    app.add_option("--sets", options.sets, "parameter vectors of a pass")
        ->check(CLI::Range(1, 10000))
        ->capture_default_str();
    app.add_option("--repeats", options.repeats, "of every timing")->check(CLI::Range(1, 1000))->capture_default_str();
    app.add_option("--seconds", options.seconds, "at least, of every timing")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--seed", options.seed, "of the parameter vectors")->capture_default_str();
    app.add_option("--memory-trials", options.memory_trials, "of the training whose memory is taken")
        ->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        run(options);
    } catch (const std::exception &error) {
        std::cerr << "bench_growth: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
