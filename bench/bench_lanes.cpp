// Would several trials, advanced together in SIMD lanes, pay? The part of a substep that has no branches (lane_substep.hpp): as
// the library computes it, and for 1, 2, 4 and 8 lanes in several instruction sets. Items are substeps of one
// trial. Every variant advances the same random states; one that differs from the library says so instead of a time.
// Lanes wider than a register are left out: GCC 12 takes them apart, which is slower than no lanes.
//
// Compare medians: --benchmark_repetitions=15 --benchmark_enable_random_interleaving=true
// --benchmark_report_aggregates_only=true
#include "lane_substep.hpp"

#include "sim/articulated_hand.hpp"
#include "sim/fast/finger_dynamics.hpp"
#include "sim/fast/finger_kinematics.hpp"
#include "sim/fast/joint_stops.hpp"
#include "sim/fast/segment_contacts.hpp"
#include "sim/object.hpp"
#include "sim/object_body.hpp"
#include "sim/setup.hpp"
#include "sim/world.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <random>
#include <vector>

namespace
{

using namespace twiddle;
using namespace twiddle::lanes;

const std::filesystem::path models_dir = TWIDDLE_MODELS;
constexpr int state_count = 64;
constexpr double pi = 3.14159265358979324;

// The same function for each instruction set; "flatten" puts all of the above into it.
template <int lanes> using Real = typename Lane<lanes>::Real;
#define TWIDDLE_ADVANCE(name, attributes)                                                                              \
    template <int lanes>                                                                                               \
    __attribute__(attributes) void name(const std::array<Finger, 2> &fingers,                                          \
                                        const std::array<State<Real<lanes>>, 2> &states,                               \
                                        std::array<Result<Real<lanes>>, 2> &results)                                   \
    {                                                                                                                  \
        advance(fingers, states, results);                                                                             \
    }
TWIDDLE_ADVANCE(advance_default, (flatten, noinline))
#ifdef __x86_64__
TWIDDLE_ADVANCE(advance_avx2, (flatten, noinline, target("avx2")))
TWIDDLE_ADVANCE(advance_avx512, (flatten, noinline, target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")))
#endif

// The hand of the default set-up, as the library has it.
struct Hand {
    std::vector<sim::FingerDynamics> dynamics;
    std::vector<sim::FingerKinematics> kinematics;
    std::vector<sim::JointStops> stops;
    sim::RoundedCore core;
    double reach_m = 0;
    std::array<Finger, 2> fingers; // the same in constants
};

Vector<double> vector_of(const btVector3 &v)
{
    return {v.x(), v.y(), v.z()};
}

// The constants of FingerDynamics, from its answers: Fourier series, as its constructor finds them from Bullet's.
void sample_dynamics(const sim::FingerDynamics &dynamics, Finger &finger)
{
    constexpr int samples = 8;
    for (int i = 0; i < samples; i++) {
        const double u_rad = 2 * pi * i / samples;
        for (int k = 0; k < samples; k++) {
            const double v_rad = 2 * pi * k / samples;
            const auto equations =
                dynamics.equations({sim::sine_cosine(u_rad), sim::sine_cosine(v_rad)}, sim::FingerVector{});
            const sim::MassFactor &mass = equations.mass;
            const double m11 = mass.root[1] * mass.root[1], m01 = mass.coupling * m11;
            const double m00 = mass.root[0] * mass.root[0] + m01 * mass.coupling;
            const std::array<double, 5> wave = {0.5, std::cos(v_rad), std::sin(v_rad), std::cos(2 * v_rad),
                                                std::sin(2 * v_rad)};
            const std::array<double, 3> u = {0.5, std::cos(u_rad), std::sin(u_rad)};
            constexpr double share = 2.0 / samples;
            for (int h = 0; h < 5; h++) {
                finger.m00[h] += share / samples * wave[h] * m00;
                finger.m01[h] += share / samples * wave[h] * m01;
            }
            for (int j = 0; j < 2; j++)
                for (int a = 0; a < 3; a++)
                    for (int b = 0; b < 3; b++)
                        finger.weight[j][a][b] += share * share * u[a] * wave[b] * equations.resistance_nm[j];
            finger.inverse_m11 = 1 / m11;
            finger.root_m11 = mass.root[1];
            finger.inverse_root_m11 = mass.inverse_root[1];
        }
    }
}

void sample_kinematics(const sim::FingerKinematics &kinematics, const sim::RoundedCore &core, double reach_m,
                       Finger &finger)
{
    const auto frames = kinematics.frames({});
    const sim::Frame &first = frames[0], &second = frames[1];
    const auto in_first = [&](const btVector3 &v) {
        return Vector<double>{v.dot(first.x), v.dot(first.y), v.dot(first.z)};
    };
    finger.first = {vector_of(first.origin_m), vector_of(first.x), vector_of(first.y), vector_of(first.z)};
    finger.second = {in_first(second.origin_m - first.origin_m), in_first(second.x), in_first(second.y),
                     in_first(second.z)};
    for (int j = 0; j < 2; j++) {
        const sim::CarriedCapsules &capsules = kinematics.carried(j);
        Carried &carried = finger.carried[j];
        for (const btVector3 &point_m : capsules.points_m)
            carried.point_m.at(carried.points++) = vector_of(point_m);
        carried.centre_m = vector_of(capsules.centre_m);
        const double across_m = core.bounding_radius_m + capsules.radius_m + reach_m;
        carried.square_across_m2 = across_m * across_m;
        carried.along_m = core.half_height_m + core.rounding_m + capsules.radius_m + reach_m;
    }
}

Hand make_hand()
{
    const sim::Setup setup = sim::load_setup(models_dir, "mid-a");
    const sim::HandModel model = sim::read_hand_model(models_dir / "icub_right_hand.urdf");
    const sim::ObjectBody object = sim::object_body(sim::read_object(models_dir, "large-cube"), setup.object);
    sim::ArticulatedHand body(model, setup.hand, sim::HandHold::welded);
    Hand hand;
    hand.core = sim::rounded_core(object);
    hand.reach_m = setup.physics.breaking_threshold_m;
    const std::array<std::array<sim::Joint, 2>, 2> joints = {{{sim::aai, sim::fei}, {sim::ot, sim::fet}}};
    for (int f = 0; f < 2; f++) {
        const int first = body.controlled()[joints[f][0]], second = body.controlled()[joints[f][1]];
        Finger &finger = hand.fingers[f];
        for (int j = 0; j < 2; j++) {
            const auto &link = model.links[model.link_of_joint(sim::joint_urdf_names[joints[f][j]])];
            finger.lower_rad[j] = link.lower_rad;
            finger.upper_rad[j] = link.upper_rad;
        }
        hand.dynamics.emplace_back(body, first, second, sim::gravity_palm_m_s2(setup.physics));
        hand.kinematics.emplace_back(body, first, second, object.p_palm_centre_m);
        hand.stops.emplace_back(finger.lower_rad, finger.upper_rad, error_reduction, substep_s);
        sample_dynamics(hand.dynamics.back(), finger);
        sample_kinematics(hand.kinematics.back(), hand.core, hand.reach_m, finger);
    }
    return hand;
}

// A finger before the substep, one of `state_count` random ones: joints within their ranges.
using PlainState = std::array<State<double>, 2>;

std::vector<PlainState> random_states(const Hand &hand)
{
    constexpr unsigned seed = 1;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0, 1), velocity_rad_s(-10, 10), torque_nm(-0.05, 0.05);
    std::vector<PlainState> states(state_count);
    for (PlainState &state : states) {
        for (int f = 0; f < 2; f++) {
            for (int j = 0; j < 2; j++) {
                const double lower_rad = hand.fingers[f].lower_rad[j], upper_rad = hand.fingers[f].upper_rad[j];
                state[f].angle_rad[j] = lower_rad + share(random) * (upper_rad - lower_rad);
                state[f].velocity_rad_s[j] = velocity_rad_s(random);
                state[f].torque_nm[j] = torque_nm(random);
            }
        }
    }
    return states;
}

// The same by the library's functions.
void advance_by_library(const Hand &hand, const PlainState &states, std::array<Result<double>, 2> &results)
{
    for (int f = 0; f < 2; f++) {
        const State<double> &state = states[f];
        Result<double> &result = results[f];
        const std::array<sim::SineCosine, 2> angle = {sim::sine_cosine(state.angle_rad[0]),
                                                      sim::sine_cosine(state.angle_rad[1])};
        const sim::FingerEquations equations = hand.dynamics[f].equations(angle, state.velocity_rad_s);
        const sim::MassFactor &mass = equations.mass;
        sim::FingerVector impulse_nms;
        for (int j = 0; j < 2; j++)
            impulse_nms[j] = substep_s * (state.torque_nm[j] - equations.resistance_nm[j]);
        const sim::FingerVector before = mass.from_velocity(state.velocity_rad_s), change = mass.whitened(impulse_nms);
        result.coupling = mass.coupling;
        result.root = mass.root[0];
        result.inverse_root = mass.inverse_root[0];
        result.free = {before[0] + change[0], before[1] + change[1]};

        const sim::FingerKinematics &kinematics = hand.kinematics[f];
        const auto frames = kinematics.frames(angle);
        for (int j = 0; j < 2; j++) {
            const sim::CarriedCapsules &carried = kinematics.carried(j);
            const sim::Frame &frame = frames[j];
            result.frame[j] = {vector_of(frame.origin_m), vector_of(frame.x), vector_of(frame.y), vector_of(frame.z)};
            for (std::size_t i = 0; i < carried.points_m.size(); i++)
                result.point_m[j][i] = vector_of(frame.point(carried.points_m[i]));
            const sim::PolarPlace centre = kinematics.centre(j, angle);
            result.may_touch[j] =
                sim::may_touch(hand.core, centre.square_across_m2, centre.height_m, carried.radius_m + hand.reach_m);
        }
        result.velocity_rad_s = mass.velocity(result.free);
        const sim::HeldJoints passed = hand.stops[f].passed(state.angle_rad, result.velocity_rad_s);
        for (int j = 0; j < 2; j++) {
            result.at_stop[j] = passed[j] != sim::Stop::none;
            result.angle_rad[j] = state.angle_rad[j] + substep_s * result.velocity_rad_s[j];
        }
    }
}

// A structure of numbers, as plain ones and for all lanes, is an array of either. Copies lane `lane`.
template <int lanes, class Plain, class All> void copy_to_lane(const Plain &plain, int lane, All &all)
{
    for (std::size_t i = 0; i < sizeof plain / sizeof(double); i++)
        std::memcpy(reinterpret_cast<char *>(&all) + (i * lanes + lane) * sizeof(double),
                    reinterpret_cast<const char *>(&plain) + i * sizeof(double), sizeof(double));
}

template <int lanes, class Plain, class All> double largest_difference(const Plain &plain, int lane, const All &all)
{
    double largest = 0;
    for (std::size_t i = 0; i < sizeof plain / sizeof(double); i++) {
        double a, b;
        std::memcpy(&a, reinterpret_cast<const char *>(&plain) + i * sizeof a, sizeof a);
        std::memcpy(&b, reinterpret_cast<const char *>(&all) + (i * lanes + lane) * sizeof b, sizeof b);
        largest = std::max(largest, std::abs(a - b));
    }
    return largest;
}

void library(benchmark::State &state)
{
    const Hand hand = make_hand();
    const auto states = random_states(hand);
    std::array<Result<double>, 2> results{};
    while (state.KeepRunningBatch(state_count)) {
        for (const PlainState &plain : states) {
            advance_by_library(hand, plain, results);
            benchmark::DoNotOptimize(results);
        }
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(library);

using Supported = bool();
bool always()
{
    return true;
}

template <int lanes>
using Advance = void(const std::array<Finger, 2> &, const std::array<State<Real<lanes>>, 2> &,
                     std::array<Result<Real<lanes>>, 2> &);

template <int lanes, Advance<lanes> advance_lanes, Supported supported> void in_lanes(benchmark::State &state)
{
    if (!supported()) {
        state.SkipWithError("this processor has not these instructions");
        return;
    }
    const Hand hand = make_hand();
    const auto plain_states = random_states(hand);
    std::vector<std::array<State<Real<lanes>>, 2>> states(state_count / lanes);
    std::array<Result<Real<lanes>>, 2> results{};
    for (int i = 0; i < state_count; i++)
        copy_to_lane<lanes>(plain_states[i], i % lanes, states[i / lanes]);

    constexpr double tolerance = 1e-10;
    for (int i = 0; i < state_count; i++) {
        std::array<Result<double>, 2> expected{};
        advance_by_library(hand, plain_states[i], expected);
        advance_lanes(hand.fingers, states[i / lanes], results);
        if (!(largest_difference<lanes>(expected, i % lanes, results) < tolerance)) {
            state.SkipWithError("the results are not the library's");
            return;
        }
    }
    while (state.KeepRunningBatch(state_count)) {
        for (const auto &batch : states) {
            advance_lanes(hand.fingers, batch, results);
            benchmark::DoNotOptimize(results);
        }
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK_TEMPLATE(in_lanes, 1, advance_default<1>, always)->Name("default/1");
BENCHMARK_TEMPLATE(in_lanes, 2, advance_default<2>, always)->Name("default/2");

#ifdef __x86_64__
bool has_avx2()
{
    return __builtin_cpu_supports("avx2");
}
BENCHMARK_TEMPLATE(in_lanes, 1, advance_avx2<1>, has_avx2)->Name("avx2/1");
BENCHMARK_TEMPLATE(in_lanes, 2, advance_avx2<2>, has_avx2)->Name("avx2/2");
BENCHMARK_TEMPLATE(in_lanes, 4, advance_avx2<4>, has_avx2)->Name("avx2/4");

bool has_avx512()
{
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
}
BENCHMARK_TEMPLATE(in_lanes, 4, advance_avx512<4>, has_avx512)->Name("avx512/4");
BENCHMARK_TEMPLATE(in_lanes, 8, advance_avx512<8>, has_avx512)->Name("avx512/8");
#endif

} // namespace
