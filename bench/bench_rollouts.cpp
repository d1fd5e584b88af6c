// Trials of CPG-C with random parameters, for a comparison with another engine (bench_peers.py): what the hand is asked
// to do, what it did, how fast that was computed, and the mechanics of the hand as Bullet sees them. Prints CSV.
#include "work.hpp"

#include "experiment/trial.hpp"
#include "sim/articulated_hand.hpp"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <cstdio>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace twiddle;
using namespace twiddle::experiment;

struct Options {
    std::string object;
    std::string setup = bench::speed_setup;
    std::string stepper = "fast";
    int substeps = 0; // 0: the set-up's
    int sets = 200;
    std::uint32_t seed = 1;
    unsigned workers = 1;
    double seconds = 1;
};

settings::Setup load_setup(const Options &options)
{
    std::vector<settings::Override> overrides;
    if (options.substeps > 0) overrides.emplace_back("physics.substeps", std::to_string(options.substeps));
    return bench::load_setup(options.setup, overrides);
}

TrialRunner make_runner(const Options &options)
{
    return bench::make_runner(sim::stepper_of_name(options.stepper), options.object, load_setup(options));
}

void print_values(const char *separator, std::initializer_list<double> values)
{
    for (const double value : values) {
        std::printf("%s%.17g", separator, value);
        separator = ",";
    }
}

void print_joints(const char *separator, const JointVector &v)
{
    print_values(separator, {v[0], v[1], v[2], v[3]});
}

// The merged settings as one line of JSON, as run.json holds them.
void print_settings(const Options &options)
{
    std::cout << load_setup(options).settings << '\n';
}

// The desired angles, a line a control step, `trial_steps` lines a parameter vector.
void print_desired(const Options &options)
{
    const auto controller = engine::engine_of_number("float").make_controller({load_setup(options), "cpg-c", true});
    std::puts("fei_rad,aai_rad,fet_rad,ot_rad");
    for (const engine::Parameters &set : bench::random_parameters("cpg-c", options.sets, options.seed)) {
        controller->start(set);
        for (int step = 0; step < trial_steps; ++step) {
            print_joints("", controller->torque({}, true).desired_rad);
            std::puts("");
        }
    }
}

// The object's rotation at the end of each trial, in the counted direction. Faults go to standard error.
void print_rotations(const Options &options)
{
    TrialRunner runner = make_runner(options);
    std::puts("rotation_rad");
    for (const engine::Parameters &set : bench::random_parameters("cpg-c", options.sets, options.seed)) {
        const TrialResult result = runner.run(set);
        std::printf("%.17g\n", result.rotation_rad);
        if (!result.fault.empty()) std::fprintf(stderr, "%s\n", result.fault.c_str());
    }
}

// Control steps per second of the full loop (controller, torques at every substep, and the world) of all workers, which
// are threads with a controller and a world each.
void print_speed(const Options &options)
{
    const auto sets = bench::random_parameters("cpg-c", options.sets, options.seed);
    std::vector<TrialRunner> runners;
    while (runners.size() < options.workers) {
        runners.push_back(make_runner(options));
        runners.back().run(sets.front()); // warm caches and clocks
    }
    std::printf("control_steps_per_s\n%.6g\n", bench::workers_steps_per_s(runners, sets, options.seconds));
}

// Bullet's articulated-body algorithm on the welded hand without contacts, at postures and velocities that are set.
class Mechanics
{
  public:
    Mechanics(const sim::HandModel &model, const settings::Setup &setup)
        : hand_(model, setup.hand, sim::HandHold::welded), gravity_m_s2_(sim::gravity_palm_m_s2(model, setup.physics))
    {
    }

    const sim::ArticulatedHand &hand() const
    {
        return hand_;
    }

    void set_state(const JointVector &angle_rad, const JointVector &velocity_rad_s)
    {
        std::vector<double> posture_rad(joint_count);
        for (std::size_t j = 0; j < joint_count; ++j)
            posture_rad.at(hand_.controlled()[j]) = angle_rad[j];
        hand_.set_posture(posture_rad);
        for (std::size_t j = 0; j < joint_count; ++j)
            hand_.body().setJointVel(hand_.controlled()[j], velocity_rad_s[j]);
    }

    // Accelerations under gravity without joint torques, rad/s2; also prepares response_to().
    JointVector free_acceleration_rad_s2()
    {
        btMultiBody &body = hand_.body();
        body.clearForcesAndTorques();
        for (int link = 0; link < body.getNumLinks(); ++link)
            body.addLinkForce(link, gravity_m_s2_ * body.getLinkMass(link));
        JointVector acceleration_rad_s2{};
        const auto &joints = hand_.controlled();
        for (std::size_t j = 0; j < joint_count; ++j)
            acceleration_rad_s2[j] = -body.getJointVel(joints[j]);
        // Bullet adds acceleration x time to the velocities; the time is 1 s.
        body.computeAccelerationsArticulatedBodyAlgorithmMultiDof(1, scalars_, vectors_, matrices_, false, false,
                                                                  false);
        for (std::size_t j = 0; j < joint_count; ++j)
            acceleration_rad_s2[j] += body.getJointVel(joints[j]);
        return acceleration_rad_s2;
    }

    // Accelerations under 1 N m on `joint` alone: a column of the inverse mass matrix, 1/(kg m2).
    JointVector response_to(std::size_t joint)
    {
        constexpr int base_freedoms = 6; // Bullet counts the fixed base's
        btAlignedObjectArray<btScalar> torque_nm, response;
        torque_nm.resize(base_freedoms + hand_.body().getNumDofs(), 0);
        response.resize(base_freedoms + hand_.body().getNumDofs(), 0);
        torque_nm[base_freedoms + hand_.controlled()[joint]] = 1;
        hand_.body().calcAccelerationDeltasMultiDof(&torque_nm[0], &response[0], scalars_, vectors_);
        JointVector column{};
        for (std::size_t j = 0; j < joint_count; ++j)
            column[j] = response[base_freedoms + hand_.controlled()[j]];
        return column;
    }

  private:
    sim::ArticulatedHand hand_;
    btVector3 gravity_m_s2_;
    btAlignedObjectArray<btScalar> scalars_;
    btAlignedObjectArray<btVector3> vectors_;
    btAlignedObjectArray<btMatrix3x3> matrices_;
};

// One random state of the hand a line: angles (4), velocities (4), the fingertips of index and thumb in the palm frame
// (3 + 3), free accelerations (4), and the inverse mass matrix (16), joints in the order of settings/joints.hpp.
void print_mechanics(const Options &options)
{
    const sim::HandModel model = bench::read_hand();
    Mechanics mechanics(model, load_setup(options));
    std::mt19937 random(options.seed);
    std::uniform_real_distribution<double> share(0, 1), velocity_rad_s(-10, 10);
    for (int set = 0; set < options.sets; ++set) {
        JointVector angle_rad{}, velocity{};
        for (std::size_t j = 0; j < joint_count; ++j) {
            const sim::HandLink &link = model.links[model.link_of_joint(joint_urdf_names[j])];
            angle_rad[j] = link.lower_rad + share(random) * (link.upper_rad - link.lower_rad);
            velocity[j] = velocity_rad_s(random);
        }
        mechanics.set_state(angle_rad, velocity);
        print_joints("", angle_rad);
        print_joints(",", velocity);
        for (const sim::Finger finger : {sim::Finger::index, sim::Finger::thumb}) {
            const btVector3 tip_m = mechanics.hand().p_palm_tip_m(finger);
            print_values(",", {tip_m.x(), tip_m.y(), tip_m.z()});
        }
        print_joints(",", mechanics.free_acceleration_rad_s2());
        for (std::size_t j = 0; j < joint_count; ++j)
            print_joints(",", mechanics.response_to(j));
        std::puts("");
    }
}

void add_options(CLI::App &app, Options &options)
{
    app.add_option("--object", options.object, "name in models/objects");
    app.add_option("--setup", options.setup, "name in experiments/setups, or a .toml file")->capture_default_str();
    app.add_option("--stepper", options.stepper, "who steps the world")
        ->check(CLI::IsMember(sim::stepper_names()))
        ->capture_default_str();
    app.add_option("--substeps", options.substeps, "of a control step; the set-up's if not given")
        ->check(CLI::Range(1, 1000));
    app.add_option("--sets", options.sets, "parameter vectors, or states of the hand")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    app.add_option("--seed", options.seed, "of the random numbers")->capture_default_str();
    app.add_option("--workers", options.workers, "that are timed at once")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--seconds", options.seconds, "of timing at least, in whole passes through the parameter vectors")
        ->check(CLI::Range(0.001, 3600.0))
        ->capture_default_str();
}

int run(int argc, char **argv)
{
    Options options;
    CLI::App app("Trials of CPG-C with random parameters.", "bench_rollouts");
    app.require_subcommand(1);
    app.fallthrough();
    add_options(app, options);
    const auto add = [&](const char *name, const char *text, void (*print)(const Options &)) {
        app.add_subcommand(name, text)->callback([&options, print] { print(options); });
    };
    add("settings", "the set-up's merged settings as JSON", print_settings);
    add("desired", "the desired angles of every control step", print_desired);
    add("rotations", "the object's rotation at the end of each trial", print_rotations);
    add("time", "control steps per second of the full loop", print_speed);
    add("mechanics", "tips, accelerations and inverse mass matrix in random states", print_mechanics);
    CLI11_PARSE(app, argc, argv);
    return 0;
}

} // namespace

int main(int argc, char **argv)
{
    try {
        return run(argc, argv);
    } catch (const std::exception &error) {
        std::cerr << "bench_rollouts: " << error.what() << '\n';
        return 1;
    }
}
