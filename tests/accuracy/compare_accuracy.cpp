// compare_accuracy DOUBLE FLOAT FIXED: how far the float and the fixed build are from the double build (the three
// recorders of accuracy.h), as a table on standard output. Ends with 1 if an error is above its limit, naming it.
#include "accuracy.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

// How two values of a quantity differ.
enum class Difference { absolute, of_phases_in_rad, relative };

// A quantity of a course, so many values of it a row, and what its errors may be at most.
struct Quantity {
    std::string name;
    int values_per_row;
    Difference difference;
    double limit;
    std::optional<double> limit_of_most; // for the 99.9th percentile
};

// What the recorders run, and what comes in each row of it.
struct Course {
    std::string arguments;
    long rows;
    std::vector<Quantity> quantities;
};

// The output of a program, as doubles.
class Recording
{
  public:
    Recording(const std::string &program, const std::string &arguments) : command_("'" + program + "' " + arguments)
    {
        pipe_ = popen(command_.c_str(), "r");
        if (!pipe_) throw std::runtime_error("cannot start " + command_);
    }
    Recording(const Recording &) = delete;
    Recording &operator=(const Recording &) = delete;
    ~Recording()
    {
        if (pipe_) pclose(pipe_);
    }

    double next()
    {
        double value = 0;
        if (std::fread(&value, sizeof value, 1, pipe_) != 1) throw std::runtime_error(command_ + " ended too early");
        return value;
    }

    // Everything has been read, and the program ended well.
    void close()
    {
        const bool more = std::fgetc(pipe_) != EOF;
        const int status = pclose(pipe_);
        pipe_ = nullptr;
        if (more) throw std::runtime_error(command_ + " wrote more than expected");
        if (status != 0) throw std::runtime_error(command_ + " failed");
    }

  private:
    std::string command_;
    FILE *pipe_ = nullptr;
};

double error_of(Difference difference, double value, double reference)
{
    constexpr double turn_rad = 6.283185307179586;
    const double signed_error = value - reference;
    if (difference == Difference::of_phases_in_rad)
        return turn_rad * std::fabs(signed_error - std::round(signed_error)); // the turn wraps around
    if (difference == Difference::relative) return std::fabs(signed_error / reference);
    return std::fabs(signed_error);
}

// The errors of each quantity of `course`.
std::vector<std::vector<double>> errors_of(const Course &course, const std::string &program,
                                           const std::string &reference)
{
    Recording recording(program, course.arguments);
    Recording expected(reference, course.arguments);
    std::vector<std::vector<double>> errors(course.quantities.size());
    for (long row = 0; row < course.rows; ++row) {
        for (std::size_t q = 0; q < course.quantities.size(); ++q) {
            for (int k = 0; k < course.quantities[q].values_per_row; ++k) {
                const double error = error_of(course.quantities[q].difference, recording.next(), expected.next());
                // What is no number is further off than everything that is.
                errors[q].push_back(std::isfinite(error) ? error : std::numeric_limits<double>::infinity());
            }
        }
    }
    recording.close();
    expected.close();
    return errors;
}

// The largest error, and the 99.9th percentile.
struct Errors {
    double largest;
    double most;
};

Errors summary(std::vector<double> errors)
{
    const auto rank = static_cast<std::ptrdiff_t>(0.999 * static_cast<double>(errors.size()));
    std::nth_element(errors.begin(), errors.begin() + rank, errors.end());
    return {*std::max_element(errors.begin(), errors.end()), errors[static_cast<std::size_t>(rank)]};
}

Course trials(bool with_centre, int tick_ms)
{
    const std::string where =
        std::string(with_centre ? ", centres" : ", no centres") + (tick_ms == 10 ? ", 10 ms" : ", 1 ms");
    // A joint's output that is 1e-4 of the largest range off changes the torque by as much as its stiffness makes of
    // that.
    constexpr double largest_range_rad = 2.27;
    constexpr double stiffness_nm_per_rad = 0.3125;
    const Difference absolute = Difference::absolute;
    return {"trials " + std::to_string(int(with_centre)) + " " + std::to_string(tick_ms),
            long{ACCURACY_SETS} * ACCURACY_TICKS,
            {{"oscillator output" + where, ACCURACY_OSCILLATORS, absolute, 1e-4, 3e-5},
             {"joint output" + where, ACCURACY_JOINTS, absolute, 1e-4, 3e-5},
             {"torque" + where, ACCURACY_JOINTS, absolute, 1e-4 * largest_range_rad * stiffness_nm_per_rad, {}},
             {"phase" + where, ACCURACY_OSCILLATORS, Difference::of_phases_in_rad, 1e-4, {}}}};
}

std::vector<Course> all_courses()
{
    std::vector<Course> courses = {trials(true, 10), trials(false, 10), trials(true, 1), trials(false, 1)};
    courses.push_back({"sigmoid", 2L * SIGMOID_STEPS + 1, {{"sigmoid", 1, Difference::absolute, 5e-6, {}}}});
    courses.push_back(
        // What phase.h promises of the fixed build.
        {"sine",
         SINE_STEPS,
         {{"sine alone", 1, Difference::absolute, 4e-6, {}}, {"sine and cosine", 2, Difference::absolute, 4e-6, {}}}});
    courses.push_back({"learning",
                       LEARNING_SEEDS,
                       {{"reward of the learned policy", 1, Difference::relative, 0.01, {}},
                        {"mean reward of the last trials", 1, Difference::relative, 0.01, {}}}});
    return courses;
}

// Print one line of the table; whether all limits are kept.
bool report(const Quantity &quantity, const std::vector<Errors> &builds)
{
    std::printf("%-40s", quantity.name.c_str());
    bool kept = true;
    for (const Errors &errors : builds) {
        std::printf("  %8.1e %8.1e", errors.largest, errors.most);
        kept =
            kept && errors.largest <= quantity.limit && errors.most <= quantity.limit_of_most.value_or(quantity.limit);
    }
    std::printf("  %8.1e", quantity.limit);
    if (quantity.limit_of_most) std::printf(" %8.1e", *quantity.limit_of_most);
    std::printf("%s\n", kept ? "" : "  ABOVE ITS LIMIT");
    return kept;
}

} // namespace

int main(int argc, char **argv)
{
    if (argc != 4) {
        std::fprintf(stderr, "usage: compare_accuracy DOUBLE FLOAT FIXED\n");
        return 2;
    }
    try {
        std::printf("Errors against the double build, the largest and the 99.9th percentile.\n"
                    "Outputs: of the joint's range; torques: N m; phases: rad; rewards: relative.\n\n");
        std::printf("%-40s  %17s  %17s  %17s\n", "", "fixed", "float", "limit");
        bool kept = true;
        for (const Course &course : all_courses()) {
            const auto fixed = errors_of(course, argv[3], argv[1]);
            const auto single = errors_of(course, argv[2], argv[1]);
            for (std::size_t q = 0; q < course.quantities.size(); ++q)
                kept = report(course.quantities[q], {summary(fixed[q]), summary(single[q])}) && kept;
        }
        return kept ? 0 : 1;
    } catch (const std::exception &error) {
        std::fprintf(stderr, "compare_accuracy: %s\n", error.what());
        return 1;
    }
}
