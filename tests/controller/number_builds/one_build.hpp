// one_build.hpp: the same small run of controller and learner by each build of the C libraries, in one program.
#ifndef TWIDDLE_TESTS_ONE_BUILD_HPP
#define TWIDDLE_TESTS_ONE_BUILD_HPP

#include <vector>

// What came out, in doubles.
struct Outcome {
    std::vector<double> parameters;
    std::vector<double> desired_rad;
    std::vector<double> torques_nm;
    double reward = 0;
};

// Three trials of a two-joint hand that its learner explores; one_build.cpp, compiled once a number type.
Outcome run_float();
Outcome run_double();
Outcome run_fixed();

#endif
