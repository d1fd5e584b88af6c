#include "progress.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numeric>
#include <sstream>

namespace twiddle::record
{

namespace
{

constexpr std::uint32_t bar_cells = 20;
constexpr double redraw_interval_s = 0.1;
constexpr double line_interval_s = 10; // of a sweep

std::string fixed_text(double value, int decimals)
{
    std::ostringstream text;
    text << std::fixed << std::setprecision(decimals) << value;
    return text.str();
}

// The whole number of `whole` parts that `done` of `all` are.
std::uint64_t share(std::uint64_t done, std::uint64_t all, std::uint64_t whole)
{
    return all == 0 ? whole : whole * done / all;
}

std::string bar(std::uint64_t done, std::uint64_t all)
{
    const auto filled = static_cast<std::size_t>(share(done, all, bar_cells));
    return "[" + std::string(filled, '#') + std::string(bar_cells - filled, '.') + "]";
}

std::string time_left(std::uint64_t trials_left, double trials_per_s)
{
    if (!(trials_per_s > 0)) return duration_text(-1);
    return duration_text(static_cast<double>(trials_left) / trials_per_s);
}

} // namespace

void MovingMean::add(double value)
{
    values_[count_ % window] = value;
    ++count_;
}

double MovingMean::mean() const
{
    const auto filled = static_cast<std::ptrdiff_t>(std::min<std::uint64_t>(count_, window));
    if (filled == 0) return 0;
    return std::accumulate(values_.begin(), values_.begin() + filled, 0.0) / static_cast<double>(filled);
}

std::string duration_text(double seconds)
{
    constexpr double longest_s = 1e9;
    if (!(seconds >= 0) || seconds > longest_s) return "?";
    const auto whole = static_cast<std::uint64_t>(std::llround(seconds));
    std::ostringstream text;
    text << std::setfill('0');
    if (whole >= 3600) text << whole / 3600 << ':' << std::setw(2);
    text << whole / 60 % 60 << ':' << std::setw(2) << whole % 60;
    return text.str();
}

std::string progress_bar(const ProgressState &state)
{
    return "trial " + std::to_string(state.done) + "/" + std::to_string(state.trials) + " " +
           bar(state.done, state.trials) + " reward " + fixed_text(state.reward, 2) + "  " +
           fixed_text(state.trials_per_s, 1) + " trials/s  " +
           time_left(state.trials - state.done, state.trials_per_s) + " left";
}

std::string progress_line(const ProgressState &state)
{
    return "trial " + std::to_string(state.done) + " of " + std::to_string(state.trials) + " (" +
           std::to_string(share(state.done, state.trials, 100)) + " %): reward " + fixed_text(state.reward, 3) +
           " (mean of the last " + std::to_string(std::min<std::size_t>(state.done, MovingMean::window)) + "), " +
           fixed_text(state.trials_per_s, 1) + " trials/s, " +
           time_left(state.trials - state.done, state.trials_per_s) + " left";
}

Progress::Progress(std::ostream &out, bool terminal, std::uint32_t trials, std::uint32_t already_done)
    : out_(out), terminal_(terminal), trials_(trials), first_(already_done), done_(already_done)
{
}

void Progress::recall(double reward)
{
    rewards_.add(reward);
}

void Progress::update(double reward, double elapsed_s)
{
    rewards_.add(reward);
    ++done_;
    const bool last = done_ == trials_;
    if (terminal_) {
        if (last || last_drawn_s_ < 0 || elapsed_s - last_drawn_s_ >= redraw_interval_s) draw(elapsed_s);
        if (last) end_line();
        return;
    }
    const std::uint64_t tenth = std::uint64_t{10} * done_ / trials_;
    const std::uint64_t tenth_before = std::uint64_t{10} * (done_ - 1) / trials_;
    if (tenth != tenth_before) draw(elapsed_s);
}

void Progress::end_line()
{
    if (!on_bar_) return;
    out_ << '\n' << std::flush;
    on_bar_ = false;
}

void Progress::draw(double elapsed_s)
{
    const double trials_per_s = elapsed_s > 0 ? (done_ - first_) / elapsed_s : 0;
    const ProgressState state{done_, trials_, rewards_.mean(), trials_per_s};
    if (terminal_) {
        out_ << "\r\033[K" << progress_bar(state) << std::flush; // back to the line's start, and clear it
        on_bar_ = true;
    } else {
        out_ << progress_line(state) << std::endl;
    }
    last_drawn_s_ = elapsed_s;
}

std::string sweep_bar(const SweepState &state)
{
    const std::string failed = state.failed > 0 ? "  " + std::to_string(state.failed) + " failed" : "";
    return std::to_string(state.runs_done) + "/" + std::to_string(state.runs) + " runs " +
           bar(state.trials_done, state.trials_done + state.trials_left) + failed + "  " +
           fixed_text(state.trials_per_s, 1) + " trials/s  " + time_left(state.trials_left, state.trials_per_s) +
           " left";
}

std::string sweep_line(const SweepState &state)
{
    const std::string failed = state.failed > 0 ? ", " + std::to_string(state.failed) + " failed" : "";
    return std::to_string(state.runs_done) + " of " + std::to_string(state.runs) + " runs" + failed + " (" +
           std::to_string(share(state.trials_done, state.trials_done + state.trials_left, 100)) +
           " % of the trials): " + fixed_text(state.trials_per_s, 1) + " trials/s, " +
           time_left(state.trials_left, state.trials_per_s) + " left";
}

SweepProgress::SweepProgress(std::ostream &out, bool terminal) : out_(out), terminal_(terminal)
{
}

void SweepProgress::update(const SweepState &state, double elapsed_s)
{
    const bool last = terminal_ && state.trials_left == 0; // the bar that stays
    if (!last && elapsed_s - last_drawn_s_ < (terminal_ ? redraw_interval_s : line_interval_s)) return;
    if (terminal_) {
        out_ << "\r\033[K" << sweep_bar(state) << std::flush;
        on_bar_ = true;
    } else {
        out_ << sweep_line(state) << std::endl;
    }
    last_drawn_s_ = elapsed_s;
}

void SweepProgress::end_line()
{
    if (!on_bar_) return;
    out_ << '\n' << std::flush;
    on_bar_ = false;
}

} // namespace twiddle::record
