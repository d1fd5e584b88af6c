// progress.hpp: how far a training run or a sweep of runs is: a bar that redraws itself on a terminal, plain
// lines elsewhere.
#pragma once

#include <array>
#include <cstdint>
#include <ostream>
#include <string>

namespace twiddle::record
{

// The mean of the last `window` values.
class MovingMean
{
  public:
    static constexpr std::size_t window = 100;

    void add(double value);
    // 0 before the first value.
    double mean() const;

  private:
    std::array<double, window> values_{};
    std::uint64_t count_ = 0;
};

// What there is to say at one moment.
struct ProgressState {
    std::uint32_t done = 0;   // trials
    std::uint32_t trials = 0; // of the whole run
    double reward = 0;        // mean of the last trials
    double trials_per_s = 0;  // 0: not known yet
};

// "0:57", "12:03", "1:02:03"; "?" for what is not known (negative or not finite).
std::string duration_text(double seconds);

// One line without line end: the bar, and the same as a sentence.
std::string progress_bar(const ProgressState &state);
std::string progress_line(const ProgressState &state);

class Progress
{
  public:
    // `already_done` trials were made earlier and take no part in the speed.
    Progress(std::ostream &out, bool terminal, std::uint32_t trials, std::uint32_t already_done);

    // One more trial is done, `elapsed_s` after the start. Draws at most ten times a second, or a line every tenth.
    void update(double reward, double elapsed_s);

    // An earlier trial's reward, for the mean.
    void recall(double reward);

    // Leave the bar's line, so that other text can follow; does nothing if no bar is drawn.
    void end_line();

  private:
    void draw(double elapsed_s);

    std::ostream &out_;
    bool terminal_;
    bool on_bar_ = false;
    std::uint32_t trials_;
    std::uint32_t first_;
    std::uint32_t done_;
    double last_drawn_s_ = -1;
    MovingMean rewards_;
};

// How far a sweep is.
struct SweepState {
    std::size_t runs_done = 0;
    std::size_t runs = 0;
    std::size_t failed = 0;        // runs
    std::uint64_t trials_done = 0; // of all runs
    std::uint64_t trials_left = 0; // those of failed runs are not made any more
    double trials_per_s = 0;       // 0: not known yet
};

// As progress_bar() and progress_line().
std::string sweep_bar(const SweepState &state);
std::string sweep_line(const SweepState &state);

class SweepProgress
{
  public:
    SweepProgress(std::ostream &out, bool terminal);

    // How things are `elapsed_s` after the start. Draws at most ten times a second and at the end, or a
    // line every ten seconds.
    void update(const SweepState &state, double elapsed_s);

    // As Progress::end_line().
    void end_line();

  private:
    std::ostream &out_;
    bool terminal_;
    bool on_bar_ = false;
    double last_drawn_s_ = 0;
};

} // namespace twiddle::record
